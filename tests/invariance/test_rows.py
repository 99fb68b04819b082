"""A row reads like the paper's, sums what it is given, and is solved for what is missing."""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import Measure
from similitude.invariance.rows import Row, rows_of, solve_rows
from similitude.units import LENGTH, MASS, TIME

ARGUMENTS = {
    "m": Measure(MASS),
    "U": Measure(LENGTH / TIME),
    "C": Measure(MASS * LENGTH / TIME**2),
    "w": Measure((LENGTH / TIME) ** Fraction(1, 2)),
    "n": Measure(),
}
ROWS = rows_of(ARGUMENTS, Measure(TIME**-1))


def test_there_is_one_row_for_each_dimension_that_occurs():
    assert [str(row) for row in ROWS] == [
        "mass: S_m + S_C = 0",
        "length: S_U + S_C + (1/2) S_w = 0",
        "time: -S_U - 2 S_C - (1/2) S_w = -1",
    ]


def test_without_dimensions_there_is_no_row_or_an_empty_one_where_it_is_asked_for():
    assert rows_of({"n": Measure()}, Measure()) == ()
    (row,) = rows_of({"n": Measure()}, Measure(), ["time"])
    assert row.is_empty and str(row) == "time: 0 = 0" and row.left_side({}) == 0


def test_the_left_side_takes_numbers_arrays_fractions_and_expressions():
    S = sp.Symbol("S")

    assert ROWS[0].left_side({"m": 1.5, "C": -0.5}) == 1.0
    assert ROWS[0].left_side({"m": np.ones(2), "C": np.ones(2)}).tolist() == [2, 2]
    assert ROWS[1].left_side({"U": 1, "C": Fraction(1, 3), "w": 1}) == Fraction(11, 6)
    assert ROWS[0].left_side({"m": S, "C": 2 * S}) == 3 * S
    assert ROWS[2].left_side({"U": 1, "C": 5, "w": 2}, leave_out=["C"]) == -2


def test_as_many_are_found_as_there_are_rows_and_fewer_too():
    truth = {"C": Fraction(3), "w": Fraction(1), "U": Fraction(-7, 2), "m": Fraction(-3)}

    assert solve_rows(ROWS, ["m"], truth) == {"m": -3}
    assert solve_rows(ROWS, ["m", "U"], {"C": Fraction(3), "w": 1}) == {"m": -3, "U": Fraction(-7, 2)}
    assert solve_rows(ROWS, [], truth) == {}


@pytest.mark.parametrize(
    ("names", "known", "said"),
    [
        (["U", "w"], {}, "columns have rank 1"),
        (["m", "U", "C", "w"], {}, "rank 3"),
        (["n"], {}, "rank 0"),
        (["m"], {}, "the sensitivity to C is missing"),
    ],
)
def test_what_the_rows_cannot_tell_is_refused(names, known, said):
    with pytest.raises(ModelError, match=said):
        solve_rows(ROWS, names, known)


def test_a_row_is_a_value():
    assert Row("mass", {"m": Fraction(1)}, Fraction(0)) == Row("mass", {"m": Fraction(1)}, Fraction(0))
