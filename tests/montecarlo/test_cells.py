"""Honesty away from the reference experiment: every cell covers 90 to 99.5 %, none is wrong.

Long drives, noise and process noise assumed ten times too large or too small, a straight road, cars
two sd off the population in the ratio of their stiffnesses, a wheelbase wrong by 5 %.
"""

from functools import lru_cache

import pytest

from similitude.filter_config import DESIGN

from .experiment import fleet, score

pytestmark = pytest.mark.slow

DRIFTS = ("drift", "idle_drift", "jump_drift", "faint_drift")
DISTURBANCES = ("disturbance_floor", "disturbance_share")  # sd; the variance is ten times


drawn = lru_cache(maxsize=2)(fleet)  # many cells assume otherwise of the same drives


def changed(names, factor):
    return {name: DESIGN[name] * factor for name in names}


DRIVES = {
    "reference": ({"cars": 100}, {}),
    "600 s": ({"duration": 600.0}, {}),
    "600 s, constant": ({"duration": 600.0, "halve": False}, {}),
    "noise assumed x 10": ({}, {"noise_factor": 10.0}),
    "noise assumed / 10": ({}, {"noise_factor": 0.1}),
    "drift assumed x 10": ({}, changed(DRIFTS, 10)),
    "drift assumed / 10": ({}, changed(DRIFTS, 0.1)),
    "disturbance assumed x 10": ({}, changed(DISTURBANCES, 10**0.5)),
    "disturbance assumed / 10": ({}, changed(DISTURBANCES, 10**-0.5)),
    "stiffness ratio + 2 sd": ({"ln_k": 2}, {}),
    "stiffness ratio - 2 sd": ({"ln_k": -2}, {}),
    "wheelbase + 5 %": ({"cars": 100}, {"L_factor": 1.05}),
    "wheelbase - 5 %": ({"cars": 100}, {"L_factor": 0.95}),
}


@pytest.mark.parametrize("steer_rms", [3e-3, 10e-3])
@pytest.mark.parametrize("drive", DRIVES)
def test_the_interval_covers_in_every_cell(drive, steer_rms):
    driven, assumed = DRIVES[drive]
    result = score(drawn(2, steer_rms=steer_rms, **driven), **assumed)
    assert 0.90 <= result.coverage <= 0.995, result
    assert result.wrong == 0, result


@pytest.mark.parametrize("steer_rms", [3e-3, 10e-3])
def test_an_hour_does_not_make_it_certain(steer_rms):
    cars = drawn(7, cars=40, duration=3600.0, step=1800.0, steer_rms=steer_rms)
    result = score(cars, step=1800.0)
    assert 0.90 <= result.coverage <= 0.995, result
    assert result.wrong == 0, result


@pytest.mark.parametrize("noise_factor", [0.1, 1.0, 10.0])
@pytest.mark.parametrize(("duration", "cars"), [(600.0, 60), (3600.0, 20)])
def test_a_straight_road_is_never_identified(duration, cars, noise_factor):
    drives = drawn(5 if duration < 1000 else 8, cars=cars, duration=duration, steer_rms=1e-4, halve=False)
    result = score(drives, noise_factor=noise_factor)
    assert result.identified == 0
    assert 0.90 <= result.coverage <= 0.995, result
