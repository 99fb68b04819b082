"""Lowers a step program to integers: every variable gets a format, every operation its shifts.

The numbers of the configuration become literals; what only depends on them is computed here. Products are
exact, sums keep the digits of their finest term, and one rounding stands before each assignment.

Invariant: the statements are those of the program, in its order; only a target's format may round or clamp.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from similitude.program.fixed import integer as it
from similitude.program.fixed.arithmetic import Value, fit, narrowed
from similitude.program.fixed.bounds import Ranges, bounds, read_names
from similitude.program.fixed.expressions import Expressions
from similitude.program.fixed.formats import Format, format_of, sample_format
from similitude.program.fixed.slim import odd_part
from similitude.program.ir import Assign, Field, Program, Statement, When, walk, without_unread


@dataclass(frozen=True)
class Put:
    """``target = node``; ``new`` declares a constant temporary."""

    target: str
    node: it.Int
    new: bool
    comment: str = ""


@dataclass(frozen=True)
class If:
    """Run ``body`` where the condition holds, ``otherwise`` where it does not."""

    condition: it.Cond
    body: tuple[Put | If, ...]
    otherwise: tuple[Put | If, ...] = ()
    comment: str = ""


@dataclass(frozen=True)
class Held:
    """A field as integers have it."""

    name: str
    unit: str
    meaning: str
    format: Format


@dataclass(frozen=True)
class FixedProgram:
    """A step in integers; the same structs as its program, arrays spelt out.

    ``start`` integers of the state before the first sample; ``working`` values that outlive their guards;
    ``constants`` the numbers that became literals.
    """

    program: Program
    sample: tuple[Held, ...]
    state: tuple[Held, ...]
    output: tuple[Held, ...]
    working: Mapping[str, Format]
    temporaries: Mapping[str, Format]
    start: tuple[int, ...]
    step: tuple[Put | If, ...]
    constants: Mapping[str, Fraction]

    @property
    def name(self) -> str:
        """The program's."""
        return self.program.name


def lower(program: Program, numbers: Mapping[str, float], ranges: Ranges) -> FixedProgram:
    """Lower a step program.

    Parameters
    ----------
    program : Program    its divisors are positive; a divisor that rounds to zero counts as one unit.
    numbers : name of each real of the configuration -> value in SI units.
    ranges : Ranges      of sample fields and bounded states, in SI units.

    Returns
    -------
    FixedProgram    no value of which can wrap, whatever the samples hold.

    Raises
    ------
    ProgramError    a variable has no bound, or a product does not fit 62 bits.
    """
    program = without_unread(program)
    constants, start = settled(program, numbers)
    found = bounds(program, {n: float(v) for n, v in constants.items()}, ranges)
    formats = _formats(program, found, ranges, constants)
    body = _Body(program, constants, formats, ranges)
    step = body.lowered()
    state = tuple(_held(program.state, formats, constants))
    working = {n: f for n, f in formats.items() if n in body.written and n not in {h.name for h in state}}
    return FixedProgram(
        program,
        sample=tuple(_held(program.sample, formats, constants)),
        state=state,
        output=tuple(_held(program.output, formats, constants)),
        working=working,
        temporaries=body.temporaries,
        start=tuple(h.format.integer(start[h.name]) for h in state),
        step=step,
        constants=constants,
    )


def _held(fields: Iterable[Field], formats: Mapping[str, Format], constants: Mapping) -> Iterable[Held]:
    for f in fields:
        for s in f.symbols:
            if s.name not in constants:
                yield Held(s.name, f.unit, f.meaning, formats[s.name])


def settled(
    program: Program, numbers: Mapping[str, float]
) -> tuple[dict[str, Fraction], dict[str, Fraction]]:
    """What never changes (the configuration, and states that the step leaves alone), and where states start.

    Parameters
    ----------
    program, numbers : as of `lower`.
    """
    constants = {name: Fraction(value) for name, value in numbers.items()}
    here = dict(constants)
    plain = Expressions(here, {}, {}, {})
    for s in program.init:
        assert isinstance(s, Assign)
        here[s.target] = plain.exact(s.expression)
    states = {s.name for f in program.state for s in f.symbols}
    written = {s.target for s in walk(program.step) if isinstance(s, Assign)}
    constants.update({name: here[name] for name in states - written})
    return constants, {name: here[name] for name in states}


def _formats(
    program: Program, found: Mapping[str, tuple[float, float]], ranges: Ranges, constants: Mapping
) -> dict[str, Format]:
    """Formats of sample, state, working values and outputs."""
    formats = {s.name: sample_format(*found[s.name]) for f in program.sample for s in f.symbols}
    whole = set(ranges.whole)
    values: dict[str, list[sp.Expr]] = {}
    for s in walk(program.step):
        if isinstance(s, Assign):
            values.setdefault(s.target, []).append(s.expression)
    whole |= {n for n, v in values.items() if all(isinstance(e, sp.Integer) for e in v)}
    for f in (*program.state, *program.variables, *program.output):
        for s in f.symbols:
            if s.name in found and s.name not in constants:
                kind = {"wide": s.name in ranges.wide, "whole": s.name in whole, "full": ranges.full}
                formats[s.name] = format_of(*found[s.name], **kind)
    return formats


class _Body:
    def __init__(
        self, program: Program, constants: dict[str, Fraction], formats: dict[str, Format], ranges: Ranges
    ) -> None:
        self.program, self.formats, self.ranges = program, formats, ranges
        self.here = dict(constants)
        self.temporaries: dict[str, Format] = {}
        self.written: set[str] = set()
        outputs = {s.name for f in program.output for s in f.symbols}
        states = {s.name for f in program.state for s in f.symbols}
        self.products: dict = {}  # of a variable and a number, taken already
        self.again = repeated(program, Expressions(self.here, {}, {}, {}))
        self.kept = read_names(program) | outputs | states | {"status"}

    def lowered(self) -> tuple[Put | If, ...]:
        """The statements of the step."""
        fields = [*self.program.sample, *self.program.state]
        names = [s.name for f in fields for s in f.symbols if s.name in self.formats]
        env = {n: (self.formats[n].lo, self.formats[n].hi) for n in names}
        return self.body(self.program.step, env)

    def body(self, statements: Iterable[Statement], env: dict[str, tuple[int, int]]) -> tuple[Put | If, ...]:
        """Lower statements; ``env`` is brought up to date."""
        lines: list[Put | If] = []
        for s in statements:
            expressions = Expressions(
                self.here, self.formats, self.temporaries, env, self.again, self.products
            )
            if isinstance(s, When):
                condition = expressions.condition(s.condition)
                lines += self._temporaries(expressions)
                lines += self._guard(s, condition, env)
            elif s.target in self.kept or s.target not in self.formats:
                lines += self._assign(s, expressions, env)
        return tuple(lines)

    def _temporaries(self, expressions: Expressions) -> list[Put]:
        return [Put(name, node, True) for name, node in expressions.made]

    def _guard(self, s: When, condition: it.Cond, env: dict[str, tuple[int, int]]) -> list[Put | If]:
        if condition in (it.TRUE, it.FALSE):
            return list(self.body(s.body if condition == it.TRUE else s.otherwise, env))
        inside, other = narrowed(env, condition, True), narrowed(env, condition, False)
        before = dict(self.products)
        body, after = self.body(s.body, inside), self.products
        self.products = dict(before)
        otherwise = self.body(s.otherwise, other)
        self.products = {k: v for k, v in before.items() if k in after and k in self.products}
        for n in inside.keys() & other.keys():
            env[n] = (min(inside[n][0], other[n][0]), max(inside[n][1], other[n][1]))
        return [If(condition, body, otherwise, s.comment)] if body or otherwise else []

    def _assign(self, s: Assign, expressions: Expressions, env: dict[str, tuple[int, int]]) -> list[Put]:
        target = self.formats.get(s.target)
        if target is None and s.target in self.ranges.stated:
            kind = {"wide": s.target in self.ranges.wide, "full": self.ranges.full}
            target = format_of(*self.ranges.stated[s.target], **kind)
        full = s.target in self.ranges.wide or self.ranges.full
        value: Value = expressions.value(s.expression, target, full=full)
        if isinstance(value, Fraction) and s.target not in self.formats:
            self.here[s.target] = value
            return []
        if target is None:
            value = expressions.tidy(value, wide=s.target in self.ranges.wide)
            target = Format(value.fraction, value.node.lo, value.node.hi, s.target in self.ranges.wide)
        node = fit(value, target)
        new = s.target not in self.formats
        if new:
            self.temporaries[s.target] = target
        else:
            self.written.add(s.target)
        env[s.target] = (node.lo, node.hi)
        for key in [k for k in self.products if k[0] == s.target]:
            del self.products[key]
        if node.kind == "name" and node.args[0] == s.target:
            return self._temporaries(expressions)
        return [*self._temporaries(expressions), Put(s.target, node, new, s.comment)]


def repeated(program: Program, numbers: Expressions) -> dict[tuple[str, Fraction], int]:
    """How often a variable is multiplied by the same number but for sign and a power of two."""
    found: dict[tuple[str, Fraction], int] = {}
    for s in walk(program.step):
        if isinstance(s, When):
            continue
        for part in sp.Add.make_args(s.expression):
            symbols = [f for f in sp.Mul.make_args(part) if _varies(f, numbers)]
            if len(symbols) != 1 or not isinstance(symbols[0], sp.Symbol):
                continue
            number = abs(numbers.exact(part / symbols[0]))
            if number:
                key = (symbols[0].name, odd_part(number))
                found[key] = found.get(key, 0) + 1
    return found


def _varies(e: sp.Expr, numbers: Expressions) -> bool:
    return any(symbol.name not in numbers.here for symbol in e.free_symbols)


__all__ = ["FixedProgram", "Held", "If", "Put", "lower", "settled"]
