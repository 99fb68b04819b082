"""The measure of an expression, by a walk over its tree, and every place where units do not fit.

    sum, Min, Max, Piecewise    all parts alike; zero fits everywhere
    product, power              exponents add, or are multiplied by a number
    Abs, -x, floor              as the argument                     sign, Heaviside    a pure number
    sin, cos, tan               of an angle or a pure number        asin, acos, atan   give an angle
    exp, log, Saturation, ...   and every function not named here: pure numbers in, a pure number out

Invariant: nothing is guessed or rounded; a part that does not fit is recorded once and then fits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean, BooleanFunction

from similitude.homogeneity.measure import ANGLE, NONE, Measure

_TURNED = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc, sp.sinc)
_TURNS = (sp.asin, sp.acos, sp.atan, sp.acot)
_KEEPS = (sp.Abs, sp.floor, sp.ceiling, sp.re, sp.im, sp.conjugate)
_DROPS = (sp.sign, sp.Heaviside)


@dataclass(frozen=True)
class Mismatch:
    """One part of an expression whose unit does not fit.

    Parameters
    ----------
    part : the offending term, argument or exponent.
    unit : what it is in, as text.
    against : what it was held against: another term, or what takes it.
    wanted : what it should be in, as text.
    """

    part: sp.Basic
    unit: str
    against: str
    wanted: str

    def __str__(self) -> str:
        return (
            f"{sp.sstr(self.part)} is in {self.unit}, {self.against} in {self.wanted}"
            f" ({self.wanted} against {self.unit})"
        )


def mismatches(
    expression: sp.Basic, symbols: Mapping[sp.Symbol, tuple[Measure, str]], wanted: Measure, whole: str
) -> tuple[Mismatch, ...]:
    """Every place at which an expression's units do not fit.

    Parameters
    ----------
    expression : a SymPy expression or condition in the symbols.
    symbols : each symbol's measure, and its unit as somebody wrote it.
    wanted : what the whole is to be in.
    whole : how a message calls what the whole is held against, such as "the rate of 'v'".

    Returns
    -------
    tuple of Mismatch    empty where the expression is homogeneous.
    """
    walk = _Walk(symbols)
    found = walk.of(expression, wanted)
    if not walk.found and found is not None and found != wanted:
        walk.found.append(Mismatch(expression, walk.text(expression, found), whole, str(wanted)))
    return tuple(walk.found)


def measure_of_expression(
    expression: sp.Basic, symbols: Mapping[sp.Symbol, tuple[Measure, str]]
) -> Measure | None:
    """What an expression is in; None where its units do not fit together, or where it is zero."""
    walk = _Walk(symbols)
    found = walk.of(expression, None)
    return None if walk.found else found


class _Walk:
    """One walk; ``None`` as a measure means that the part fits anything (zero, or already recorded)."""

    def __init__(self, symbols: Mapping[sp.Symbol, tuple[Measure, str]]) -> None:
        self.symbols = symbols
        self.found: list[Mismatch] = []

    def of(self, e: sp.Basic, wanted: Measure | None) -> Measure | None:
        """The measure of a part; ``wanted`` decides which of two unlike terms is the offender."""
        if isinstance(e, sp.Symbol):
            return self.symbols[e][0]
        if isinstance(e, sp.Number | sp.NumberSymbol) or e.is_number:
            return None if e.is_zero or e.is_infinite or e is sp.nan else NONE
        if isinstance(e, sp.Add | sp.Min | sp.Max | sp.Mod):
            return self._alike(e.args, wanted)
        if isinstance(e, sp.Mul):
            return self._product(e.args, wanted)
        if isinstance(e, sp.Pow):
            return self._power(e.base, e.exp)
        if isinstance(e, sp.Piecewise):
            for _, condition in e.args:
                self.of(condition, None)
            return self._alike([value for value, _ in e.args], wanted)
        if isinstance(e, Relational):
            self._alike(e.args, None)
            return NONE
        if isinstance(e, Boolean | BooleanFunction):
            for part in e.args:
                self.of(part, None)
            return NONE
        return self._function(e, wanted)

    def _function(self, e: sp.Basic, wanted: Measure | None) -> Measure | None:
        if isinstance(e, _KEEPS):
            return self.of(e.args[0], wanted)
        if isinstance(e, _DROPS):
            self.of(e.args[0], None)
            return NONE
        if isinstance(e, sp.atan2):
            self._alike(e.args, None)
            return self._angle()
        for argument in e.args:
            found = self.of(argument, None)
            fits = found is None or found.is_none or (isinstance(e, _TURNED) and found == ANGLE)
            if not fits:
                self._record(argument, found, f"and {_called(e)} takes a pure number,", "-")
        return self._angle() if isinstance(e, _TURNS) else NONE

    def _angle(self) -> Measure:
        counted = any(measure.angle for measure, _ in self.symbols.values())
        return ANGLE if counted else NONE

    def _alike(self, parts: Sequence[sp.Basic], wanted: Measure | None) -> Measure | None:
        """Parts that have to be in the same unit; those that are not are recorded."""
        found = [(part, self.of(part, wanted)) for part in parts]
        known = [(part, measure) for part, measure in found if measure is not None]
        if not known:
            return None
        measures = [measure for _, measure in known]
        right = wanted if wanted in measures else max(measures, key=measures.count)
        model = next(part for part, measure in known if measure == right)
        for part, measure in known:
            if measure != right:
                self._record(part, measure, f"but {sp.sstr(model)}", self.text(model, right))
        return right

    def _product(self, factors: Sequence[sp.Expr], wanted: Measure | None) -> Measure | None:
        """The one factor that is a sum is told what the others leave for it."""
        sums = [f for f in factors if isinstance(f, sp.Add | sp.Piecewise)]
        total: Measure | None = NONE
        for factor in sorted(factors, key=lambda f: f in sums):
            left = wanted / total if wanted is not None and total is not None and sums == [factor] else None
            found = self.of(factor, left)
            total = None if total is None or found is None else total * found
        return total

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> Measure | None:
        below, above = self.of(base, None), self.of(exponent, None)
        if above is not None and not above.is_none:
            self._record(exponent, above, "and an exponent is a pure number,", "-")
            return None
        if below is None or below.is_none:
            return below
        power = _rational(exponent)
        if power is None:
            self._record(base, below, f"and what has the power {sp.sstr(exponent)} is a pure number,", "-")
            return None
        return below**power

    def _record(self, part: sp.Basic, found: Measure, against: str, wanted: str) -> None:
        mismatch = Mismatch(part, self.text(part, found), against, wanted)
        if mismatch not in self.found:
            self.found.append(mismatch)

    def text(self, part: sp.Basic, measure: Measure) -> str:
        """The unit as somebody wrote it where the part is one symbol times a number."""
        rest = part.as_coeff_Mul()[1] if isinstance(part, sp.Expr) else part
        return self.symbols[rest][1] if rest in self.symbols else str(measure)


def _called(e: sp.Basic) -> str:
    return type(e).__name__


def _rational(exponent: sp.Expr) -> Fraction | None:
    """An exponent as a fraction; a float counts as the simple fraction it prints as."""
    if isinstance(exponent, sp.Rational):
        return Fraction(exponent.p, exponent.q)
    if isinstance(exponent, sp.Float):
        near = Fraction(float(exponent)).limit_denominator(1000)
        return near if abs(float(near) - float(exponent)) < 1e-14 * abs(float(exponent)) else None
    return None
