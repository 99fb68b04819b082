"""The nouns of a result and the small laws they keep."""

import dataclasses

import numpy as np
import pytest

from similitude.run import (
    Assumed,
    Estimate,
    Group,
    Nuisance,
    Trace,
    axle_stiffness,
    held,
    positive_estimate,
)
from similitude.units import Uncertain

from .simulated_drive import CAR, vehicle


def test_a_positive_estimate_is_symmetric_in_its_logarithm():
    found = positive_estimate(110.0, 0.1, "m^2/s^2")
    assert found.std == pytest.approx(11.0)
    assert np.log(found.hi / 110) == pytest.approx(1.96 * 0.1)
    assert np.log(110 / found.lo) == pytest.approx(1.96 * 0.1)
    assert found.unit == "m^2/s^2"


@pytest.mark.parametrize("log_std", [0.0, 1e-12, 5.0, 1e3, 1e300])
def test_an_interval_is_positive_and_finite_whatever_the_sd(log_std):
    found = positive_estimate(110.0, log_std, "-")
    assert 0 < found.lo <= found.value <= found.hi < np.inf


def test_axle_stiffness_is_K_m_over_L_with_the_masss_own_doubt():
    K = positive_estimate(110.0, 0.03, "m^2/s^2")
    exact = axle_stiffness(vehicle(m=Uncertain(1500.0, None, "kg")), K)
    doubted = axle_stiffness(vehicle(m=Uncertain(1500.0, 60.0, "kg")), K)
    assert exact.value == doubted.value == pytest.approx(110.0 * 1500 / CAR["L"])
    assert exact.std / exact.value == pytest.approx(0.03)
    assert doubted.std / doubted.value == pytest.approx(0.05)  # 3-4-5
    assert exact.unit == "N/rad"
    assert axle_stiffness(vehicle(), K) is None


def test_a_missing_value_is_that_of_the_row_before():
    nan = np.nan
    assert held(np.array([nan, 1.0, nan, nan, 3.0, nan])).tolist() == [1, 1, 1, 1, 3, 3]
    assert held(np.array([nan, nan])).tolist() == [0, 0]
    assert held(np.array([2.0])).tolist() == [2]


@pytest.mark.parametrize("noun", [Estimate, Group, Nuisance, Assumed, Trace])
def test_results_cannot_be_changed(noun):
    made = noun(*range(len(dataclasses.fields(noun))))
    with pytest.raises(dataclasses.FrozenInstanceError):
        setattr(made, dataclasses.fields(noun)[0].name, 0)
