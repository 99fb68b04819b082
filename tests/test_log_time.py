"""Faults of time: refused with row and value, or said in a warning."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.log_time import check_time


def time_of(t, *, header="t [s]", factor=1.0):
    return check_time(np.asarray(t, float), header=header, factor=factor, file="drive.csv")


def even(samples=300, step=0.01):
    return np.arange(samples) * step


def edited(row, value):
    t = even()
    t[row - 1 :] = t[row - 1 :] + value
    return t


def test_even_time_is_accepted_in_silence():
    assert time_of(even()) == []


@given(st.integers(0, 2**32 - 1), st.floats(-1e9, 1e9))
def test_jitter_below_the_usual_step_is_no_fault(seed, start):
    steps = np.random.default_rng(seed).uniform(0.006, 0.0139, size=400)

    # The median is above 0.009 or so, and 1.8 of it above every step; at 1e9 s a float still
    # has 1e-7 s of digits.
    assert [one.fault for one in time_of(start + np.cumsum(steps))] in ([], ["time_since_epoch"])


REFUSED = {
    "repeated": (
        edited(18, -0.01),
        "repeats in data row 18: 0.16 is followed by 0.16; steps that do not rise: 1",
    ),
    "backward": (edited(18, -0.05), "runs backward in data row 18: 0.16 is followed by 0.12"),
    "unsorted": (
        even()[::-1],
        "runs backward in data row 2: 2.99 is followed by 2.98; steps that do not rise: 299",
    ),
    "constant": (np.full(300, 3.0), "is 3 in all 300 rows"),
    "clock was set": (edited(18, 1e6), r"jumps by 1e\+06 s in data row 18"),
    "a blank": (np.where(even() == 0.05, np.nan, even()), "no value in data row 6, and in 1 of"),
    "empty": (np.full(300, np.nan), "in 300 of 300 rows"),
    "few rows": (even(19), "drive.csv has 19 rows; 20 are the least"),
    "short": (even(100), "lasts 0.99 s; 2 s are the least"),
    "slow": (even(100, 3.0), "usual step is 3 s, too slow"),
    "fast": (even(300, 1e-6), "too fast"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_a_fault_of_time_is_refused_with_row_and_value(case):
    t, what = REFUSED[case]

    found = time_of(t)[0]

    assert found.certain
    assert re.search(what, found.what)
    assert "drive.csv" in found.what
    assert all([found.usually, found.paste, found.read])


@pytest.mark.parametrize(("unit", "step"), [("ms", 10.0), ("us", 1e4), ("ns", 1e7)])
def test_time_in_another_unit_is_refused_with_the_guess(unit, step):
    found = time_of(even(300, step), header="time [s]")[0]

    assert f"look like {unit}" in found.usually
    assert found.paste == f"time [{unit}]"


def test_values_are_shown_in_the_unit_of_the_column():
    (found,) = time_of(edited(18, -0.05), header="t [ms]", factor=1e-3)

    assert "160 is followed by 120" in found.what


def test_a_long_gap_is_said_with_place_and_length():
    (said,) = time_of(edited(18, 20.0))

    assert said.what.startswith("gap of 20 s after t = 0.16 s (data row 18)")
    assert "restarts" in said.what
    assert not said.certain


def test_many_long_gaps_are_counted():
    t = even() + np.cumsum(np.arange(300) % 20 == 19) * 2.0

    said = time_of(t)

    assert len(said) == 6
    assert said[-1].what.startswith("10 more gaps")


def test_short_gaps_are_counted():
    assert time_of(edited(18, 0.1))[0].what.startswith("1 short gap")


@pytest.mark.parametrize("every", [2, 5, 100])
def test_rounded_times_are_told_from_rows_that_were_written_twice(every):
    t = np.arange(1000) * 0.01
    rounded = np.floor(t / (every * 0.01) + 1e-6) * every * 0.01

    (found,) = check_time(rounded, header="t [s]", factor=1.0, file="drive.csv")
    assert (found.fault, found.fix, found.certain) == ("time_coarse", "spread_times", True)
    twice = np.sort(np.r_[t, t[::50]])
    (found,) = check_time(twice, header="t [s]", factor=1.0, file="drive.csv")
    assert found.fault == "time_repeats"


@pytest.mark.parametrize(("step", "paste"), [(0.01 / 3600, "t [h]"), (0.01 / 86400, "t [d]")])
def test_hours_and_days_are_told_by_the_step(step, paste):
    found = check_time(np.arange(9000) * step, header="t [s]", factor=1.0, file="drive.csv")

    assert paste in [one.paste for one in found]


def test_fewer_than_five_rows_a_second_are_refused():
    """Measured on simulated drives: at 5 Hz the intervals hold, at 4 Hz K reads a third too low."""
    slow, enough = (
        check_time(np.arange(90) * step, header="t [s]", factor=1.0, file="x") for step in (0.25, 0.2)
    )

    assert [one.fault for one in slow] == ["time_unit"] and enough == []
