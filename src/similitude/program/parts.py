"""Which runs of statements of a step are printed as C functions of their own, and what they take.

A compiler that sees a long straight step keeps what it has stored to use it again, far away: on a small part
that fills the stack and is fetched from there instead of from where it was stored. A function is a border
for this.

Invariant: a part gives back nothing but what it writes into the state, so the step does the same operations
in the same order with and without it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from similitude.errors import ProgramError
from similitude.program.ir import Assign, Program, Statement, When, walk


@dataclass(frozen=True)
class Part:
    """One function: its statements, the structs it is handed, and the working values it takes in order."""

    name: str
    body: tuple[Assign, ...]
    structs: tuple[str, ...]
    arguments: tuple[str, ...]


def as_part(name: str, lines: Iterable[Assign]) -> list[Assign]:
    """The statements, marked as one part of the step."""
    return [replace(line, part=name) for line in lines]


def runs(body: Sequence[Statement]) -> list[tuple[str, list[Statement]]]:
    """A body cut where a part begins or ends: (name of the part or "", its statements)."""
    groups = groupby(body, key=lambda s: s.part if isinstance(s, Assign) else "")
    return [(name, list(lines)) for name, lines in groups]


def parts_of(program: Program) -> dict[str, Part]:
    """Every part of a program's step by its name.

    Raises
    ------
    ProgramError    a part is in two places, or something outside needs what it alone works out.
    """
    found: dict[str, Part] = {}
    for body in _bodies(program.step):
        for name, lines in runs(body):
            if name and name in found:
                raise _no_part(name, "stands in two places", f"as_part('{name}_again', ...)")
            if name:
                found[name] = _part(program, name, tuple(lines))
    return found


def _bodies(body: tuple[Statement, ...]) -> list[tuple[Statement, ...]]:
    inner = [way for s in body if isinstance(s, When) for way in (s.body, s.otherwise)]
    return [body, *(below for way in inner for below in _bodies(way))]


def _part(program: Program, name: str, body: tuple[Assign, ...]) -> Part:
    names = {
        kind: {s.name for f in getattr(program, kind) for s in f.symbols}
        for kind in ("config", "state", "sample")
    }
    places = set().union(*names.values())
    assigned: set[str] = set()
    arguments: dict[str, None] = {}
    for line in body:
        free = sorted(s.name for s in line.expression.free_symbols)
        arguments |= dict.fromkeys(n for n in free if n not in assigned | places)
        assigned.add(line.target)
    touched = assigned | {s.name for line in body for s in line.expression.free_symbols}
    inside = set(map(id, body))
    outside = [s for s in walk(program.step) if id(s) not in inside]
    own = {  # what other parts work out for themselves, by their name
        s.part: {line.target for line in outside if isinstance(line, Assign) and line.part == s.part}
        for s in outside
        if isinstance(s, Assign) and s.part
    }
    read = {
        s.name
        for node in outside
        for s in (node.condition if isinstance(node, When) else node.expression).free_symbols
        if isinstance(node, When) or s.name not in own.get(node.part, ())
    }
    variables = {s.name for f in (*program.variables, *program.output) for s in f.symbols}
    lost = sorted((assigned - names["state"]) & (read | variables))
    if lost:
        raise _no_part(
            name, f"works out {', '.join(lost)}, which is needed outside", "as_part(name, lines[1:])"
        )
    structs = tuple(kind for kind in names if touched & names[kind])
    return Part(name, body, structs, tuple(arguments))


def _no_part(name: str, why: str, instead: str) -> ProgramError:
    return ProgramError(
        f"the part {name!r} of a step {why}",
        usually="A part hands back nothing but what it writes into the state.",
        paste=f"{instead}   # statements that hand back nothing else",
        read="docs/architecture.md, 'Step programs'",
    )
