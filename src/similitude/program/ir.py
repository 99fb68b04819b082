"""Step programs: straight-line assignments with guards, from which C and the Python twin are printed.

Invariant: a program is a value. Its statements are SymPy expressions over declared fields and
earlier temporaries, so whatever is printed from it, in any language, does the same operations in
the same order.
"""

from __future__ import annotations

import keyword
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

import sympy as sp

from similitude.errors import ProgramError

_C_WORDS = (  # C99, and the arguments of the printed functions
    "auto break case char const continue default do double else enum extern float for goto if "
    "inline int long register restrict return short signed sizeof static struct switch typedef "
    "union unsigned void volatile while config state sample output"
).split()


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
    """``target = expression``; a target that is no field and no variable is a constant temporary.

    Neighbours of the same ``part`` become one C function (`program.parts`).
    """

    target: str
    expression: sp.Expr
    comment: str = ""
    part: str = ""


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
    The step returns the variable ``status``. With a ``report`` it hands out nothing else: the report works
    out every output from configuration and state, so that what is asked for now and then is not paid for at
    every sample.
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
    report: tuple[Statement, ...] = ()

    def __post_init__(self) -> None:
        fields = (*self.config, *self.state, *self.sample, *self.output, *self.variables)
        names = [symbol.name for f in fields for symbol in f.symbols]
        names += [f.name for f in fields if f.size > 1]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ProgramError(
                f"program {self.name!r} declares {', '.join(twice)} more than once",
                usually="A state, configuration or output field shares a name with another.",
                paste="Field('steer_offset_sd', 'rad', '...')   # give each field its own name",
                read="docs/architecture.md, 'Step programs'",
            )
        read_only = {symbol.name for f in (*self.config, *self.sample) for symbol in f.symbols}
        sampled = {symbol.name for f in self.sample for symbol in f.symbols}
        states = {symbol.name for f in self.state for symbol in f.symbols}
        outputs = {symbol.name for f in self.output for symbol in f.symbols}
        _names_or_raise(self, names)
        writable = set(names) - read_only
        after_init = _check(self, self.init, known=read_only, writable=writable)
        after_step = _check(self, self.step, known=read_only | states, writable=writable)
        told = after_step
        if self.report:
            _no_output_or_raise(self, outputs)
            told = _check(self, self.report, known=read_only - sampled | states, writable=outputs)
        missing = (states - after_init) | (outputs - told) | ({"status"} - after_step)
        if missing:
            raise ProgramError(
                f"program {self.name!r} leaves {', '.join(sorted(missing))} without a value",
                usually="init must set every state; step every output and `status`, on every way.",
                paste=f"Assign({sorted(missing)[0]!r}, ...)",
                read="docs/architecture.md, 'Step programs'",
            )


def _check(program: Program, body: Iterable[Statement], *, known: set[str], writable: set[str]) -> set[str]:
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
            if statement.target in known and statement.target not in writable:
                raise ProgramError(
                    f"program {program.name!r} assigns {statement.target!r} again: it is constant",
                    usually="A quantity of the model has the name of a working value of the step.",
                    paste=f"Quantity('{statement.target}_0', ...)   # another name in the model",
                    read="docs/architecture.md, 'Step programs'",
                )
            known.add(statement.target)
    return known


def _no_output_or_raise(program: Program, outputs: set[str]) -> None:
    mixed = sorted({s.target for s in walk(program.step) if isinstance(s, Assign)} & outputs)
    if mixed:
        raise ProgramError(
            f"program {program.name!r} has a report, and its step assigns the output {', '.join(mixed)}",
            usually="What is asked for later is kept in the state; a struct that is half old is a trap.",
            paste=f"Field('{mixed[0]}_kept', ...)   # a state that the report hands out",
            read="docs/architecture.md, 'Step programs'",
        )


def _names_or_raise(program: Program, names: Iterable[str]) -> None:
    taken = {*keyword.kwlist, *_C_WORDS}
    wrong = sorted({n for n in names if not (n.isascii() and n.isidentifier()) or n in taken})
    if wrong:
        raise ProgramError(
            f"program {program.name!r} cannot declare {', '.join(wrong)}",
            usually="It is a word of C or Python, or holds a letter that neither allows in a name.",
            paste=f"Field('{wrong[0]}_0', ...)   # another name",
            read="docs/architecture.md, 'Step programs'",
        )


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


def shared(prefix: str, named: dict[str, sp.Expr], comments: dict[str, str] | None = None) -> list[Assign]:
    """Assignments of the named expressions with their common subexpressions taken out first.

    The temporaries are called ``<prefix>0``, ``<prefix>1``, …; the order is deterministic.
    """
    temporaries = (sp.Symbol(f"{prefix}{i}", real=True) for i in range(10**6))
    replaced, reduced = sp.cse(list(named.values()), symbols=temporaries, order="canonical")
    lines = [Assign(symbol.name, expression) for symbol, expression in replaced]
    texts = comments or {}
    lines += [
        Assign(name, expression, texts.get(name, "")) for name, expression in zip(named, reduced, strict=True)
    ]
    return lines


def without_unread(program: Program) -> Program:
    """The same program without temporaries of its step that nothing reads; every result stays the same."""
    fields = (*program.config, *program.state, *program.sample, *program.output, *program.variables)
    kept = {symbol.name for f in fields for symbol in f.symbols}
    step = program.step
    while True:
        read = kept | {s.name for node in walk(step) for s in _reads(node)}
        shorter = _only(step, read)
        if shorter == step:
            return replace(program, step=step)
        step = shorter


def _reads(statement: Statement) -> set[sp.Symbol]:
    node = statement.condition if isinstance(statement, When) else statement.expression
    return node.free_symbols


def _only(body: tuple[Statement, ...], read: set[str]) -> tuple[Statement, ...]:
    """The statements of a body whose target is read, and the guards that still guard something."""
    kept: list[Statement] = []
    for s in body:
        if not isinstance(s, When):
            kept += [s] if s.target in read else []
            continue
        shorter = replace(s, body=_only(s.body, read), otherwise=_only(s.otherwise, read))
        kept += [shorter] if shorter.body or shorter.otherwise else []
    return tuple(kept)
