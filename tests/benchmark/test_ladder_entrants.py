"""Our own entrants: no look into the future, the product's own numbers, every rung of the ladder."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.benchmark.cells import Cell
from similitude.benchmark.drives import drives
from similitude.benchmark.ladder_entrants import LAG_AGAIN, _fitted_lag, ladder, prepared
from similitude.benchmark.scoring import unfit

from .linear_drive import linear_drive

BY_NAME = {one.name: one for one in ladder()}


def test_the_ladder_has_its_rungs_and_one_with_an_accelerometer():
    names = ["paper", "band", "output_error", "robust", "population", "with_ay", "batch"]
    assert list(BY_NAME) == names
    assert [name for name, one in BY_NAME.items() if one.whole_log] == ["batch"]


@pytest.mark.parametrize("name", [name for name in BY_NAME if name != "batch"])
def test_an_estimate_does_not_know_what_comes(name):
    """Cut at 40 s, everything before is the same number."""
    drive, _ = linear_drive()
    whole, part = (BY_NAME[name].estimate(one) for one in (drive, drive.until(40.0)))
    n = drive.until(40.0).t.size

    assert np.array_equal(np.broadcast_to(whole.K, drive.t.size)[:n], np.broadcast_to(part.K, n))
    assert [a for a in whole.alarms if a < 40.0] == list(part.alarms)


@pytest.mark.parametrize("name", BY_NAME)
def test_every_answer_is_one_number_a_row(name):
    drive, _ = linear_drive()
    answer = BY_NAME[name].estimate(drive)

    assert unfit(answer, drive.t.size) == ""
    assert name == "batch" or answer.operations > 50


def test_the_population_entrant_is_the_products_pass_with_the_lag_of_what_was_driven():
    drive, _ = linear_drive()
    early = drive.t < LAG_AGAIN
    first, then = (prepared(drive, after).setup.run().output("estimate") for after in (10.0, LAG_AGAIN))
    K = BY_NAME["population"].estimate(drive).K

    assert np.array_equal(K, np.where(early, first, then))
    begun = drive.until(20.0)  # which has no thirty seconds
    assert np.array_equal(BY_NAME["population"].estimate(begun).K, first[drive.t < 20.0])


def test_the_lag_of_thirty_seconds_is_better_known_than_that_of_ten_where_those_were_slow():
    ((drive, _),) = drives(Cell("sweep", "linear", "none", 1), 5)
    ten, thirty = prepared(drive).scan, prepared(drive, LAG_AGAIN).scan
    assert thirty.std < 0.5 * ten.std and abs(thirty.chosen) < 3 * thirty.std


def test_the_change_is_alarmed_once_and_soon():
    alarms = BY_NAME["population"].estimate(linear_drive()[0]).alarms

    assert len(alarms) == 1 and 50.0 < alarms[0] < 52.0


def test_a_late_yaw_rate_is_found_in_the_seconds_that_are_not_judged():
    drive, _ = linear_drive()
    late = replace(drive, r=np.concatenate([np.full(4, drive.r[0]), drive.r[:-4]]))

    plain, found = prepared(drive).scan, prepared(late).scan
    more = found.chosen - plain.chosen  # 40 ms, each lag with its sd
    assert abs(more - 0.04) < 3 * np.hypot(plain.std, found.std)
    assert prepared(late.until(30.0)).scan.chosen == found.chosen


def test_the_lag_is_fitted_once_for_a_drive_and_its_part():
    drive, _ = linear_drive(seed=5)
    before = _fitted_lag.cache_info().misses
    whole, part = prepared(drive).scan, prepared(drive.until(50.0)).scan

    assert whole is part and _fitted_lag.cache_info().misses == before + 1
    assert prepared(replace(drive, r=drive.r * 1.01)).scan is not whole
