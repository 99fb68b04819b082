"""Figure 7 and the scheduled gain: pinned, and what the two belts share."""

from types import SimpleNamespace

import numpy as np
import pytest

from similitude.paper.claims_figure_7 import after_jumps, excursions, figure_7_claims, gains
from similitude.paper.drives import belt, belt_scheduled, drive_of
from similitude.simulation.scenario import read_scenario

from .pinned import DRIVEN, check


@pytest.mark.slow
def test_claims_are_the_pinned_ones():
    check("Figure 7 and the scheduled gain", figure_7_claims(), relative=DRIVEN)


@pytest.mark.slow
def test_both_vehicles_come_back_and_meet_the_same_belt():
    for drive in (belt(), belt_scheduled()):
        assert excursions(drive, 95.0, 110.0)["most"] < 0.05
    assert np.array_equal(belt().wanted, belt_scheduled().wanted)
    assert not np.array_equal(belt().delta, belt_scheduled().delta)


@pytest.mark.slow
def test_a_drive_is_the_same_however_long_it_lasts():
    """The gains are compared over 90 s, the figure shows 110: one belt."""
    short = drive_of(read_scenario("treadmill_hydroplaning", changes={"run.duration": "8 s"}))
    assert np.array_equal(short.y, belt().y[: short.y.size])
    assert {name: drive.t[-1] >= 90 for name, drive in gains().items()} == dict.fromkeys(gains(), True)


def test_what_follows_a_jump_is_found():
    """Distance one all the time, a jump of the path at 2 s of 10: the second from there is a tenth."""
    t = np.arange(0, 10, 0.01)
    wanted = np.where(t < 2, 0.0, 0.3)
    drive = SimpleNamespace(
        t=t, y=wanted + 1, wanted=wanted, step=0.01, during=lambda a, b: (t >= a) & (t < b)
    )
    assert after_jumps(drive, 0, 10) == pytest.approx(0.1, abs=0.002)
