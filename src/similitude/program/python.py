"""Prints a step program as its scalar Python twin: the readable reference and the slow fallback.

Invariant: the same statements in the same order as the C, on Python floats; the structs are flat
lists of reals in the order of the C structs.
"""

from __future__ import annotations

from collections.abc import Iterable

from similitude.program.c import names_read, names_written, operations
from similitude.program.ir import Field, Program, Statement, When, without_unread
from similitude.program.text import PYTHON, expression_text

_HEAD = '''\
"""{title}: layout and scalar twin. Generated from its model by similitude; do not edit.

{provenance}

The twin does the operations of the C file in the same order, about a hundred times slower.
"""

NAME = {name!r}
OPERATIONS = {operations}
STATUS = {status!r}
COORDINATES = {coordinates!r}
REPORTS = {reports!r}  # outputs are worked out when they are asked for, by a function of their own
'''


def print_python(program: Program) -> str:
    """The whole Python module of a step program: layout tables, ``init`` and ``step``."""
    program = without_unread(program)
    parts = [
        _HEAD.format(
            title=program.title,
            provenance="\n".join(program.provenance),
            name=program.name,
            operations=operations((*program.step, *program.report), most=True),
            status=program.status,
            coordinates=program.coordinates,
            reports=bool(program.report),
        )
    ]
    for kind in ("config", "state", "sample", "output"):
        rows = [f"    ({f.name!r}, {f.unit!r}, {f.meaning!r}, {f.size})," for f in getattr(program, kind)]
        parts.append("\n".join([f"{kind.upper()} = (", *rows, ")\n"]))
    return "\n".join([*parts, "", _init(program), "", _step(program)])


def _loads(fields: Iterable[Field], used: set[str], source: str) -> list[str]:
    symbols = [s.name for f in fields for s in f.symbols]
    return [f"    {name} = {source}[{i}]" for i, name in enumerate(symbols) if name in used]


def _body(body: Iterable[Statement], depth: int) -> list[str]:
    pad = "    " * depth
    lines = []
    for s in body:
        if isinstance(s, When):
            comment = f"  # {s.comment}" if s.comment else ""
            lines.append(f"{pad}if {expression_text(s.condition, PYTHON)}:{comment}")
            lines += _body(s.body, depth + 1) or [f"{pad}    pass"]
            if s.otherwise:
                lines += [f"{pad}else:", *_body(s.otherwise, depth + 1)]
        else:
            comment = f"  # {s.comment}" if s.comment else ""
            lines.append(f"{pad}{s.target} = {expression_text(s.expression, PYTHON)}{comment}")
    return lines


def _init(program: Program) -> str:
    names = [s.name for f in program.state for s in f.symbols]
    return "\n".join(
        [
            "def init(config):",
            '    """The flat state before the first sample, from the flat configuration."""',
            *_loads(program.config, names_read(program.init), "config"),
            *_body(program.init, 1),
            f"    return [{', '.join(names)}]",
            "",
        ]
    )


def _step(program: Program) -> str:
    body = (*program.step, *program.report)
    read, written = names_read(body), names_written(body)
    states = [s.name for f in program.state for s in f.symbols]
    outputs = [s.name for f in program.output for s in f.symbols]
    working = sorted(({f.name for f in program.variables} | set(outputs)) & written)
    return "\n".join(
        [
            "def step(config, state, sample):",
            '    """One sample on the flat state, changed in place; returns (status, flat output)."""',
            *_loads(program.config, read, "config"),
            *_loads(program.sample, read, "sample"),
            *_loads(program.state, read | written | set(states), "state"),
            *[f"    {name} = 0.0" for name in working],
            *_body(body, 1),
            f"    state[:] = [{', '.join(states)}]",
            f"    return int(status), [{', '.join(outputs)}]",
            "",
        ]
    )
