"""Prints a fixed-point step as its Python twin, on whole numbers that cannot overflow.

Invariant: the same statements in the same order as the C; the structs are flat lists of 32-bit words.
"""

from __future__ import annotations

from collections.abc import Iterable

from similitude.program.fixed import integer as it
from similitude.program.fixed.layout import halves, resolution, words
from similitude.program.fixed.lower import FixedProgram, Held, If, Put
from similitude.program.fixed.operations import operations

_HEAD = '''\
"""{title}, in fixed point: layout and twin. Generated from its model by similitude; do not edit.

{provenance}

A field stands for value = word 2^-fraction; -2^31 in a sample is a value that is not there.
"""

NAME = {name!r}
OPERATIONS = {operations}
STATUS = {status!r}
COORDINATES = ()
REPORTS = False
'''
_TAIL = '''\


def _clamp(x, lo, hi):
    return lo if x < lo else hi if x > hi else x


def _mulq(a, b):
    return a * b >> 32


def _mulw(a, b):
    return (a >> 32) * b + 2 * (((a & 0xFFFFFFFF) >> 1) * b >> 32)


def _mulh(a, b):
    return _mulw(a, b >> 32) + 2 * (((b & 0xFFFFFFFF) >> 1) * (a >> 32) >> 32)


def _leading(x):
    bits = x.bit_length()
    return x << 31 - bits if bits <= 31 else x >> bits - 31, bits


def _quotient(n, d, up, lo, hi):
    under, below = _leading(max(d, 1))
    over, above = _leading(abs(n))
    first = (0x7FFFFFFF // (under >> 15)) << 15
    miss = 0x20000000 - (under * first >> 32)
    ratio = over * (first + (first * miss * 8 >> 32)) >> 32
    shift = 29 - (above - below + up)
    if n == 0 or shift > 31:
        found = 0
    elif shift < -2:
        found = 0x7FFFFFFF
    else:
        found = ratio << -shift if shift <= 0 else ratio + (1 << shift - 1) >> shift
    found = min(found, 0x7FFFFFFF)
    return _clamp(-found if n < 0 else found, lo, hi)


def init(config):
    """The flat state before the first sample."""
    return {start!r}
'''


def print_fixed_python(fixed: FixedProgram) -> str:
    """The whole Python module of a fixed-point step: layout tables, formats, ``init`` and ``step``."""
    program = fixed.program
    parts = [
        _HEAD.format(
            title=program.title,
            provenance="\n".join(program.provenance),
            name=fixed.name,
            operations=operations(fixed.step, most=True),
            status=program.status,
        )
    ]
    kinds = {"STATE": halves(fixed.state), "SAMPLE": fixed.sample, "OUTPUT": fixed.output}
    parts.append('CONFIG = (("numbers", "-", "which numbers the estimator was made for", 1),)\n')
    for kind, fields in kinds.items():
        rows = [f"    ({f.name!r}, {f.unit!r}, {_meaning(f)!r}, 1)," for f in fields]
        parts.append("\n".join([f"{kind} = (", *rows, ")\n"]))
        parts.append(f"{kind}_FRACTIONS = {tuple(f.format.fraction for f in fields)!r}\n")
    parts.append(_TAIL.format(start=list(words(fixed).values())))
    return "\n".join([*parts, "", _step(fixed)])


def _meaning(f: Held) -> str:
    return f"{f.meaning} ({resolution(f)})"


def _step(fixed: FixedProgram) -> str:
    rows = [f"    {f.name} = sample[{i}]" for i, f in enumerate(fixed.sample)]
    place, stored = 0, []
    for f in fixed.state:
        if f.format.wide:
            rows.append(f"    {f.name} = (state[{place}] << 32) + state[{place + 1}]")
            stored += [
                f"({f.name} + 0x80000000) >> 32",
                f"(({f.name} + 0x80000000) & 0xFFFFFFFF) - 0x80000000",
            ]
        else:
            rows.append(f"    {f.name} = state[{place}]")
            stored.append(f.name)
        place += 2 if f.format.wide else 1
    return "\n".join(
        [
            "def step(config, state, sample):",
            '    """One sample on the flat state, changed in place; returns (status, flat output)."""',
            *rows,
            *(f"    {n} = 0" for n in sorted(fixed.working)),
            *_body(fixed.step, 1),
            "    state[:] = [",
            *(f"        {s}," for s in stored),
            "    ]",
            f"    return int(status), [{', '.join(f.name for f in fixed.output)}]",
            "",
        ]
    )


def _body(body: Iterable[Put | If], depth: int) -> list[str]:
    pad, lines = "    " * depth, []
    for s in body:
        comment = f"  # {s.comment}" if s.comment else ""
        if isinstance(s, If):
            lines += [f"{pad}if {_condition(s.condition)}:{comment}", *(_body(s.body, depth + 1))]
            lines += [] if s.body else [f"{pad}    pass"]
            lines += [f"{pad}else:", *_body(s.otherwise, depth + 1)] if s.otherwise else []
        else:
            lines.append(f"{pad}{s.target} = {_text(s.node)}{comment}")
    return lines


def _text(node: it.Int) -> str:
    kind, args = node.kind, node.args
    if kind == "const":
        return str(node.lo) if node.lo >= 0 else f"({node.lo})"
    if kind == "name":
        return args[0]
    if kind == "neg":
        return f"(-{_text(args[0])})"
    if kind in ("add", "sub", "mul", "mulx"):
        sign = {"add": "+", "sub": "-"}.get(kind, "*")
        return f"({_text(args[0])} {sign} {_text(args[1])})"
    if kind == "shl":
        return f"({_text(args[0])} << {args[1]})"
    if kind == "shr":
        return f"(({_text(args[0])} + {1 << (args[1] - 1)}) >> {args[1]})"
    if kind == "choose":
        return f"({_text(args[1])} if {_condition(args[0])} else {_text(args[2])})"
    shown = ", ".join(_text(a) if isinstance(a, it.Int) else str(a) for a in args)
    return f"_{kind}({shown})"


def _condition(c: it.Cond) -> str:
    if c.kind in ("and", "or"):
        return f" {c.kind} ".join(f"({_condition(part)})" for part in c.args)
    if c.kind == "not":
        return f"not ({_condition(c.args[0])})"
    return f"{_text(c.args[0])} {'<' if c.kind == 'lt' else '<='} {_text(c.args[1])}"
