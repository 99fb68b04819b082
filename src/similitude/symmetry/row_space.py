"""Row spaces of residues and of long numbers: reduced rows, null vectors, and fractions read back.

Invariant: in residues a rank is the rank, up to the choice of the prime; in long numbers what is smaller
than FLAT of its row's largest entry is zero, with half the digits to spare on both sides.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np

from similitude.symmetry.arithmetic import PRIME
from similitude.symmetry.lattice import integers
from similitude.symmetry.residues import eliminate, fraction_of

FLAT = mpmath.mpf(10) ** -25
LARGEST = 10**3  # numerator and denominator of an exponent
CLOSE = 1e-15  # long numbers this near a small fraction are it


def reduced(matrix: np.ndarray) -> tuple[np.ndarray, list[int]]:
    """Reduced row echelon form of residues (int64) or mpmath numbers (object), and its pivots."""
    return eliminate(matrix) if matrix.dtype == np.int64 else _eliminate_digits(matrix)


def null_vectors(matrix: np.ndarray) -> np.ndarray:
    """Rows (n - rank, n) that the matrix (m, n) sends to zero."""
    rows, pivots = reduced(matrix)
    width = matrix.shape[1]
    free = [j for j in range(width) if j not in pivots]
    found = np.zeros((len(free), width), dtype=matrix.dtype)
    for i, j in enumerate(free):
        found[i, j] = 1
        for k, pivot in enumerate(pivots):
            found[i, pivot] = -rows[k, j]
    return found % PRIME if matrix.dtype == np.int64 else found


def whole_rows(matrix: np.ndarray) -> list[list[int]]:
    """The reduced rows as shortest integers, for questions about vectors that they send to zero.

    A row that is no small fraction, as irrational exponents make it, is answered with a row for each of its
    entries: nothing is then said about these columns rather than something wrong.
    """
    found = []
    for row in reduced(matrix)[0]:
        exact = [_exact(x) for x in row]
        if None not in exact:
            found.append(integers(exact))
        else:
            found += [[int(j == k) for j in range(len(row))] for k, x in enumerate(row) if x]
    return found


def _exact(value) -> Fraction | None:
    if isinstance(value, (int, np.integer)):
        near = fraction_of(int(value))
        return near if max(abs(near.numerator), near.denominator) <= LARGEST else None
    near = Fraction(mpmath.nstr(value, 30)).limit_denominator(LARGEST)
    return near if abs(mpmath.mpf(near.numerator) / near.denominator - value) < CLOSE else None


def _eliminate_digits(matrix: np.ndarray) -> tuple[np.ndarray, list[int]]:
    rows = matrix.copy()
    for i, row in enumerate(rows):
        size = max((abs(x) for x in row), default=0)
        if size:
            rows[i] = row / size
    pivots: list[int] = []
    for j in range(rows.shape[1]):
        k = len(pivots)
        if k == len(rows):
            break
        best = max(range(k, len(rows)), key=lambda i: abs(rows[i, j]))
        if abs(rows[best, j]) < FLAT:
            continue
        rows[[k, best]] = rows[[best, k]]
        rows[k] = rows[k] / rows[k, j]
        for i in range(len(rows)):
            if i != k and rows[i, j]:
                rows[i] = rows[i] - rows[i, j] * rows[k]
        pivots.append(j)
    return rows[: len(pivots)], pivots
