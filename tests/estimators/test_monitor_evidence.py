"""Evidence: a change is found and sized, what is none gathers nothing."""

import numpy as np
import pytest

from similitude.change_alarm import watch
from similitude.filter_run import population_setup

from ..filter_rig import CAR, NOISE
from ..montecarlo.alarms import CHANGE_AT, passes
from ..montecarlo.road import road
from ..simulated_drive import CAR as TRUTH
from ..simulated_drive import drive


@pytest.mark.parametrize(("factor", "kind"), [(0.5, "stiffness_drop"), (2.0, "stiffness_rise")])
def test_a_change_is_found_its_size_told_and_its_onset(factor, kind):
    cars = road(
        71, cars=8, kind="highway", duration=80.0, events=False, changes=((CHANGE_AT, factor),), lateral=0.8
    )
    for done in passes(cars):
        seen = watch(done)
        (alarm,) = [a for a in seen.alarms if a.t < CHANGE_AT + 10]
        assert alarm.kind == kind
        assert CHANGE_AT <= alarm.t < CHANGE_AT + 6
        assert abs(alarm.onset - CHANGE_AT) < 1.0
        # the size is told after a second of driving: within four of its own sd
        ln = np.log1p(alarm.change) - np.log(factor)
        assert abs(ln) < 4 * alarm.std / (1 + alarm.change) + 0.1
        assert alarm.lo < alarm.change < alarm.hi


@pytest.mark.slow
def test_nothing_rings_in_an_hour_of_sound_driving():
    rung = []
    for kind in ("highway", "straight"):
        cars = road(72, cars=6, kind=kind, duration=300.0)
        rung += [a for done in passes(cars) for a in watch(done).alarms]
    # one in ten hours is meant: two in this one have a chance below 1 %
    assert len(rung) <= 1


def test_nothing_rings_in_five_minutes_of_kerbs_and_gusts():
    cars = road(74, cars=2, kind="highway", duration=150.0)

    assert [a for done in passes(cars) for a in watch(done).alarms] == []


def test_one_wild_reading_is_no_change():
    log = drive(seconds=60, rms=0.006)
    r = log.r.copy()
    r[3000:6000:37] += 0.4  # rad/s
    spoilt = type(log)(**{**vars(log), "r": r})
    done = population_setup(spoilt, CAR, L=TRUTH["L"], noise_std=NOISE, input_scale_sd=0.02).run()

    assert watch(done).alarms == ()


def test_missing_rows_neither_ring_nor_stop_it():
    cars = road(73, cars=3, kind="highway", duration=80.0, events=False, changes=((60.0, 0.5),), lateral=0.8)
    lost = np.random.default_rng(2).random(cars.yaw_rate.shape) < 0.2
    lost[:, 3000:3150] = True
    cars.yaw_rate[lost] = np.nan
    for done in passes(cars):
        alarms = watch(done).alarms
        assert [a.kind for a in alarms if a.t < 70] == ["stiffness_drop"]
        assert 60 <= alarms[0].t
