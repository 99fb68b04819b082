"""Euler's identity in symbols: whether what should vanish is zero whatever its symbols are.

    sum_j c_j x_j dy/dx_j - c y  =  0

Where y is a rational function N/M this is arithmetic of polynomials, sum c_j x_j (N_j M - N M_j) - c N M.
Otherwise, without `simplify`:

    1  expand, then expand the numerator over one denominator     rational in symbols and functions
    2  the same with every symbol positive                         roots of products
    3  fifty digits at random rational points                      decides "no", and "yes" as a float

Invariant: an exact zero is returned only where step 1 or 2 has shown it.
"""

from __future__ import annotations

import random
from collections.abc import Mapping

import sympy as sp

DIGITS = 50


def euler_residual(
    formula: sp.Expr, weights: Mapping[sp.Symbol, sp.Rational], weight: sp.Rational
) -> sp.Expr:
    """What is left of Euler's identity: ``Integer(0)`` where it holds, see `proven_zero` for the rest.

    Parameters
    ----------
    formula : y, in the symbols that have weights.
    weights, weight : c_j of each symbol and c of y, exact.
    """
    symbols = sorted(formula.free_symbols, key=lambda s: s.name)
    if symbols and not formula.has(sp.Float) and formula.is_rational_function(*symbols):
        return _rational_residual(formula, symbols, weights, weight)
    total = -weight * formula
    for symbol in symbols:
        if weights[symbol]:
            total += weights[symbol] * symbol * sp.diff(formula, symbol)
    return proven_zero(total)


def _rational_residual(formula, symbols, weights, weight) -> sp.Expr:
    try:
        N, M = (sp.Poly(part, *symbols, domain="QQ") for part in sp.fraction(sp.together(formula)))
    except sp.CoercionFailed:  # a coefficient such as pi or sqrt(2)
        N, M = (sp.Poly(part, *symbols, domain="EX") for part in sp.fraction(sp.together(formula)))
    total = -weight * N * M
    for symbol in symbols:
        if weights[symbol]:
            slope = N.diff(symbol) * M - N * M.diff(symbol)
            total += sp.Poly(weights[symbol] * symbol, *symbols, domain=N.domain) * slope
    return sp.Integer(0) if total.is_zero else total.as_expr() / (M * M).as_expr()


def proven_zero(expression: sp.Expr) -> sp.Expr:
    """Zero where the expression is shown to vanish identically.

    Returns
    -------
    sympy.Expr    ``Integer(0)`` where that is proven; a `Float` below 1e-40, the largest value found, where
                  it vanishes at every point tried but no algebra here shows it; else the expression.
    """
    if _vanishes(expression):
        return sp.Integer(0)
    positive = {s: sp.Symbol(s.name, positive=True) for s in expression.free_symbols}
    if not expression.has(sp.Abs, sp.Max, sp.Min, sp.Piecewise, sp.sign) and _vanishes(
        expression.xreplace(positive)
    ):
        return sp.Integer(0)
    largest = largest_value(expression)
    if largest is None or largest > sp.Float("1e-40"):
        return expression
    return sp.Max(sp.Float(largest, DIGITS), sp.Float("1e-50", DIGITS))  # 50 digits show no more than that


def largest_value(expression: sp.Expr, points: int = 4) -> sp.Float | None:
    """Greatest size at random positive points, over the size of its largest term; None where undefined."""
    draw = random.Random(len(expression.free_symbols))
    symbols = sorted(expression.free_symbols, key=lambda s: s.name)
    found = []
    for _ in range(points):
        at = {s: sp.Rational(draw.randint(100, 999), 313) for s in symbols}
        terms = [sp.N(term.xreplace(at).doit(), DIGITS) for term in sp.Add.make_args(expression)]
        if not all(term.is_Float or term.is_Integer for term in terms):
            return None
        size = max((abs(term) for term in terms), default=sp.Float(0))
        found.append(abs(sum(terms)) / size if size else sp.Float(0))
    return max(found, default=sp.Float(0))


def _vanishes(expression: sp.Expr) -> bool:
    if expression.is_zero or sp.expand(expression) == 0:
        return True
    numerator, _ = sp.fraction(sp.together(expression))
    return sp.expand(numerator) == 0
