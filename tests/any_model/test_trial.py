"""Slopes along the trial are those of the closed form."""

import numpy as np
import pytest

from .gallery import made


def test_the_slope_of_a_circuit_is_that_of_its_steady_response():
    """Static gain is one, so the slope vanishes where the input rests; it is largest at resonance."""
    trial = made("rlc_circuit").trial

    assert trial.slopes.shape == (len(trial.u), 1)
    assert np.isfinite(trial.slopes).all() and np.abs(trial.slopes).max() > 0.1 * np.abs(trial.output).max()


def test_time_kept_is_between_a_sample_and_the_drive():
    trial = made("rlc_circuit").trial

    assert trial.step <= trial.slowest < trial.step * len(trial.u)


def test_the_output_moves_as_the_unknown_does():
    estimator = made("rlc_circuit")
    low, high = (
        estimator.simulate(seed=1, truth={"R": 280.0 * np.exp(s * 1e-3)})["vc"] for s in (-1, 1)
    )  # the same noise
    slope = (high - low) / 2e-3

    assert slope == pytest.approx(estimator.trial.slopes[:, 0], abs=1e-4 * np.abs(slope).max())
