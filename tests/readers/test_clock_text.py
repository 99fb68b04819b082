"""Dates with a time of day become seconds; everything else is left alone."""

import datetime

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.readers.clock_text import clock_seconds, days_of, looks_like_clock


@given(st.datetimes(datetime.datetime(1975, 1, 1), datetime.datetime(2100, 1, 1)), st.sampled_from("T "))
def test_a_date_is_the_seconds_of_the_calendar(when, between):
    """Python's own calendar is the other route; a float of these seconds has steps of 5e-7 s."""
    expected = when.replace(tzinfo=datetime.UTC).timestamp()

    (got,) = clock_seconds([when.isoformat(sep=between)])

    assert got == pytest.approx(expected, abs=5e-7, rel=0)


def test_zones_are_taken_off_and_what_is_no_date_is_missing():
    same = [
        "2024-05-01T12:00:00Z",
        "2024-05-01 14:00:00+02:00",
        "2024-05-01T07:30:00 -0430",
        "2024-13-01T00:00:00",
    ]

    seconds = clock_seconds([*same, ""])

    assert seconds[0] == seconds[1] == seconds[2] == 1714564800.0
    assert np.isnan(seconds[3:]).all()


@pytest.mark.parametrize("cell", ["12:00", "2024", "0.25", "", "2024-05-01", "nan", "12:00:0x", "3:07"])
def test_a_number_or_half_a_date_is_no_clock(cell):
    assert not looks_like_clock(cell)


@pytest.mark.parametrize(
    ("cell", "seconds"),
    [
        ("12:00:00", 43200),
        ("00:00:00,25", 0.25),
        ("9:08:07.5", 32887.5),
        ("12:00:01 AM", 1),
        ("12:00:01 pm", 43201),
        ("25.10.2026 01:00:00.000", 3600),
        ("10/25/2026 1:00:00 PM", 46800),
        ("3:07.25", 187.25),
    ],
)
def test_a_time_of_day_is_seconds_since_midnight(cell, seconds):
    assert looks_like_clock(cell)
    assert clock_seconds([cell]) == pytest.approx([seconds], abs=1e-9)


def test_dates_in_the_order_of_a_country_are_listed_and_iso_dates_are_not():
    cells = ["25.10.2026 23:59:59", "26.10.2026 00:00:00", "2026-10-25 12:00:00", "12:00:00", "?"]

    assert days_of(cells) == ["25.10.2026", "26.10.2026"]
