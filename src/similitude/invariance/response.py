"""Response: one output as a function of named arguments, with what proves and what evaluates its rows.

Invariant: `arguments` are everything the value depends on: parameters, the height of the input, time,
the Laplace variable, the sample time. A row that left one of them out would be false.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
import sympy as sp

from similitude.homogeneity.measure import Measure
from similitude.invariance.exact_zero import euler_residual


@dataclass(frozen=True)
class Certificate:
    """A formula whose homogeneity carries a row.

    ``sum_j c_j x_j d(formula)/dx_j = c formula`` over all its symbols, in every dimension: for an explicit
    response this is the row itself; for one that solves equations (a trajectory, a root, a steady state)
    it is asked of the equations, and the row follows because their solution is unique.
    """

    where: str
    formula: sp.Expr
    measure: Measure

    def residual(self, symbols: Mapping[sp.Symbol, Measure], dimension: str) -> sp.Expr:
        """What is left of Euler's identity in one dimension; exactly zero where it holds."""
        weights = {symbol: _exponent(symbols[symbol], dimension) for symbol in self.formula.free_symbols}
        return euler_residual(self.formula, weights, _exponent(self.measure, dimension))


@dataclass(frozen=True)
class Response:
    """One output of a system as a function of its arguments.

    Parameters
    ----------
    kind, about : such as "time" and "r after a step of delta".
    arguments : name -> measure, in the order in which rows print them.
    output : measure of the value.
    symbols : measure of every symbol in the certificates.
    certificates : formulas whose homogeneity proves the rows.
    evaluate : values (SI) of arguments -> (y, {argument: dy/d ln(argument)}), arrays of one shape.
    guesses : names that `evaluate` also takes, as a place to start a search from.
    formula : y itself where it is explicit, in symbols named like the arguments.
    """

    kind: str
    about: str
    arguments: Mapping[str, Measure]
    output: Measure
    symbols: Mapping[sp.Symbol, Measure]
    certificates: tuple[Certificate, ...]
    evaluate: Callable[[Mapping[str, float]], tuple[np.ndarray, dict[str, np.ndarray]]]
    guesses: Mapping[str, Measure] = field(default_factory=dict)
    formula: sp.Expr | None = None


def _exponent(measure: Measure, dimension: str) -> sp.Rational:
    value = measure.exponents.get(dimension, 0)
    return sp.Rational(value.numerator, value.denominator)
