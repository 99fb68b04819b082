"""Lines through clouds with wrong rows: the slope is what was planted, and the interval holds it."""

import numpy as np
import pytest

from similitude.populations.lines import fit_pair, out_of_sample, proportion, robust_sd, total_least_squares


def cloud(seed, n=150, *, exponent=1.0, factor=1.1, offset=0.0, scatter=0.03, wild=0.1):
    rng = np.random.default_rng(seed)
    x = rng.normal(0.0, 0.4, n)
    y = np.log(factor * np.exp(exponent * x) + offset) + scatter * rng.standard_normal(n)
    bad = rng.random(n) < wild
    return x, np.where(bad, y + rng.normal(0, 1.0, n), y)


def test_total_least_squares_is_the_first_principal_axis_and_does_not_care_for_names():
    x, y = cloud(0, exponent=0.7, wild=0.0)
    slope, intercept = total_least_squares(x, y)
    back, _ = total_least_squares(y, x)
    vectors = np.linalg.eigh(np.cov(x, y))[1]

    assert slope == pytest.approx(vectors[1, 1] / vectors[0, 1]) and back == pytest.approx(1 / slope)
    assert intercept == pytest.approx(y.mean() - slope * x.mean())


@pytest.mark.slow
def test_a_proportion_is_called_one_and_its_slope_is_found():
    hits = 0
    for seed in range(40):
        fit = fit_pair(*cloud(seed))
        hits += fit.kind == "line" and fit.intervals["slope"][0] <= 1.1 <= fit.intervals["slope"][1]
        assert fit.coefficients.get("slope", 1.1) == pytest.approx(1.1, rel=0.02)

    assert hits >= 32  # of 38 expected; four sds below


def test_a_power_law_and_a_line_with_an_intercept_are_told_apart():
    power = fit_pair(*cloud(1, exponent=0.6))
    line = fit_pair(*cloud(2, factor=1.0, offset=-0.3))

    assert power.kind == "power" and power.coefficients["exponent"] == pytest.approx(0.6, abs=0.03)
    assert line.kind == "line" and line.coefficients["intercept"] == pytest.approx(-0.3, abs=0.02)
    assert line.predict(np.zeros(1))[0] == pytest.approx(np.log(0.7), abs=0.02)


def test_out_of_sample_error_is_the_scatter_and_a_little():
    x, y = cloud(3, wild=0.0)
    fit = fit_pair(x, y)

    assert fit.scatter == pytest.approx(0.03, rel=0.2)
    assert 0.8 * fit.scatter < out_of_sample(x, y, fit) < 1.3 * fit.scatter


def test_four_rows_are_enough_for_an_answer_that_admits_its_width():
    x, y = cloud(4, n=4, wild=0.0)
    fit = proportion(x, y)

    assert fit.intervals["slope"][0] < fit.coefficients["slope"] < fit.intervals["slope"][1]
    assert np.isfinite(out_of_sample(x, y, fit))
    assert robust_sd(np.array([1.0, 1.0, 5.0])) == 0.0
