"""A servo against closed forms and against its equation integrated in small steps."""

from itertools import pairwise

import numpy as np
import pytest

from similitude.servo import DIRECT, Servo


def uneven(seed=0, n=400):
    rng = np.random.default_rng(seed)
    return np.cumsum(rng.uniform(0.002, 0.04, n)), rng.normal(size=n)


def integrated(servo, t, u, pieces=2000):
    """Its equation by Euler's rule in small steps."""
    x, found = u[0], [u[0]]
    for (t0, t1), (u0, u1) in zip(pairwise(t), pairwise(u), strict=True):
        h = (t1 - t0) / pieces
        for i in range(pieces):
            rate = (u0 + (u1 - u0) * (i + 0.5) / pieces - x) / servo.constant
            x += h * np.clip(rate, -servo.slew, servo.slew)
        found.append(x)
    return np.array(found)


def test_a_step_is_an_exponential_and_a_ramp_lags_by_the_time_constant():
    t = np.linspace(0, 1, 101)
    ramp = Servo(0.05).follow(t, 3 * t)
    assert ramp == pytest.approx(3 * (t - 0.05 * (1 - np.exp(-t / 0.05))), abs=1e-12)


def test_between_rows_it_is_exact_whatever_the_rows():
    """The same straight command in few rows and in many."""
    corners = np.array([0.0, 0.3, 0.35, 0.9, 1.4])
    u = np.array([0.0, 1.0, -1.0, -1.0, 0.5])
    t = np.union1d(corners, np.random.default_rng(1).uniform(0, 1.4, 300))
    fine = Servo(0.07).follow(t, np.interp(t, corners, u))
    assert Servo(0.07).follow(corners, u) == pytest.approx(fine[np.isin(t, corners)], abs=1e-12)


@pytest.mark.parametrize("slew", [np.inf, 2.0])
def test_it_is_its_equation(slew):
    t, u = uneven(2, 30)
    u = 0.2 * u
    servo = Servo(0.04, slew)
    # A row is cut to the slew as a whole: where the limit ends or the command crosses on the way, as in
    # nearly every row of white noise, that is up to a row's worth of slew.
    room = 1e-4 if np.isinf(slew) else slew * np.diff(t).max()
    assert servo.follow(t, u) == pytest.approx(integrated(servo, t, u), abs=room)


def test_a_slew_is_kept_and_a_far_one_is_never_felt():
    t, u = uneven(3)
    limited = Servo(0.0, 2.0).follow(t, u)
    assert np.abs(np.diff(limited) / np.diff(t)).max() <= 2.0 * (1 + 1e-9)
    assert Servo(0.03, 1e9).follow(t, u) == pytest.approx(Servo(0.03).follow(t, u), abs=1e-12)


@pytest.mark.parametrize("servo", [Servo(0.05), Servo(0.05, 1.0), Servo(0.0, 1.0), Servo(1e-6), Servo(100.0)])
def test_it_stays_within_the_commands_and_a_constant_passes(servo):
    t, u = uneven(4)
    followed = servo.follow(t, u)
    assert followed.min() >= u.min() - 1e-12 and followed.max() <= u.max() + 1e-12
    assert np.ptp(servo.follow(t, np.full(t.size, 0.3))) < 1e-15


def test_no_servo_changes_nothing():
    t, u = uneven(5)
    assert DIRECT.is_none and np.array_equal(DIRECT.follow(t, u), u)
    assert np.array_equal(Servo(0.05, 1.0).follow(t[:1], u[:1]), u[:1])
