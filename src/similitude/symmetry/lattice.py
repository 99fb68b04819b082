"""Integer matrices: Hermite form with its unimodular multiplier, kernels, canonical bases.

    A V = [H 0]      A integer (m, n), V unimodular (n, n), H a column Hermite form of full column rank
    V = [V_i V_n]    the columns of V_n are a basis of the integer kernel of A

V is not unique; it is made so: V_n is in Hermite form itself, and V_i is reduced by V_n and by nothing
else that could be chosen. Exponents that come from V are then short and the same on every machine.

Invariant: everything is Python integers, exact at any size; no floating point, no fractions.

References: Hubert & Labahn 2013, section 2 (Hermite multiplier, normal form).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

Vector = list[int]


@dataclass(frozen=True)
class Hermite:
    """A V = [H 0]: ``form`` (m, rank), ``multiplier`` V (n, n), ``rank`` of A; rows of integers."""

    form: list[Vector]
    multiplier: list[Vector]
    rank: int


def hermite(matrix: Sequence[Sequence[int]], width: int) -> Hermite:
    """Column Hermite form of an integer matrix and the multiplier that makes it.

    Parameters
    ----------
    matrix : m rows of `width` integers; m may be 0.
    width : number of columns n.

    Returns
    -------
    Hermite    pivots positive, entries left of a pivot in [0, pivot); the multiplier normalised.
    """
    height = len(matrix)
    columns = [[row[j] for row in matrix] + [int(i == j) for i in range(width)] for j in range(width)]
    rank = _echelon(columns, 0, range(height))
    free = columns[rank:]  # V_n, with zeros above it
    pivots: list[int] = []
    _echelon(free, 0, range(height, height + width), pivots)
    for column in columns[:rank]:
        for k, row in enumerate(pivots):
            _subtract(column, free[k], column[row] // free[k][row])
    whole = columns[:rank] + free
    return Hermite(
        form=[[whole[j][i] for j in range(rank)] for i in range(height)],
        multiplier=[[c[height + i] for c in whole] for i in range(width)],
        rank=rank,
    )


def kernel(matrix: Sequence[Sequence[int]], width: int) -> list[Vector]:
    """Canonical basis of the integer vectors v (width) with A v = 0, first pivot leftmost."""
    found = hermite(matrix, width)
    return [[row[j] for row in found.multiplier] for j in range(found.rank, width)]


def canonical(vectors: Sequence[Sequence[int]], width: int) -> list[Vector]:
    """The row Hermite basis of the lattice that integer vectors (width) span: zeros are dropped."""
    rows = [list(v) for v in vectors]
    return rows[: _echelon(rows, 0, range(width))]


def saturated(vectors: Sequence[Sequence[int]], width: int) -> list[Vector]:
    """Canonical basis of all integer vectors in the rational span of some vectors (width)."""
    return kernel(kernel(vectors, width), width)


def integers(vector: Sequence[Fraction | int]) -> Vector:
    """The shortest integer vector along a rational one, its first entry that is not zero positive."""
    exact = [Fraction(x) for x in vector]
    shared = lcm(*(x.denominator for x in exact))
    whole = [int(x * shared) for x in exact]
    divisor = gcd(*whole) or 1
    sign = next((-1 if x < 0 else 1 for x in whole if x), 1)
    return [sign * x // divisor for x in whole]


def solved(square: Sequence[Sequence[int]], right: Sequence[Sequence[int]]) -> list[list[Fraction]] | None:
    """X with square X = right, exactly; None where the square matrix (n, n) is singular."""
    n = len(square)
    rows = [[Fraction(x) for x in (*a, *b)] for a, b in zip(square, right, strict=True)]
    for k in range(n):
        pivot = next((i for i in range(k, n) if rows[i][k]), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k and rows[i][k]:
                factor = rows[i][k]
                rows[i] = [x - factor * y if y else x for x, y in zip(rows[i], rows[k], strict=True)]
    return [row[n:] for row in rows]


def _echelon(columns: list[Vector], first: int, rows: range, pivots: list[int] | None = None) -> int:
    """Bring vectors to echelon form along some of their entries, in place; how many are not zero there."""
    for row in rows:
        while True:
            alive = [j for j in range(first, len(columns)) if columns[j][row]]
            if len(alive) <= 1:
                break
            best = min(alive, key=lambda j: (abs(columns[j][row]), sum(map(abs, columns[j])), j))
            for j in alive:
                if j != best:
                    _subtract(columns[j], columns[best], columns[j][row] // columns[best][row])
        if not alive:
            continue
        columns[first], columns[alive[0]] = columns[alive[0]], columns[first]
        if columns[first][row] < 0:
            columns[first] = [-x for x in columns[first]]
        for j in range(first):
            _subtract(columns[j], columns[first], columns[j][row] // columns[first][row])
        if pivots is not None:
            pivots.append(row)
        first += 1
    return first


def _subtract(vector: Vector, other: Vector, times: int) -> None:
    if times:
        for i, x in enumerate(other):
            if x:
                vector[i] -= times * x
