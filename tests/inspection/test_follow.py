"""Sign and lag that were planted come back within their intervals."""

import numpy as np
import pytest

from similitude.inspection.follow import follow, yaw_behind_steer
from similitude.inspection.signals import Signals

from ..simulated_drive import FINE, wandering_steer

U, L = 25.0, 2.65


def delayed(seed, *, lag, noise, rms=0.006, seconds=40, step=0.01, sign=1):
    """Steer and, a lag later, the yaw rate of a car on rails, (n,) each."""
    t = np.arange(int(seconds / step)) * step
    steer = wandering_steer(seconds + 2, rms, seed=seed)
    fine = np.arange(steer.size) / FINE
    now, before = np.interp(t + 1, fine, steer), np.interp(t + 1 - lag, fine, steer)
    return now, sign * U / L * before + noise * np.random.default_rng(seed).standard_normal(t.size)


@pytest.mark.parametrize("noise", [0.0026, 0.1])
def test_a_planted_lag_is_within_its_interval(noise):
    inside = []
    for seed in range(40):
        lag = np.random.default_rng(seed).uniform(-0.2, 0.5)
        found = follow(*delayed(seed, lag=lag, noise=noise), 0.01)
        inside.append(abs(found.lag - lag) <= 1.96 * found.lag_std)

    # 95 % of 40 are 38; a fair coin of 0.95 falls below 34 once in 400 times.
    assert sum(inside) >= 34


def test_the_interval_grows_with_the_noise():
    quiet, loud = (follow(*delayed(3, lag=0.1, noise=noise), 0.01).lag_std for noise in (0.003, 0.15))

    assert loud > 1.5 * quiet


@pytest.mark.parametrize("sign", [1, -1])
def test_the_side_is_found(sign):
    found = follow(*delayed(0, lag=0.1, noise=0.003, sign=sign), 0.01)

    assert found.sign == sign and found.likeness * sign > 0.9


def test_unrelated_wandering_signals_are_unrelated():
    sides = 0
    for seed in range(100):
        x, y = np.cumsum(np.random.default_rng(seed).standard_normal((2, 4000)), axis=1)
        sides += follow(x, y, 0.01).sign != 0

    assert sides <= 4  # one in a hundred, measured over 300


def test_rows_without_a_measurement_do_not_count():
    steer, r = delayed(5, lag=0.1, noise=0.003)
    r[1000:2000] = np.nan

    found = follow(steer, r, 0.01)

    assert found.lag == pytest.approx(0.1, abs=0.004) and found.sign == 1


def test_too_little_says_nothing():
    assert follow(np.ones(100), np.ones(100), 0.01) is None
    assert follow(np.zeros(4000), np.zeros(4000), 0.01).sign == 0


def test_a_parked_car_says_nothing_about_its_steer():
    steer, r = delayed(0, lag=0.1, noise=0.003)
    t = np.arange(steer.size) * 0.01

    parked = Signals(0.01, t, steer, r, np.zeros(t.size), None)

    assert yaw_behind_steer(parked) is None
    assert yaw_behind_steer(Signals(0.01, t, None, r, t, None)) is None
