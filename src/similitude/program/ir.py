"""Step programs: straight-line assignments with guards, from which C and the Python twin are printed.

Invariant: a program is a value. Its statements are SymPy expressions over declared fields and
earlier temporaries, so whatever is printed from it, in any language, does the same operations in
the same order.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import sympy as sp

from similitude.errors import ProgramError


@dataclass(frozen=True)
class Field:
    """A named real of a struct; ``size`` > 1 makes it an array whose elements are name_0, name_1, …"""

    name: str
    unit: str
    meaning: str
    size: int = 1

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols that stand for this field inside expressions, (size,)."""
        if self.size == 1:
            return (sp.Symbol(self.name, real=True),)
        return tuple(sp.Symbol(f"{self.name}_{i}", real=True) for i in range(self.size))


@dataclass(frozen=True)
class Assign:
    """``target = expression``; a target that is no field and no variable is a constant temporary."""

    target: str
    expression: sp.Expr
    comment: str = ""


@dataclass(frozen=True)
class When:
    """Run ``body`` where the condition holds, ``otherwise`` where it does not."""

    condition: sp.Basic
    body: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] = ()
    comment: str = ""


Statement = Assign | When


@dataclass(frozen=True)
class Program:
    """An estimator's ``init`` and ``step``, and the four structs they work on.

    ``config`` is read only; ``state`` is read and written; ``sample`` comes in, ``output`` goes out.
    ``variables`` are working values that outlive the guard they are assigned in.
    The step returns the variable ``status``.
    """

    name: str
    title: str
    provenance: tuple[str, ...]
    config: tuple[Field, ...]
    state: tuple[Field, ...]
    sample: tuple[Field, ...]
    output: tuple[Field, ...]
    variables: tuple[Field, ...]
    init: tuple[Statement, ...]
    step: tuple[Statement, ...]
    status: dict[str, int] = field(default_factory=dict)
    coordinates: tuple[str, ...] = ()  # what the rows of a covariance in the state are

    def __post_init__(self) -> None:
        fields = (*self.config, *self.state, *self.sample, *self.output, *self.variables)
        names = [symbol.name for f in fields for symbol in f.symbols]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ProgramError(
                f"program {self.name!r} declares {', '.join(twice)} more than once",
                usually="A state, configuration or output field shares a name with another.",
                paste="Field('steer_offset_sd', 'rad', '...')   # give each field its own name",
                read="docs/architecture.md, 'Step programs'",
            )
        read_only = {symbol.name for f in (*self.config, *self.sample) for symbol in f.symbols}
        written = {symbol.name for f in (*self.state,) for symbol in f.symbols}
        _check(self, self.init, known=read_only | set(), writable=set(names) - read_only)
        _check(self, self.step, known=read_only | written, writable=set(names) - read_only)


def _check(
    program: Program, body: Iterable[Statement], *, known: set[str], writable: set[str]
) -> set[str]:
    """Raise ProgramError where a name is read before it is assigned; return the names then known."""
    known = set(known)
    for statement in body:
        if isinstance(statement, When):
            _known_or_raise(program, statement.condition, known, "the condition of a guard")
            inside = _check(program, statement.body, known=known, writable=writable)
            other = _check(program, statement.otherwise, known=known, writable=writable)
            known |= inside & other & writable
        else:
            _known_or_raise(program, statement.expression, known, f"{statement.target!r}")
            known.add(statement.target)
    return known


def _known_or_raise(program: Program, expression: sp.Basic, known: set[str], where: str) -> None:
    unknown = sorted({s.name for s in expression.free_symbols} - known)
    if unknown:
        raise ProgramError(
            f"program {program.name!r} reads {', '.join(unknown)} in {where} before it is assigned",
            usually="A statement stands too early, or a symbol of the model has no field.",
            paste=f"Assign({unknown[0]!r}, ...)   # before its first use",
            read="docs/architecture.md, 'Step programs'",
        )


def walk(body: Iterable[Statement]) -> Iterator[Statement]:
    """Every statement of a body, guards before what they guard."""
    for statement in body:
        yield statement
        if isinstance(statement, When):
            yield from walk(statement.body)
            yield from walk(statement.otherwise)


def shared(
    prefix: str, named: dict[str, sp.Expr], comments: dict[str, str] | None = None
) -> list[Assign]:
    """Assignments of the named expressions with their common subexpressions taken out first.

    The temporaries are called ``<prefix>0``, ``<prefix>1``, …; the order is deterministic.
    """
    temporaries = (sp.Symbol(f"{prefix}{i}", real=True) for i in range(10**6))
    replaced, reduced = sp.cse(list(named.values()), symbols=temporaries, order="canonical")
    lines = [Assign(symbol.name, expression) for symbol, expression in replaced]
    texts = comments or {}
    lines += [
        Assign(name, expression, texts.get(name, ""))
        for name, expression in zip(named, reduced, strict=True)
    ]
    return lines
