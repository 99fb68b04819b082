"""Which variables serve as units of the others: as many as there are scalings.

    A = weights (r, n)      B = r of its columns, invertible      X = A_B^-1 A
    y_j = z_j prod_b z_b^-X_bj does not change under any scaling

Parameters are taken before states, states before signals, time last; among equals in the order given.
Where a choice with whole exponents exists near the first one, it is taken.

Invariant: X is exact, and its columns at the base are those of the unit matrix.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from similitude.symmetry.lattice import solved


def choose_base(weights: Sequence[Sequence[int]], preference: Sequence[int]) -> list[int]:
    """Columns of a base.

    Parameters
    ----------
    weights : r independent rows of n integers.
    preference : for each column its class, smaller is taken earlier.

    Returns
    -------
    list of int    r columns, ascending.
    """
    order = sorted(range(len(preference)), key=lambda j: (preference[j], j))
    base = _first_independent(weights, order)
    while True:
        powers = exponents(weights, base)
        swap = next(
            (
                (b, j)
                for j in order
                for i, b in enumerate(base)
                if preference[j] <= preference[b] and 0 < abs(powers[i][j]) < 1
            ),
            None,
        )
        if swap is None:  # each swap makes the determinant smaller, so this ends
            return sorted(base)
        base[base.index(swap[0])] = swap[1]


def exponents(weights: Sequence[Sequence[int]], base: Sequence[int]) -> list[list[Fraction]]:
    """X (r, n): the exponents by which the base makes up each variable's weight."""
    square = [[row[b] for b in base] for row in weights]
    found = solved(square, weights)
    assert found is not None, "the base is dependent"
    return found


def _first_independent(weights: Sequence[Sequence[int]], order: Sequence[int]) -> list[int]:
    rows = [[Fraction(row[j]) for j in order] for row in weights]
    base: list[int] = []
    for place, j in enumerate(order):
        k = len(base)
        pivot = next((i for i in range(k, len(rows)) if rows[i][place]), None)
        if pivot is None:
            continue
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, len(rows)):
            if rows[i][place]:
                factor = rows[i][place] / rows[k][place]
                rows[i] = [x - factor * y if y else x for x, y in zip(rows[i], rows[k], strict=True)]
        base.append(j)
        if len(base) == len(rows):
            break
    return base
