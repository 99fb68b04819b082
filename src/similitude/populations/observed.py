"""Groups that a table gives although it does not give the model's: Iz/(m a b) where only a b is known.

Invariant: each is a dimensionless product of columns, exact, and no product of groups the rows give.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import sympy as sp

from similitude.populations.coordinates import Product
from similitude.populations.monomial import monomial_text
from similitude.populations.population import Population
from similitude.populations.table import dimension_of

FEWEST = 8  # rows that must give one


def observed_groups(population: Population) -> dict[str, Product]:
    """Dimensionless products of the columns of many rows, where the rows do not give the groups.

    Parameters
    ----------
    population : Population

    Returns
    -------
    dict     formula -> exponents over the parameters, smallest integers.
    """
    table, found = population.table, {}
    known = np.isfinite(table.value)
    for pattern in np.unique(known, axis=0):
        rows = (known == pattern).all(axis=1)
        if rows.sum() < FEWEST or np.isfinite(population.logs[rows]).any():
            continue
        columns = [table.products[j] for j in np.flatnonzero(pattern)]
        for vector in _null_space(population, columns):
            product: dict[str, Fraction] = {}
            for power, column in zip(vector, columns, strict=True):
                for name, exponent in column.items():
                    product[name] = product.get(name, Fraction(0)) + power * exponent
            product = {name: power for name, power in product.items() if power}
            if product:
                found[monomial_text(product)] = product
    return found


def _null_space(population: Population, columns: list[Product]) -> list[list[Fraction]]:
    dimensions = [dimension_of(population.groups.model, column).exponents for column in columns]
    rows = sorted({name for one in dimensions for name in one})
    if not rows:
        return []
    matrix = sp.Matrix([[sp.Rational(str(one.get(name, 0))) for one in dimensions] for name in rows])
    result = []
    for vector in matrix.nullspace():
        powers = [Fraction(int(x.p), int(x.q)) for x in vector]
        scale = math.lcm(*(p.denominator for p in powers))
        first = next(p for p in powers if p)
        result.append([p * scale * (1 if first > 0 else -1) for p in powers])
    return result
