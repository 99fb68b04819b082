"""What a regression's number could be wrong by, found by running it again."""

import numpy as np
import pytest

from similitude.identify_setup import prepare
from similitude.ladder_passes import LADDER, WORDS, axes, doubts, form_error, rung

from .simulated_drive import drive, metres, vehicle


@pytest.fixture(scope="module")
def ready():
    return prepare(drive(seconds=40, rms=0.01), vehicle(steer_lag=metres(0.0)))


def test_the_axes_span_the_population_s_covariance(ready):
    found = axes(ready.prior)

    assert found.T @ found == pytest.approx(ready.prior.covariance[1:, 1:], abs=1e-15)


@pytest.mark.parametrize("name", LADDER)
def test_every_doubt_has_words_and_a_finite_sd_on_every_row(ready, name):
    done = rung(name, ready.setup, ready.prior).run()
    found = doubts(done, ready.scan)

    assert set(found) <= set(WORDS) and {"scatter", "frozen", "steer_scale"} <= set(found)
    assert all(np.isfinite(part).all() and (part >= 0).all() for part in found.values())
    assert all(part.shape == (ready.setup.log.samples,) for part in found.values())


def test_frozen_groups_cost_robust_what_B1_says(ready):
    """K = a1 rho (1 - pi1): var ln K = var ln rho + (sd pi1/(1 - pi1))^2, at first order."""
    done = rung("robust", ready.setup, ready.prior).run()
    sd, pi1 = ready.prior.std, ready.prior.mean[1]

    found = doubts(done, ready.scan)["frozen"][-1]
    assert found == pytest.approx(np.hypot(sd[3], sd[1] / (1 - pi1)), rel=0.01)


def test_a_steer_scale_moves_robust_by_as_much(ready):
    done = rung("robust", ready.setup, ready.prior).run()

    scale = np.log(1 + ready.setup.input_scale_sd)
    assert doubts(done, ready.scan)["steer_scale"][-1] == pytest.approx(scale, rel=0.01)


def test_output_error_and_robust_leave_nothing_out_and_band_does(ready):
    """band: the slow relation; its size at 45 to 90 rad/s and 100 Hz is some per cent of a car."""
    errors = {}
    for name in ("robust", "band"):
        setup = prepare(
            drive(seconds=40, rms=0.02, band=(0.15, 20.0), noise=0.0), vehicle(steer_lag=metres(0.0))
        ).setup
        errors[name] = abs(form_error(rung(name, setup, ready.prior).run())[-1])

    assert errors["robust"] < 0.01 < errors["band"] < 0.2


def test_moving_a_group_moves_the_frozen_value_alone(ready):
    one = rung("robust", ready.setup, ready.prior)
    moved = one.at(np.array([0.01, 0.1, 0.0])).prior

    assert moved.mean[[0, 3]] == pytest.approx(one.prior.mean[[0, 3]], rel=1e-12)
    assert moved.mean[1] == pytest.approx(one.prior.mean[1] + 0.01)
    assert moved.mean[2] == pytest.approx(one.prior.mean[2] * np.exp(0.1))
