"""Missing, slow and stuck columns: refused, or said in a warning."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.log_cells import check_column, slower_by


def column_of(values, *, may_rest=False):
    return check_column(
        np.asarray(values, float), header="r [deg/s]", file="drive.csv", may_rest=may_rest, held=False
    )


@given(st.integers(1, 50))
def test_missing_cells_up_to_half_are_counted_with_the_first_row(count):
    values = np.arange(100.0)
    values[10 : 10 + count] = np.nan

    (said,) = column_of(values)

    assert f"{count} of 100 cells" in said.what
    assert "first in data row 11" in said.what


@pytest.mark.parametrize(
    ("values", "what"),
    [
        (np.full(100, np.nan), r"column 'r \[deg/s\]' of drive.csv is empty"),
        (np.r_[np.arange(49.0), np.full(51, np.nan)], "no number in 51 of 100 rows.*data row 50"),
        (np.full(51, 0.25), "is stuck: it is 0.25 .* in all 51 rows"),
        (np.r_[np.full(60, 1.0), np.full(40, np.nan)], "is stuck"),
    ],
)
def test_an_empty_or_stuck_column_is_refused(values, what):
    (found,) = column_of(values)

    assert found.certain
    assert re.search(what, found.what)


def test_a_constant_speed_and_a_short_constant_are_no_fault():
    assert column_of(np.full(1000, 20.0), may_rest=True) == []
    assert column_of(np.full(50, 20.0)) == []


@given(st.integers(2, 20), st.integers(0, 19), st.integers(0, 99))
def test_a_regularly_slower_column_is_accepted_and_its_rate_said(every, start, seed):
    """One cell in twenty is lost on top, which leaves nine distances in ten as they were."""
    values = np.full(100 * every, np.nan)
    rows = np.arange(start % every, values.size, every)
    rows = np.delete(rows, np.random.default_rng(seed).integers(0, rows.size, 4))
    values[rows] = np.sin(rows)

    (found,) = column_of(values)

    assert not found.certain
    assert found.fault == "column_slower"
    assert found.value == pytest.approx(every)


def test_a_sensor_that_failed_for_most_of_the_drive_is_no_slower_sensor():
    values = np.arange(1000.0)
    values[np.random.default_rng(0).random(1000) < 0.7] = np.nan

    assert slower_by(values) is None
    assert column_of(values)[0].fault == "column_mostly_empty"
