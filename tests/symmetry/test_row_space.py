"""Ranks and null vectors in residues and in long numbers agree with SymPy's."""

import mpmath
import numpy as np
import pytest
import sympy as sp

from similitude.symmetry.arithmetic import PRIME
from similitude.symmetry.row_space import null_vectors, reduced, whole_rows

ROWS = [[1, 2, 3, 4], [2, 4, 1, 3], [3, 6, 4, 7], [0, 0, 0, 0]]


def as_residues(rows):
    return np.array([[x % PRIME for x in row] for row in rows], dtype=np.int64)


def as_digits(rows):
    return np.array([[mpmath.mpf(x) for x in row] for row in rows], dtype=object)


@pytest.mark.parametrize("make", [as_residues, as_digits])
def test_rank_pivots_and_null_vectors(make):
    with mpmath.workdps(60):
        rows, pivots = reduced(make(ROWS))
        null = null_vectors(make(ROWS))

        assert len(rows) == sp.Matrix(ROWS).rank()
        assert tuple(pivots) == sp.Matrix(ROWS).rref()[1]
        for row in ROWS:
            for v in null:
                total = sum(
                    int(x) * (int(y) if make is as_residues else y) for x, y in zip(row, v, strict=True)
                )
                assert (total % PRIME if make is as_residues else abs(total) < 1e-40) in (0, True)


@pytest.mark.parametrize("make", [as_residues, as_digits])
def test_rows_come_back_as_whole_numbers(make):
    with mpmath.workdps(60):
        assert whole_rows(make([[3, 0, 1], [0, 2, -1]])) == [[3, 0, 1], [0, 2, -1]]


def test_nothing_is_said_about_columns_of_a_row_that_is_no_fraction():
    with mpmath.workdps(60):
        assert whole_rows(np.array([[mpmath.mpf(1), mpmath.pi, 0]], dtype=object)) == [[1, 0, 0], [0, 1, 0]]
    assert whole_rows(np.array([[1, 1234567891, 0]])) == [[1, 0, 0], [0, 1, 0]]


def test_no_rows_leave_everything():
    assert null_vectors(np.zeros((0, 3), dtype=np.int64)).tolist() == np.eye(3, dtype=int).tolist()
