"""Expressions compiled to functions of numbers, with the functions this package adds to SymPy."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache

import sympy as sp

from similitude.saturation import Saturation, SaturationBend, SaturationSlope


def compiled(symbols: Sequence[sp.Symbol], expressions: Sequence[sp.Expr]) -> Callable[..., list]:
    """A function of the symbols' values that returns the expressions' values, common parts shared.

    Parameters
    ----------
    symbols : in the order in which the function takes their values, numbers or arrays of one shape.
    expressions : in those symbols alone.
    """
    return sp.lambdify(list(symbols), list(expressions), modules=[_own(), "numpy"], cse=True, dummify=True)


@cache
def _own() -> dict[str, Callable]:
    x = sp.Dummy(real=True)
    made = (Saturation, SaturationSlope, SaturationBend)
    return {kind.__name__: sp.lambdify(x, kind(x).doit(), modules="numpy") for kind in made}


def log_slope(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """d(expression)/d ln(symbol)."""
    return symbol * sp.diff(expression, symbol)
