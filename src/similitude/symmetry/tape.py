"""Tape: expressions as a list of elementary steps that run in any arithmetic, with derivatives.

A value is a Taylor series in time, and every coefficient carries its slopes along some directions:
arrays (..., 1 + q), the value first. Order zero alone is an ordinary evaluation with its gradient.
Rational expressions run in integers modulo a prime, where ranks are exact; all others in floats or in
mpmath's numbers.

    step                       meaning
    number, symbol             a constant, a name
    add, mul, inv              of earlier steps
    call h(a), slope g         dh/da = g, where g is a later step that may use h

Invariant: a tape holds no expression twice, and reads no step of the same order that comes after it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import sympy as sp

from similitude.errors import ModelError

# step: (kind, what, earlier steps)
Step = tuple[str, object, tuple[int, ...]]
BRANCHES = {sp.Abs: "abs", sp.sign: "sign", sp.Max: "max", sp.Min: "min"}


@dataclass
class Tape:
    """Steps in order.

    ``rational``: integers modulo a prime can run them, once the branches of abs, sign, max and min
    (``branches``) are chosen at a point of real numbers.
    """

    steps: list[Step] = field(default_factory=list)
    results: list[int] = field(default_factory=list)
    slopes: dict[int, int] = field(default_factory=dict)  # a call's step -> the step of its slope
    rational: bool = True
    branches: bool = False


def record(expressions: Iterable[sp.Expr]) -> Tape:
    """Write expressions as steps; ``results`` are the steps of the expressions, in their order.

    Raises
    ------
    ModelError    a function that is not known here, such as an undefined one.
    """
    writer = _Writer()
    for expression in expressions:
        writer.tape.results.append(writer.write(sp.sympify(expression)))
    return writer.tape


class _Writer:
    def __init__(self) -> None:
        self.tape = Tape()
        self.places: dict[object, int] = {}

    def write(self, e: sp.Expr) -> int:
        """The step of an expression."""
        if e not in self.places:
            self.places[e] = self._new(e)
        return self.places[e]

    def _step(self, kind: str, what: object = None, *earlier: int) -> int:
        self.tape.steps.append((kind, what, earlier))
        return len(self.tape.steps) - 1

    def _new(self, e: sp.Expr) -> int:
        if e.is_Symbol:
            return self._step("symbol", e.name)
        if e.is_Rational:
            return self._step("number", e)
        if e.is_Float:
            return self.write(sp.Rational(str(e)))
        if e.is_number:
            self.tape.rational = False
            return self._step("number", e)
        if e.is_Add or e.is_Mul:
            kind = "add" if e.is_Add else "mul"
            total = self.write(e.args[0])
            for term in e.args[1:]:
                total = self._step(kind, None, total, self.write(term))
            return total
        if e.is_Pow and e.exp.is_Integer:
            return self._integer_power(e.base, int(e.exp))
        return self._function(e)

    def _integer_power(self, base: sp.Expr, power: int) -> int:
        if power < 0:
            return self._step("inv", None, self.write(base**-power))
        if power % 2:
            return self._step("mul", None, self.write(base ** (power - 1)), self.write(base))
        half = self.write(base ** (power // 2))
        return self._step("mul", None, half, half)

    def _function(self, e: sp.Expr) -> int:
        if e.func in BRANCHES:
            self.tape.branches = True
            return self._step(BRANCHES[e.func], None, *(self.write(a) for a in e.args))
        if e.is_Pow and e.exp.is_Rational:
            return self._power(e)
        if e.is_Pow:
            return self.write(sp.exp(e.exp * sp.log(e.base), evaluate=False))
        if isinstance(e, sp.atan2):
            return self.write(sp.atan(e.args[0] / e.args[1]))
        if e.func in CALLS:
            return self._call(e, *CALLS[e.func])
        spelt = e.doit() if isinstance(e, sp.Function) else e
        if spelt != e and not isinstance(e, sp.core.function.AppliedUndef):
            return self.write(spelt)
        raise ModelError(
            f"the function {e.func} in {sp.sstr(e)[:80]} is not known",
            usually="An undefined function stands where a formula is needed.",
            paste="rates={'x': -k*sp.tanh(x)}   # a function of SymPy",
            read='docs/symmetries.md, "Functions"',
        )

    def _power(self, e: sp.Expr) -> int:
        self.tape.rational = False
        base = self.write(e.base)
        place = self._step("call", ("power", e.exp), base)
        inverse = self._step("inv", None, base)
        times = self._step("mul", None, place, inverse)
        self.tape.slopes[place] = self._step("mul", None, self._step("number", e.exp), times)
        return place

    def _call(self, e: sp.Expr, name: str, slope) -> int:
        self.tape.rational = False
        place = self.places[e] = self._step("call", (name, None), self.write(e.args[0]))
        self.tape.slopes[place] = -1  # a partner's slope may be this very step
        self.tape.slopes[place] = self.write(slope(e, e.args[0]))
        return place


CALLS = {
    sp.exp: ("exp", lambda h, a: h),
    sp.log: ("log", lambda h, a: 1 / a),
    sp.sin: ("sin", lambda h, a: sp.cos(a)),
    sp.cos: ("cos", lambda h, a: -sp.sin(a)),
    sp.tan: ("tan", lambda h, a: 1 + h**2),
    sp.sinh: ("sinh", lambda h, a: sp.cosh(a)),
    sp.cosh: ("cosh", lambda h, a: sp.sinh(a)),
    sp.tanh: ("tanh", lambda h, a: 1 - h**2),
    sp.asin: ("asin", lambda h, a: (1 - a**2) ** sp.Rational(-1, 2)),
    sp.acos: ("acos", lambda h, a: -((1 - a**2) ** sp.Rational(-1, 2))),
    sp.atan: ("atan", lambda h, a: 1 / (1 + a**2)),
}
