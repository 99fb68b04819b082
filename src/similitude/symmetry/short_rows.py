"""Rows of whole numbers with few entries: what spans the same beside given rows, said in fewer names.

Invariant: each step adds a multiple of another row, so rows that were independent of one another and of
the given ones stay so.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from similitude.symmetry.lattice import integers

MULTIPLES = (-3, -2, -1, 1, 2, 3)


def shortened(rows: Sequence[Sequence[int]], given: Sequence[Sequence[int]]) -> list[list[int]]:
    """Make rows shorter by adding multiples of one another and of given rows.

    Parameters
    ----------
    rows : k rows of n whole numbers, independent of one another and of the given ones.
    given : rows of n whole numbers that may be added freely.

    Returns
    -------
    list of k rows    each with as few entries, then as small ones, as single steps lead to; shortest integers
                      with the first entry positive. The same for the same rows in the same order.
    """
    short = [integers(row) for row in rows]
    while True:
        step = min(_steps(short, given), default=None)
        if step is None:
            return short
        _, place, row = step
        short[place] = row


def _steps(short: list[list[int]], given: Sequence[Sequence[int]]):
    """Every single step that makes a row shorter."""
    for place, row in enumerate(short):
        others = [*given, *(other for k, other in enumerate(short) if k != place)]
        for other, times in product(others, MULTIPLES):
            new = integers([x + times * y for x, y in zip(row, other, strict=True)])
            if _length(new) < _length(row):
                yield _gain(new, row), place, new


def _length(row: Sequence[int]) -> tuple[int, int]:
    return sum(map(bool, row)), sum(map(abs, row))


def _gain(new: Sequence[int], old: Sequence[int]) -> tuple[int, int]:
    """Negative where it is shorter; the largest gain comes first."""
    return _length(new)[0] - _length(old)[0], _length(new)[1] - _length(old)[1]
