"""Exact constraints of a table: the null space of a few centred columns (pi1 + pi2 = 1).

Invariant: a constraint holds on every row to the digits of a table, and none contains another.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

FEWEST = {2: 5, 3: 8}  # rows for a constraint of so many groups
OF_SPREAD = 0.02  # largest rms residual, as a share of what each column's spread adds to the sum
LEAST = 0.01  # share of the column that adds least
OF_VALUE = 1e-3  # and as a share of the values: tables have four digits


def find_constraints(values: NDArray, names: Sequence[str]) -> list[dict[str, float]]:
    """Find sums of two or three columns that are the same on every row.

    Parameters
    ----------
    values : (n, q) groups, not their logarithms; NaN where not known.    names : (q,).

    Returns
    -------
    list of dict     name -> coefficient, the first one 1; "constant", what they add up to; "rows".
    """
    found: list[dict[str, float]] = []
    for size, fewest in FEWEST.items():
        for places in itertools.combinations(range(len(names)), size):
            if any(set(one) - {"constant", "rows"} <= {names[j] for j in places} for one in found):
                continue
            block = values[:, places]
            block = block[np.isfinite(block).all(axis=1)]
            if len(np.unique(block, axis=0)) >= fewest and (one := _null(block)) is not None:
                coefficients, constant = one
                named = {names[j]: c for j, c in zip(places, coefficients, strict=True)}
                found.append(named | {"constant": constant, "rows": float(len(block))})
    return found


def _null(block: NDArray) -> tuple[list[float], float] | None:
    spread = block.std(axis=0)
    if (spread <= 1e-9 * np.abs(block).mean(axis=0)).any():
        return None
    centred = (block - block.mean(axis=0)) / spread
    _, _, vectors = np.linalg.svd(centred, full_matrices=False)
    share = np.abs(vectors[-1]).min()  # of the column that the sum needs least
    left = (centred @ vectors[-1]).std()
    if share < LEAST or left > OF_SPREAD * share:
        return None
    direction = vectors[-1] / spread
    direction = direction / direction[0]
    sums = block @ direction
    if sums.std() > OF_VALUE * np.abs(block * direction).sum(axis=1).mean():
        return None
    rounded = np.array([round(float(c) * 12) / 12 for c in direction])
    if np.allclose(rounded, direction, rtol=1e-2) and np.std(block @ rounded) <= 2 * sums.std() + 1e-9:
        direction, sums = rounded, block @ rounded
    constant = float(sums.mean())
    return [float(c) for c in direction], round(constant, 3) if abs(
        constant - round(constant, 3)
    ) < 1e-4 else constant
