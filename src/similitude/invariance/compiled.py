"""Expressions compiled to functions of numbers, with what this package adds to SymPy spelt out."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from similitude.saturation import Saturation, SaturationBend, SaturationSlope

_OWN = (Saturation, SaturationSlope, SaturationBend)


def compiled(symbols: Sequence[sp.Symbol], expressions: Sequence[sp.Expr]) -> Callable[..., list]:
    """A function of the symbols' values that returns the expressions' values, common parts shared.

    Parameters
    ----------
    symbols : in the order in which the function takes their values, numbers or arrays of one shape.
    expressions : in those symbols alone.
    """
    plain = [
        sp.sympify(e).replace(lambda part: isinstance(part, _OWN), lambda part: part.doit())
        for e in expressions
    ]
    return sp.lambdify(list(symbols), plain, modules="numpy", cse=True, dummify=True)


def log_slope(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """d(expression)/d ln(symbol)."""
    return symbol * sp.diff(expression, symbol)
