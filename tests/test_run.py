"""The front door: names, messages, and the estimate of a positive quantity."""

import dataclasses

import numpy as np
import pytest

from similitude.errors import UsageError
from similitude.run import (
    Assumed,
    Estimate,
    Group,
    Nuisance,
    Trace,
    axle_stiffness,
    held,
    identify,
    positive_estimate,
)
from similitude.units import Uncertain

from .simulated_drive import CAR, drive, vehicle


@pytest.mark.parametrize("name", ["papr", "", "Population", "ekf"])
def test_an_estimator_of_another_name_is_refused_in_four_parts(name):
    with pytest.raises(UsageError) as refused:
        identify(drive(seconds=3), vehicle(), estimator=name)
    assert repr(name) in refused.value.what
    assert "population" in refused.value.what and "paper" in refused.value.what
    assert len(str(refused.value).splitlines()) == 4


def test_a_vehicle_without_a_wheelbase_is_refused():
    with pytest.raises(UsageError, match="wheelbase"):
        identify(drive(seconds=3), dataclasses.replace(vehicle(), L=None))


def test_the_default_is_the_population_filter():
    assert identify(drive(seconds=3), vehicle()).estimator == "population"


def test_the_papers_estimator_is_reached_by_name():
    run = identify(drive(seconds=5), vehicle(), estimator="paper")
    assert run.estimator == "paper"
    assert np.isfinite(run.trace.K).all()


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
