"""Whether equations hold in every system of units, tried by changing the units.

    f(k^D x) = k^d f(x)    k > 0 the factor of one base dimension, D and d the exponents of x and of f

Independent of the rewriting in groups: numbers go in, numbers come out, nothing is simplified.

Invariant: a term that is named does not scale as the left side of its equation does, or a part of a
function's argument does not scale at all as a power.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from similitude.model import Model
from similitude.units import Dimension, parse_unit

FACTORS = (1.7, 0.6)  # of a unit; two, so that no power of one is mistaken for the other
CLOSE = 1e-8  # of a power: a thousand roundings of a double, with room for terms that cancel
TRIES = 50  # points at which a term is looked for that has a real value there


@dataclass(frozen=True)
class Misfit:
    """A term that has not the dimension of its equation.

    ``where`` is the equation, ``term`` the term, ``base`` the base dimension, ``found`` the power with
    which the term scales (NaN where it is no power) and ``wanted`` the power it should.
    """

    where: str
    term: str
    base: str
    found: float
    wanted: float

    def __str__(self) -> str:
        how = "as no power" if math.isnan(self.found) else f"as its power {self.found:.4g}"
        return f"{self.where}: {self.term} scales with {self.base} {how}, not {self.wanted:.4g}"


def misfits(model: Model) -> list[Misfit]:
    """Terms of the rates, outputs and constraints that change otherwise than their left side.

    Parameters
    ----------
    model : Model.

    Returns
    -------
    list of Misfit   one for each term and base dimension, empty for a homogeneous model.

    Raises
    ------
    ArithmeticError    a term has no real value at any point that was tried.
    """
    dimension = {q.symbol: q.dimension for q in model.quantities}
    return [
        found
        for where, expression, wanted in _equations(model)
        for term in sp.Add.make_args(sp.expand(expression))
        for found in _misfits(where, term, wanted, dimension)
    ]


def _equations(model: Model) -> list[tuple[str, sp.Expr, Dimension]]:
    time = parse_unit(model.time_unit).dimension
    rates = [(f"d{n}/dt", e, model.quantity(n).dimension / time) for n, e in model.rates.items()]
    outputs = {q.name: q.dimension for q in model.outputs}
    return [
        *((where, sp.sympify(e).doit(), d) for where, e, d in rates),
        *((n, sp.sympify(e).doit(), outputs[n]) for n, e in model.output_map.items()),
        *((n, sp.sympify(e).doit(), model.quantity(n).dimension) for n, e in model.constraints.items()),
    ]


def _misfits(where: str, term: sp.Expr, wanted: Dimension, dimension: Mapping) -> list[Misfit]:
    symbols = sorted(term.free_symbols, key=str)
    own = [dimension[s].exponents for s in symbols]
    bases = sorted({base for exponents in own for base in exponents} | set(wanted.exponents))
    if term == 0:
        return []
    found = []
    for base, powers in zip(bases, _powers(where, term, symbols, own, bases), strict=True):
        right = float(wanted.exponents.get(base, 0))
        if not all(abs(power - right) <= CLOSE for power in powers):
            alike = abs(powers[0] - powers[1]) <= CLOSE
            found.append(Misfit(where, sp.sstr(term), base, powers[0] if alike else math.nan, right))
    return found


def _powers(where, term, symbols, own, bases) -> list[list[float]]:
    """The powers with which a term scales: one list a base dimension, one power a factor."""
    value = sp.lambdify(symbols, term, "math")
    rng = random.Random(sp.sstr(term))
    for _ in range(TRIES):
        point = [rng.uniform(0.5, 2.0) for _ in symbols]
        try:
            begin = value(*point)
            there = [
                [
                    value(*(x * k ** float(e.get(base, 0)) for x, e in zip(point, own, strict=True))) / begin
                    for k in FACTORS
                ]
                for base in bases
            ]
            return [[_logarithm(r) / math.log(k) for r, k in zip(row, FACTORS, strict=True)] for row in there]
        except (ValueError, TypeError, ZeroDivisionError, OverflowError):
            continue  # outside of the domain of a root, a logarithm, an arc
    raise ArithmeticError(f"{where}: {sp.sstr(term)} has no real value at any of {TRIES} positive points")


def _logarithm(ratio: float) -> float:
    return math.log(ratio) if ratio > 0 else math.nan
