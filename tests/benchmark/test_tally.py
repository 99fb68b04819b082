"""Rows of numbers from scores made by hand."""

import math

import numpy as np
import pytest

from similitude.benchmark.scoring import THRESHOLDS, Score
from similitude.benchmark.tally import delay_at, tally, threshold_of, upper_bound


def made(rms=0.1, found=1.0, largest=0.1, **more):
    return Score(
        "", rms=rms, bias=0.0, coverage=0.95, half_way=1.0, found=found, hours=50 / 3600, largest=largest,
        late=np.where(THRESHOLDS < 0.5, 2.0, np.inf), seconds=1.0, rows=1000, **more,
    )  # fmt: skip


def test_drives_are_pooled_and_the_median_is_kept_beside():
    row = tally([made(0.1), made(0.1), made(0.4)], 0.2)

    assert row["rms"] == pytest.approx(math.sqrt((0.01 + 0.01 + 0.16) / 3)) and row["rms_median"] == 0.1
    assert row["call_ns"] == pytest.approx(1e6) and row["step_ns"] is None


def test_what_diverged_is_counted_and_not_averaged():
    row = tally([made(), Score("ValueError: no")], 0.2)

    assert row["drives"] == 2 and row["diverged"] == 1 and row["rms"] == pytest.approx(0.1)
    assert tally([Score("no")], 0.2)["rms"] is None


def test_a_missed_change_stays_missed_in_the_median():
    row = tally([made(found=math.inf), made(found=math.inf), made(found=1.0)], 0.2)

    assert row["alarm_s"] == math.inf and row["missed"] == pytest.approx(2 / 3)


def test_the_threshold_rings_as_often_as_it_is_said_to():
    """A hundred drives of 30 s are 0.83 h: none may ring; 240 are two hours: two may."""
    falls = np.linspace(0.01, 0.5, 240).tolist()
    few, hours = threshold_of([made(largest=x) for x in falls[:100]])
    many, _ = threshold_of([made(largest=x) for x in falls])

    assert hours == pytest.approx(100 * 30 / 3600)
    assert sum(x > few for x in falls[:100]) == 0 and sum(x > many for x in falls) == 2
    assert threshold_of([]) == (math.inf, 0.0)


def test_the_delay_is_read_at_the_threshold():
    assert delay_at(made(), 0.2) == 2.0 and delay_at(made(), 1.0) == math.inf
    assert delay_at(made(), 10.0) == math.inf


def test_nothing_seen_is_at_most_three():
    assert upper_bound(0) == pytest.approx(2.996, abs=1e-3)
