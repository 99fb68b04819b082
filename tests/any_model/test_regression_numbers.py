"""The sampled model is exact, its residual filter is A1/A0, and straightness is that of a known case."""

import numpy as np
import pytest
from scipy.signal import lfilter

from similitude.any_model.regression_numbers import _denominator_filter, sampler, straightness

from .gallery import made


def parts():
    estimator = made("rlc_circuit")
    reduction = estimator.reduced.reduction
    return estimator, reduction, sampler(estimator.fewest, reduction, estimator.step)


def test_the_sampled_model_gives_the_plants_output():
    estimator, _, sampled = parts()
    one, u = sampled(estimator.prior.mean), estimator.trial.u[:400]
    b, a = one.coefficients[:3], np.concatenate([[1], one.denominator])
    x0 = one.g1 * u[0]  # the plant is at rest at the first row
    away = lfilter(b, a, u) - estimator.trial.output[:400]
    free = [one.C @ np.linalg.matrix_power(one.F, k) @ x0 for k in range(400)]

    np.testing.assert_allclose(away, free, atol=1e-9 * np.abs(u).max())


def test_the_residual_filter_is_the_denominators_slope_over_the_denominator():
    _, _, sampled = parts()
    one, change = sampled(np.array([0.5])), np.array([0.3, -0.7])
    into, read = _denominator_filter(one, change)
    pulse, w, found = np.eye(50)[0], np.zeros(2), []
    for e in pulse:
        found.append(read @ w)
        w = one.F @ w + into * e
    truth = lfilter([0, *change], [1, *one.denominator], pulse)

    np.testing.assert_allclose(found, truth, atol=1e-9)


def test_shorter_samples_are_straighter():
    estimator, reduction, _ = parts()
    worst = [straightness(estimator.fewest, reduction, estimator.prior, T).worst for T in (5e-6, 2e-5, 1e-4)]

    assert worst[0] < worst[1] < worst[2]
    assert worst[1] / worst[0] == pytest.approx(4, rel=0.2)  # the bend goes with the sample time
