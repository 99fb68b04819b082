"""Evidence: a change is found and sized, what is none gathers nothing."""

from dataclasses import replace

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


def test_one_half_wave_may_ring_where_the_change_explains_it():
    cars = road(
        75, cars=8, kind="highway", duration=70.0, events=False, changes=((CHANGE_AT, 0.5),), lateral=1.2
    )
    sooner = [
        [watch(done, changes={"piece_share": share}).alarms[0].t for share in (0.04, 0.0)]
        for done in passes(cars)
    ]
    now, two_half_waves = np.transpose(sooner)

    assert (now <= two_half_waves).all() and (now >= CHANGE_AT).all()
    assert np.max(two_half_waves - now) > 0.3  # s: a driver's half-wave takes 0.5 to 3


def test_a_change_within_the_reference_s_doubt_is_none():
    cars = road(
        76, cars=1, kind="highway", duration=70.0, events=False, changes=((CHANGE_AT, 0.5),), lateral=0.8
    )
    (done,) = passes(cars)
    (alarm,) = watch(done).alarms
    before = int(CHANGE_AT * 100) - 1
    sizes = np.log1p(alarm.change) ** 2 / done.output("variance")[before]

    assert sizes > 9  # far beyond the filter's doubt before the change
    assert watch(done, changes={"sizes_squared": 20 * sizes}).alarms == ()


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
    spoilt = replace(log, r=r)
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
