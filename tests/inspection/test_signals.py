"""Signals on an even clock: what was measured stays, what was not is not made up."""

import numpy as np
import pytest

from similitude.inspection.signals import even_signals
from similitude.inspection.timing import timing


def placed(t, **values):
    return even_signals({"t": t, **values}, timing(t))


def test_an_even_clock_changes_nothing():
    t = 5.0 + np.arange(500) * 0.02
    r = np.random.default_rng(0).standard_normal(500)

    signals = placed(t, r=r)

    assert signals.step == pytest.approx(0.02)
    np.testing.assert_allclose(signals.r, r, atol=1e-9)
    assert signals.steer is None and not signals.at_wheel


def test_holes_are_bridged_up_to_a_tenth_of_a_second_and_no_further():
    t = np.arange(1000) * 0.01
    r = np.sin(t)
    r[100:105] = np.nan
    r[500:600] = np.nan

    signals = placed(t, r=r)

    np.testing.assert_allclose(signals.r[100:105], np.sin(t[100:105]), atol=0.06**2 / 8)  # chord
    assert np.isnan(signals.r[500:600]).all() and np.isfinite(signals.r[600:]).all()


def test_a_pause_of_the_clock_is_not_filled_in():
    t = np.arange(1000) * 0.01
    t[500:] += 5.0

    signals = placed(t, r=np.ones(1000))

    assert np.isnan(signals.r[505:995]).all()


def test_a_clock_that_does_not_rise_or_is_torn_has_no_signals():
    t = np.arange(100) * 0.01
    assert placed(t[::-1].copy(), r=np.ones(100)) is None
    torn = t.copy()
    torn[50:] += 1e9
    assert placed(torn, r=np.ones(100)) is None
    assert even_signals({}, None) is None


def test_the_steering_wheel_stands_in_for_the_road_wheel_and_says_so():
    t = np.arange(100) * 0.01

    assert placed(t, steering_wheel=t).at_wheel
    assert not placed(t, steering_wheel=t, delta=t).at_wheel


def test_damage_is_not_measured():
    t = np.arange(100) * 0.01
    r = np.ones(100)
    r[50] = 1e300

    assert placed(t, r=r).r.max() == 1.0


def test_a_fast_log_is_put_on_a_clock_fast_enough_for_yaw():
    t = np.arange(5000) * 1e-3

    assert placed(t, r=np.sin(t)).step == pytest.approx(1 / 200)
