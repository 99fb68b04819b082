"""Slopes of the innovations: central differences, the car that follows the steer alone, the scales."""

import numpy as np
import pytest

from similitude.batch_slopes import OUTLIER, STEP, fit_scales, slopes, steered_slopes, whiten

from .simulated_drive import CAR, NOISE, drive, spoilt
from .test_batch_pass import NOMINAL, at_truth, frozen


@pytest.fixture(scope="module")
def filter_():
    return frozen(drive(seconds=20))


def test_slopes_are_central_differences(filter_):
    x = at_truth(filter_, lag=0.023)
    loud = np.log([4.0, 1.0])  # noise told twice as large: nothing is an outlier, whose bound has a kink
    own = slopes(filter_, x, loud, whiten(filter_, x, loud))
    for i in range(6):
        step = 10 * STEP[i] * np.eye(6)[i] if i < 5 else STEP[i] * np.eye(6)[i]
        sides = [whiten(filter_, x + sign * step, loud).e for sign in (1, -1)]
        central = (sides[0] - sides[1]) / (2 * step[i])
        assert own[:, i] == pytest.approx(central, abs=0.03 * np.max(np.abs(central)))


def test_the_pull_is_the_slope_of_the_cost_but_for_that_of_the_variances(filter_):
    x = at_truth(filter_, lag=0.023) + np.array([0.1, 0, 0, 0, 0, 0])
    now = whiten(filter_, x, NOMINAL)
    own = slopes(filter_, x, NOMINAL, now)
    h = 1e-4 * np.eye(6)[0]
    sides = [whiten(filter_, x + sign * h, NOMINAL) for sign in (1, -1)]
    fixed = [0.5 * np.sum(now.weight * side.e**2 / now.S) for side in sides]
    assert own[:, 0] @ now.pull == pytest.approx((fixed[0] - fixed[1]) / 2e-4, rel=0.01)


def test_a_gyro_of_pure_noise_has_no_part_in_the_steered_slopes():
    """Two noises on one drive: the steered slopes are alike, the innovations' own are not."""
    quiet, loud = (frozen(drive(seconds=20, noise=noise)) for noise in (0.0, 0.01))
    found = {}
    for name, one in (("quiet", quiet), ("loud", loud)):
        x = at_truth(one)
        now = whiten(one, x, NOMINAL)
        found[name] = [f(one, x, NOMINAL, now)[:, 0] for f in (slopes, steered_slopes)]
    own, steered = (
        np.std(found["loud"][i] - found["quiet"][i]) / np.std(found["quiet"][i]) for i in range(2)
    )
    assert steered < 0.1 < own


def test_an_unstable_car_has_finite_steered_slopes():
    one = frozen(drive(seconds=60, rms=0.001, eta=0.9, U=lambda t: 0 * t + 20.0))
    x = one.coordinates(np.array([60.0, 0.4431, 0.8, 1.017, 1.0, 1e-4]))  # unstable from 16 m/s
    found = steered_slopes(one, x, NOMINAL, whiten(one, x, NOMINAL))
    assert np.isfinite(found).all() and np.max(np.abs(found)) < 100


def test_an_outlier_counts_for_less_and_a_missing_row_for_nothing():
    log = drive(seconds=5)
    log.r[250] += 1.0
    one = frozen(spoilt(log, r=slice(300, 310)))
    now = whiten(one, at_truth(one), NOMINAL)
    assert now.weight[250] == pytest.approx(OUTLIER * now.S[250] / now.e[250] ** 2)
    assert np.all(now.weight[300:310] == 0)
    ordinary = np.delete(now.weight, [250, *range(300, 310)])
    assert np.median(ordinary) == 1.0


@pytest.mark.parametrize("factor", [0.3, 3.0])
def test_the_scale_of_the_noise_is_found(factor):
    one = frozen(drive(seconds=60, rms=2e-4), noise_std=NOISE * factor)
    x, s = at_truth(one), np.log([1.0, 0.02])
    now = whiten(one, x, s)
    costs = [now.cost]
    for _ in range(8):
        s, now = fit_scales(one, x, s, now)
        costs.append(now.cost)
    assert np.all(np.diff(costs) <= 0)
    # 6000 rows know a variance to sqrt(2/6000) = 1.8 %; structure and timing take a tenth of it
    assert np.exp(s[0]) == pytest.approx(factor**-2, rel=0.15)
    assert CAR["K"] == pytest.approx(one.values(x)["K"])
