"""Skewness and normality: raw products are skewed, their logarithms are not."""

import numpy as np
import pytest

from similitude.populations.distribution import describe


def test_a_lognormal_is_skewed_raw_and_normal_in_logs():
    x = np.exp(np.random.default_rng(0).normal(1.0, 0.5, 500))
    d = describe("x", x)

    assert (
        d.n == 500 and d.mean_log == pytest.approx(1.0, abs=0.07) and d.sd_log == pytest.approx(0.5, rel=0.1)
    )
    assert d.skew_raw > 1.0 and abs(d.skew_log) < 0.3  # 1.75 and 0; standard error of a skewness 0.11
    assert d.normal_raw < 1e-6 < d.normal_log
    assert d.below_zero > 0.001


def test_missing_values_and_weights():
    d = describe("x", np.array([1.0, np.nan, np.e, np.e]), np.array([1.0, 1.0, 0.5, 0.5]))

    assert d.n == 3 and d.mean_log == pytest.approx(0.5) and d.skew_raw is None
    assert describe("x", np.array([np.nan, 2.0])) is None
