"""What a few independent columns span, in integers: the algebra below every Pi group.

    T [base | c] = det [I | x]        T, det  row operations and pivot, integers throughout
                   [0 | 0]            x       exponents of the base that make up the column c

Elimination is fraction-free (Bareiss 1968, in Jordan's variant): every division is exact, so no
fraction is formed before an answer is read. T is the adjugate of the base where that is square.

Invariant: the columns held are independent, and nothing is ever rounded.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import mul

Column = tuple[Fraction | int, ...]


@dataclass(frozen=True)
class Span:
    """The span of r independent columns of d exact numbers.

    Parameters
    ----------
    operations : (d, d) integers, the row operations T.
    pivot : the determinant det of the r pivot rows, up to sign; 1 while r = 0.
    scales : (r,) integers that made each column one of integers.
    """

    operations: tuple[tuple[int, ...], ...]
    pivot: int
    scales: tuple[int, ...]

    @property
    def rank(self) -> int:
        """Number of columns held."""
        return len(self.scales)

    def _seen(self, column: Column) -> tuple[int, list[int]]:
        """The column's integer scale, and T times the scaled column."""
        scale = math.lcm(*[x.denominator for x in column])
        whole = [x.numerator * (scale // x.denominator) for x in column]
        return scale, [sum(map(mul, row, whole)) for row in self.operations]

    def solve(self, column: Column) -> tuple[list[int], int] | None:
        """Integers n (r,) and N with  base n = N column, or None where the column lies outside.

        Parameters
        ----------
        column : (d,) exact numbers.
        """
        scale, seen = self._seen(column)
        if any(seen[self.rank :]):
            return None
        return [x * own for x, own in zip(seen, self.scales, strict=False)], self.pivot * scale

    def exponents(self, column: Column) -> tuple[Fraction, ...] | None:
        """Exponents x (r,) with  base x = column, or None where the column lies outside.

        Parameters
        ----------
        column : (d,) exact numbers.
        """
        solved = self.solve(column)
        if solved is None:
            return None
        numerators, over = solved
        return tuple(Fraction(x, over) for x in numerators)

    def holds(self, column: Column) -> bool:
        """Whether the column is a combination of those held."""
        return not any(self._seen(column)[1][self.rank :])

    def extended(self, column: Column) -> Span | None:
        """The span with one more column, or None where that column is already in it.

        Parameters
        ----------
        column : (d,) exact numbers.
        """
        scale, seen = self._seen(column)
        at = next((k for k in range(self.rank, len(seen)) if seen[k]), None)
        if at is None:
            return None
        rows = [list(row) for row in self.operations]
        r = self.rank
        rows[r], rows[at] = rows[at], rows[r]
        seen[r], seen[at] = seen[at], seen[r]
        lead, chosen, before = seen[r], rows[r], self.pivot
        done = tuple(
            tuple(chosen)
            if k == r
            else tuple((lead * x - seen[k] * y) // before for x, y in zip(row, chosen, strict=True))
            for k, row in enumerate(rows)
        )
        return Span(done, lead, (*self.scales, scale))


def empty_span(size: int) -> Span:
    """The span of nothing in d = ``size`` dimensions; it holds only the zero column."""
    identity = tuple(tuple(int(i == j) for j in range(size)) for i in range(size))
    return Span(identity, 1, ())


def span_of(columns: Sequence[Column], size: int) -> Span | None:
    """The span of columns (r of d = ``size`` numbers), or None where they are dependent."""
    span: Span | None = empty_span(size)
    for column in columns:
        span = span.extended(column)
        if span is None:
            return None
    return span


def leading(columns: Sequence[Column], size: int) -> tuple[tuple[int, ...], Span]:
    """The first columns that are independent of those before them, and their span.

    Parameters
    ----------
    columns : n of d = ``size`` exact numbers.

    Returns
    -------
    places, span : indices of the r columns taken, increasing, and what they span.
    """
    span, taken, seen = empty_span(size), [], set()
    most = sum(map(any, zip(*columns, strict=True)))  # rows that are used at all
    for place, column in enumerate(columns):
        if span.rank == most:
            break
        if column in seen:
            continue
        seen.add(column)
        wider = span.extended(column)
        if wider is not None:
            span = wider
            taken.append(place)
    return tuple(taken), span


def smallest_integers(numbers: Iterable[Fraction | int]) -> tuple[int, ...]:
    """The numbers times one factor: integers without common divisor, the first non-zero positive.

    Parameters
    ----------
    numbers : (n,) exact numbers.

    Examples
    --------
    >>> smallest_integers([Fraction(-1, 2), Fraction(0), Fraction(1, 3)])
    (3, 0, -2)
    """
    numbers = tuple(numbers)
    scale = math.lcm(*[x.denominator for x in numbers])
    whole = [x.numerator * (scale // x.denominator) for x in numbers]
    divisor = math.gcd(*whole) or 1
    if next((x for x in whole if x), 1) < 0:
        divisor = -divisor
    return tuple(x // divisor for x in whole)
