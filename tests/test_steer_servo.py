"""The servo of a command, planted in simulated drives and looked for."""

import numpy as np
import pytest

from similitude.servo import Servo
from similitude.simulate import bicycle_response
from similitude.steer_lag import find_lag
from similitude.steer_servo import CONSTANTS, SLEWS, find_servo
from similitude.vehicle_prior import vehicle_prior

from .simulated_drive import CAR, FINE, NOISE, log_of, vehicle, wandering_steer
from .test_filter_run import setup_of


def turned_by(servo, command, lag):
    """Wheels in steps of a millisecond, by the servo's equation."""
    late = np.concatenate([np.zeros(round(lag * FINE)), command])[: command.size]
    wheels, angle = [], 0.0
    for told in late.tolist():
        rate = (told - angle) / max(servo.constant, 1 / FINE)
        angle += min(max(rate, -servo.slew), servo.slew) / FINE
        wheels.append(angle)
    return np.array(wheels)


def commanded(servo, *, lag, command, U, seed=0):
    """A log at 100 Hz of the command, and of the yaw rate that the wheels brought about."""
    t = np.arange(command.size) / FINE
    wheels = turned_by(servo, command, lag)
    speed = np.full(t.size, U)
    r, _ = bicycle_response(t, wheels, speed, **CAR)
    noise = NOISE * np.random.default_rng(seed).standard_normal(t.size)
    return log_of(t[::10], command[::10], (r + noise)[::10], speed[::10])


def swings(size, seconds=60, every=1.5, seed=0):
    """A command that jumps to and fro, (n,) [rad]."""
    rng = np.random.default_rng(seed)
    jumps = rng.uniform(-size, size, int(seconds / every))
    return np.repeat(jumps, int(every * FINE))


def found(log):
    car = vehicle()
    setup = setup_of(log, vehicle_prior(car))
    return find_servo(setup, find_lag(setup, car))


@pytest.mark.parametrize("planted", [Servo(0.03), Servo(0.08)])
def test_a_planted_time_constant_is_found(planted):
    command = wandering_steer(60, 0.01, band=(0.15, 6.0), seed=1)
    scan = found(commanded(planted, lag=0.05, command=command, U=20.0))
    at = int(np.argmin(np.abs(np.array(CONSTANTS) - planted.constant)))
    assert scan.servo.constant in CONSTANTS[at - 1 : at + 2]  # the usual one pulls
    assert scan.total == pytest.approx(0.05 + planted.constant, abs=0.010)


@pytest.mark.parametrize("slew", [0.8, 2.0])
def test_a_planted_slew_is_found_where_the_wheels_swing_far(slew):
    scan = found(commanded(Servo(0.03, slew), lag=0.03, command=swings(0.3), U=5.0))
    at = np.argmin(np.abs(np.log(np.array(SLEWS[:-1]) / slew)))
    assert scan.servo.slew in SLEWS[max(at - 1, 0) : at + 2]
    # wheels that are nearly always on their way hide the rest of their delay
    assert scan.total == pytest.approx(0.06, abs=0.035)


def test_a_command_that_acts_at_once_but_late_has_next_to_no_servo():
    command = wandering_steer(60, 0.01, band=(0.15, 6.0), seed=2)
    scan = found(commanded(Servo(), lag=0.1, command=command, U=20.0))
    assert scan.servo.constant <= 0.015
    assert scan.total == pytest.approx(0.1, abs=0.010)
    assert scan.origin == "scanned" and scan.cost.min() == 0


def test_without_a_quick_command_the_servo_is_the_usual_one():
    command = wandering_steer(60, 1e-4, band=(0.05, 0.2), seed=3)
    scan = found(commanded(Servo(0.08), lag=0.05, command=command, U=20.0))
    assert scan.servo.constant in (0.03, 0.045, 0.06)
    assert scan.servo.slew in (2.5, 3.2, 4.2)
