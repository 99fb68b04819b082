"""The chain from command to wheels, each stage against its closed form."""

import numpy as np
import pytest

from similitude.simulation.actuator import Actuator, Chain, wheel_angle
from similitude.simulation.arithmetic import ARRAYS, FLOATS

STEP = 0.001
T = np.arange(0, 2, STEP)


def through(command, **stages):
    """What the rack does (n,): at the instant of each command."""
    chain = Chain(Actuator(**stages), step=STEP, first=float(command[0]), on=FLOATS)
    return np.array([command[0]] + [chain.tick(float(x)) for x in command[1:]])


def test_nothing_in_between_passes_everything():
    command = np.sin(5 * T)
    np.testing.assert_array_equal(through(command), command)


@pytest.mark.parametrize("delay", [0.02, 0.0205])
def test_a_delay_is_as_long_as_stated(delay):
    command = np.sin(5 * T)
    late = np.where(T < delay, 0.0, np.sin(5 * (T - delay)))
    # between ticks it is straight: (5 · 1 ms)²/8 off
    assert np.abs(through(command, delay=delay) - late).max() <= 5e-6


def test_a_lag_answers_a_ramp_in_closed_form():
    """Ramp t through a lag: t − τ(1 − exp(−t/τ)), exactly."""
    exact = T - 0.03 * (1 - np.exp(-T / 0.03))
    np.testing.assert_allclose(through(T, lag=0.03), exact, atol=1e-12)


def test_a_servo_answers_a_ramp_in_closed_form():
    w, z = 2 * np.pi * 5, 0.5
    d = w * np.sqrt(1 - z * z)
    decay = np.exp(-z * w * T)
    exact = T - 2 * z / w + decay * (2 * z / w * np.cos(d * T) + (2 * z * z - 1) / d * np.sin(d * T))
    np.testing.assert_allclose(through(T, servo=5.0, damping=z), exact, atol=1e-12)


def test_a_servo_has_unit_gain_and_its_phase_at_its_frequency():
    rack = through(np.sin(2 * np.pi * 5 * T), servo=5.0, damping=0.707)
    late = T > 1
    # at the natural frequency: gain 1/(2 ζ), a quarter period late
    expected = -np.cos(2 * np.pi * 5 * T) / (2 * 0.707)
    assert np.abs(rack - expected)[late].max() < 1e-3
    assert through(np.ones(T.size) * 0.1, servo=5.0)[-1] == pytest.approx(0.1)


def test_a_rate_limit_limits_the_rate():
    rack = through(np.where(T > 0.1, 0.5, 0.0), rate_limit=0.8)
    assert np.abs(np.diff(rack)).max() <= 0.8 * STEP * (1 + 1e-9)
    assert rack[-1] == 0.5 and T[np.argmax(rack >= 0.25)] == pytest.approx(0.1 + 0.25 / 0.8, abs=3 * STEP)


def test_play_is_lost_at_every_turn():
    rack = through(0.02 * np.sin(2 * np.pi * T), play=0.004)
    assert rack.max() == pytest.approx(0.018, rel=1e-4) and rack.min() == pytest.approx(-0.018, rel=1e-4)
    # turning back, the rack rests until the play is through: command from 0.02 to 0.016
    rests = np.abs(np.diff(rack)) == 0
    assert rests[255:330].any()


def test_many_cars_go_through_one_chain():
    chain = Chain(Actuator(delay=0.005, play=0.001, lag=0.02, servo=5.0, rate_limit=1.0),
                  step=STEP, first=np.zeros(2), on=ARRAYS)  # fmt: skip
    both = np.array([chain.tick(np.array([np.sin(5 * t), 0.1 * t])) for t in T[1:]])
    stages = {"delay": 0.005, "play": 0.001, "lag": 0.02, "servo": 5.0, "rate_limit": 1.0}
    np.testing.assert_allclose(both[:, 0], through(np.sin(5 * T), **stages)[1:], atol=1e-14)
    np.testing.assert_allclose(both[:, 1], through(0.1 * T, **stages)[1:], atol=1e-14)


def test_compliance_lies_behind_the_rack():
    loose = Actuator(scale=1.1, offset=0.002, wander=0.001, wander_share=0.05)
    assert wheel_angle(loose, -0.1, 2.0) == pytest.approx(-0.11 + 0.002 + 2 * (0.001 + 0.005))
