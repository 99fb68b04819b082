"""Prints a fixed-point step as one C99 file with the parts that the float profile has.

Invariant: 64-bit values are made by casts in front of the operation that needs them; nothing is unsigned
but the lower half of a product. A right shift of a negative value must keep its sign, which is checked when
compiled.
"""

from __future__ import annotations

from collections.abc import Iterable

from similitude.program.c import loops
from similitude.program.fixed import integer as it
from similitude.program.fixed.c_functions import FUNCTIONS, NEEDS
from similitude.program.fixed.layout import halves, resolution, words
from similitude.program.fixed.lower import FixedProgram, Held, If, Put
from similitude.program.fixed.operations import operations, used

_HEAD = """\
/* {title}, in fixed point. Generated from its model by similitude; do not edit.
 *
{provenance}
 *
 * Operations: step {most} at most, {least} at least (arithmetic, comparisons, selects), init 0.
 * Memory: state {state} words of 32 bits; no heap, no globals, no libm, C99. No value can wrap.
 */

#include <stdint.h>

#ifndef SIMILITUDE_API
#if defined(__GNUC__)
#define SIMILITUDE_API __attribute__((visibility("default")))
#else
#define SIMILITUDE_API
#endif
#endif
#ifndef SIMILITUDE_INLINE
#if defined(__GNUC__)
#define SIMILITUDE_INLINE static inline __attribute__((always_inline))
#else
#define SIMILITUDE_INLINE static inline
#endif
#endif

typedef int32_t {name}_real;
"""

_ALWAYS = """\
typedef char {name}_shifts_keep_the_sign[((-1) >> 1) == -1 ? 1 : -1];

"""


def print_fixed_c(fixed: FixedProgram) -> str:
    """The whole C file of a fixed-point step.

    Returns
    -------
    str    source text, ASCII, ending in a newline.
    """
    program, name = fixed.program, fixed.name
    status = ",\n".join(f"    {name.upper()}_{k.upper()} = {c}" for k, c in program.status.items())
    head = _HEAD.format(
        title=program.title,
        name=name,
        provenance="\n".join(f" *   {line}" for line in program.provenance),
        most=operations(fixed.step, most=True),
        least=operations(fixed.step, most=False),
        state=len(words(fixed)),
    )
    kinds = used(fixed.step) | {"limit"}
    wanted = kinds | {more for kind in kinds for more in NEEDS.get(kind, ())}
    wanted |= {"up"} if "_up(" in "".join(_body(fixed, fixed.step, 1)) else set()
    wanted |= {"halves"} if any(f.format.wide for f in fixed.state) else set()
    helpers = "\n".join(text.format(name=name) for kind, text in FUNCTIONS.items() if kind in wanted)
    structs = [
        _struct(name, "config", ["int32_t numbers;"], ["[-] which numbers the estimator was made for"]),
        _struct(name, "state", *_lines(halves(fixed.state))),
        _struct(name, "sample", *_lines(fixed.sample)),
        _struct(name, "output", *_lines(fixed.output)),
    ]
    parts = [head, f"enum {name}_status {{\n{status}\n}};\n", *structs, _init(fixed)]
    bodies = [_ALWAYS.format(name=name) + helpers, _advance(fixed), loops(name, reports=False)]
    return "\n".join([*parts, *bodies])


def _struct(name: str, kind: str, declared: list[str], comments: list[str]) -> str:
    rows = [f"    {d:<48} /* {c} */" for d, c in zip(declared, comments, strict=True)]
    return "\n".join([f"typedef struct {name}_{kind} {{", *rows, f"}} {name}_{kind};\n"])


def _lines(fields: Iterable[Held]) -> tuple[list[str], list[str]]:
    fields = list(fields)
    return [f"int32_t {f.name};" for f in fields], [
        f"[{f.unit}] {resolution(f)}; {f.meaning}" for f in fields
    ]


def _init(fixed: FixedProgram) -> str:
    name = fixed.name
    values = words(fixed)
    return "\n".join(
        [
            "/* The state before the first sample: the prior. */",
            f"SIMILITUDE_API void {name}_init(const {name}_config *config, {name}_state *state)",
            "{",
            "    (void)config;",
            *(f"    state->{field} = {_number(value, False)};" for field, value in values.items()),
            "}\n",
        ]
    )


def _advance(fixed: FixedProgram) -> str:
    name = fixed.name
    rows = [f"    const int32_t {f.name} = sample->{f.name};" for f in fixed.sample]
    for f in fixed.state:
        if f.format.wide:
            both = f"state->{f.name}_high, state->{f.name}_low"
            rows.append(f"    int64_t {f.name} = {name}_join({both});")
        else:
            rows.append(f"    int32_t {f.name} = state->{f.name};")
    rows += [f"    {_kind(f.wide)} {n} = 0;" for n, f in sorted(fixed.working.items())]
    stores = []
    for f in fixed.state:
        if f.format.wide:
            stores.append(f"    state->{f.name}_high = {name}_upper({f.name} + INT64_C(2147483648));")
            rest = f"{f.name} - {name}_join(state->{f.name}_high, 0)"
            stores.append(f"    state->{f.name}_low = (int32_t)({rest});")
        else:
            stores.append(f"    state->{f.name} = {f.name};")
    return "\n".join(
        [
            "/* What the step and the batch loop do with one sample. */",
            f"SIMILITUDE_INLINE int {name}_advance(const {name}_config *config, {name}_state *state,",
            f"                                     const {name}_sample *sample, {name}_output *output)",
            "{",
            *rows,
            "",
            "    (void)config;",
            *_body(fixed, fixed.step, 1),
            "",
            *stores,
            *(f"    output->{f.name} = {f.name};" for f in fixed.output),
            "    return (int)status;",
            "}\n",
        ]
    )


def _kind(wide: bool) -> str:
    return "int64_t" if wide else "int32_t"


def _body(fixed: FixedProgram, body: Iterable[Put | If], depth: int) -> list[str]:
    pad, lines = "    " * depth, []
    for s in body:
        comment = f" /* {s.comment} */" if s.comment else ""
        if isinstance(s, If):
            lines.append(f"{pad}if ({_condition(s.condition, fixed.name)}) {{{comment}")
            lines += _body(fixed, s.body, depth + 1)
            lines += [f"{pad}}} else {{", *_body(fixed, s.otherwise, depth + 1)] if s.otherwise else []
            lines.append(f"{pad}}}")
            continue
        kept = fixed.temporaries.get(s.target) if s.new else None
        wide = (kept or _format(fixed, s.target)).wide
        text, is_wide = _text(s.node, fixed.name)
        if is_wide and not wide:
            text = f"(int32_t){text}"
        declared = f"const {_kind(wide)} " if s.new else ""
        lines.append(f"{pad}{declared}{s.target} = {text};{comment}")
    return lines


def _format(fixed: FixedProgram, target: str):
    held = {f.name: f.format for f in fixed.state}
    return held.get(target) or fixed.working[target]


def _number(value: int, wide: bool) -> str:
    size = 64 if wide or not it.const(value).is_narrow else 32
    if value == -(2**31):
        return "(-INT32_C(2147483647) - 1)" if size == 32 else "(-INT64_C(2147483648))"
    return f"INT{size}_C({value})" if value >= 0 else f"(-INT{size}_C({-value}))"


def _text(node: it.Int, name: str) -> tuple[str, bool]:
    """The node as C, and whether its type has 64 bits."""
    kind, args = node.kind, node.args
    if kind == "const":
        return _number(node.lo, False), not node.is_narrow
    if kind == "name":
        return args[0], args[1]
    if kind in ("add", "sub"):
        (a, a_wide), (b, b_wide) = _text(args[0], name), _text(args[1], name)
        wide = a_wide or b_wide or not node.is_narrow
        sign = "+" if kind == "add" else "-"
        return f"({_wide(a, a_wide) if wide else a} {sign} {b})", wide
    if kind == "mul":
        a, b = _narrow(args[0], name), _narrow(args[1], name)
        return (f"({a} * {b})", False) if node.is_narrow else (f"((int64_t){a} * {b})", True)
    if kind == "mulx":
        (a, a_wide), (b, b_wide) = _text(args[0], name), _text(args[1], name)
        return f"({_wide(a, a_wide)} * {_wide(b, b_wide)})", True
    if kind in ("shl", "shr", "neg"):
        return _unary(node, name)
    if kind == "choose":
        (a, a_wide), (b, b_wide) = _text(args[1], name), _text(args[2], name)
        wide = a_wide or b_wide
        a, b = (_wide(a, a_wide), _wide(b, b_wide)) if wide else (a, b)
        return f"(({_condition(args[0], name)}) ? {a} : {b})", wide
    return _call(node, name)


def _unary(node: it.Int, name: str) -> tuple[str, bool]:
    a, was = _text(node.args[0], name)
    wide = was
    if node.kind == "neg":
        wide = wide or not node.is_narrow
        return f"(-{_wide(a, was)})" if wide else f"(-{a})", wide
    n = node.args[1]
    if node.kind == "shl":
        wide = wide or not node.is_narrow
        if was:
            return f"{name}_up({a}, {n})", True
        return f"({_wide(a, was) if wide else a} * {_number(1 << n, wide)})", wide
    half = 1 << (n - 1)
    wide = wide or node.args[0].hi + half > it.NARROW[1] or n > 31
    return f"(({_wide(a, was) if wide else a} + {_number(half, wide)}) >> {n})", wide


def _call(node: it.Int, name: str) -> tuple[str, bool]:
    args = node.args
    if node.kind == "clamp":
        a, is_wide = _text(args[0], name)
        if not is_wide:
            low, high = max(args[1], it.NARROW[0]), min(args[2], it.NARROW[1])
            return f"{name}_limit({a}, {_number(low, False)}, {_number(high, False)})", False
        narrow = it.NARROW[0] <= args[1] and args[2] <= it.NARROW[1]
        if not narrow and node.is_narrow:
            low, high = max(args[1], it.NARROW[0]), min(args[2], it.NARROW[1])
            return f"{name}_clamp({a}, {_number(low, False)}, {_number(high, False)})", False
        function = f"{name}_clamp" if narrow else f"{name}_clamp_wide"
        return f"{function}({a}, {_number(args[1], not narrow)}, {_number(args[2], not narrow)})", not narrow
    if node.kind == "mulq":
        return f"{name}_mulq({_narrow(args[0], name)}, {_narrow(args[1], name)})", False
    if node.kind == "mulw":
        return f"{name}_mulw({_text(args[0], name)[0]}, {_narrow(args[1], name)})", True
    if node.kind == "mulh":
        return f"{name}_mulh({_text(args[0], name)[0]}, {_text(args[1], name)[0]})", True
    n, d, up, lo, hi = args
    low, high = _number(lo, False), _number(hi, False)
    return f"{name}_quotient({_text(n, name)[0]}, {_text(d, name)[0]}, {up}, {low}, {high})", False


def _wide(text: str, wide: bool) -> str:
    return text if wide else f"(int64_t){text}"


def _narrow(node: it.Int, name: str) -> str:
    text, wide = _text(node, name)
    return f"(int32_t){text}" if wide else text


def _condition(c: it.Cond, name: str) -> str:
    if c.kind in ("and", "or"):
        sign = " && " if c.kind == "and" else " || "
        return sign.join(f"({_condition(part, name)})" for part in c.args)
    if c.kind == "not":
        return f"!({_condition(c.args[0], name)})"
    (a, a_wide), (b, b_wide) = (_text(part, name) for part in c.args)
    if a_wide != b_wide:
        a, b = _wide(a, a_wide), _wide(b, b_wide)
    return f"{a} {'<' if c.kind == 'lt' else '<='} {b}"
