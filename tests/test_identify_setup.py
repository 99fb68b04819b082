"""What the estimators share: preparing, the whole-log fit, edges, and what a reader is told."""

import dataclasses

import numpy as np
import pytest

from similitude.identification import identify
from similitude.identify_setup import (
    APART,
    group_table,
    held_by_limits,
    prepare,
    reported,
    warnings_of,
    whole_log,
    with_fitted_lag,
    with_whole_log,
)
from similitude.units import Uncertain

from .filter_rig import CAR as PRIOR
from .simulated_drive import CAR, drive, vehicle


@pytest.fixture(scope="module")
def ready():
    return prepare(drive(seconds=40), vehicle())


@pytest.fixture(scope="module")
def batch(ready):
    return whole_log(ready, ready.setup.run())


def test_a_stated_lag_is_the_fit_s_prior(ready):
    stated = prepare(ready.setup.log, vehicle(steer_lag=Uncertain(0.02, 0.004, "s")))
    prior = whole_log(stated, stated.setup.run()).frozen.prior
    assert prior.mean[5] == pytest.approx(0.03) and prior.std[5] * 0.03 == pytest.approx(0.004)


def test_the_lag_of_a_measured_angle_is_that_of_a_fit_that_came_to_rest(ready, batch):
    assert ready.scan.origin == "assumed" and batch.settled
    fitted = with_fitted_lag(ready, batch)
    assert fitted.scan.origin == "fitted" and 0 < fitted.scan.std < 0.02
    assert fitted.setup.lag == fitted.scan.chosen == pytest.approx(batch.values["steer_lag"], abs=5e-5)
    assert with_fitted_lag(ready, None) is ready
    assert with_fitted_lag(ready, dataclasses.replace(batch, settled=False)) is ready
    stated = prepare(ready.setup.log, vehicle(steer_lag=Uncertain(0.02, 0.004, "s")))
    command = dataclasses.replace(ready, commanded=True)
    assert all(with_fitted_lag(one, batch) is one for one in (stated, command))


def test_a_steer_that_the_fit_finds_as_late_as_a_command_is_one():
    """The scan saw a measured angle; 45 ms are no such angle's, unless the vehicle file says that it is."""
    late = drive(seconds=40, rms=0.03, lag=0.045, rate=50, seed=2)
    unseen = prepare(late, vehicle(steer="measured"))
    assert not unseen.commanded
    for steer, is_command in ((None, True), ("measured", False)):
        ready, batch = with_whole_log(dataclasses.replace(unseen, vehicle=vehicle(steer=steer)))
        assert ready.commanded is is_command
        assert ready.scan.total == pytest.approx(0.045, abs=0.012)
        assert batch.frozen.prior.std[4] == pytest.approx(0.2 if is_command else 0.02)


def test_a_steer_in_step_with_the_gyro_leaves_no_bias():
    """Twelve cars whose lag is nothing: the fit's lag is as far off as it says, and K is on average right.

    With a prior of ln lag, which has nothing infinitely far away, K read 1.5 to 3 % high.
    """
    off = []
    for seed in range(12):
        one = prepare(drive(seconds=30, rms=0.01, seed=seed), vehicle())
        ready, batch = with_whole_log(one)
        off.append([ready.scan.chosen / ready.scan.std, np.log(batch.values["K"] / CAR["K"]) / batch.std[0]])
    lag, K = np.array(off).T
    assert np.sqrt(np.mean(lag**2)) < 1.5  # 1 +- 0.2 of honest sds, on one and the same car's prior
    assert abs(np.mean(K)) < 3 / np.sqrt(12)


def test_at_town_speed_twenty_milliseconds_no_longer_pass_for_soft_tyres():
    """The steer acts 20 ms late, and K is within its interval, on average near the truth.

    With the lag taken as nothing, or as the scan has it, K reads an eighth too low on average.
    """
    found = {"lag nothing": [], "lag open": []}
    for seed in range(4):
        log = drive(seconds=60, rms=0.05, U=8.0, rate=50, lag=0.02, band=(0.05, 0.3), K=180.0, seed=seed)
        for name, car in (("lag nothing", vehicle(steer_lag=Uncertain(0.0, None, "s"))),
                          ("lag open", vehicle())):  # fmt: skip
            K = identify(log, car).K
            found[name].append(np.log(K.value / 180.0))
            assert name == "lag nothing" or K.lo < 180.0 < K.hi
    assert np.mean(found["lag nothing"]) < -0.09
    assert abs(np.mean(found["lag open"])) < 0.05


def test_a_command_has_a_wide_scale_and_a_long_lag():
    late = prepare(drive(seconds=60, rms=0.01, lag=0.1), vehicle())
    assert late.commanded
    prior = whole_log(late, late.setup.run()).frozen.prior
    assert prior.std[4] == pytest.approx(0.2) and prior.mean[5] == pytest.approx(0.11)
    assert any("command" in line for line in warnings_of(late, None, learnt=True))


def test_the_report_is_that_of_the_fit(batch):
    said = reported(batch)
    assert said.K.value == pytest.approx(batch.values["K"])
    assert np.log(said.K.hi / said.K.lo) == pytest.approx(2 * 1.96 * batch.std[0])
    assert set(said.correlation) == {"pi1", "eta", "rho", "steer_scale", "steer_lag"}
    assert all(-1 <= value <= 1 for value in said.correlation.values())


def test_unknowns_near_a_limit_are_named():
    x = PRIOR.coordinates(PRIOR.mean)
    low, high = x - 2.5 * PRIOR.std, x + 2.5 * PRIOR.std
    assert held_by_limits(x, low, high, PRIOR, 0.1) == ()
    moved = x + np.array([0, 0, 2.45, 0]) * PRIOR.std
    assert held_by_limits(moved, low, high, PRIOR, 0.1) == ("eta",)
    assert held_by_limits(x, low, high, PRIOR, 1.0) == ("K",)


def test_groups_stand_beside_the_population():
    values = dict(zip(PRIOR.names, PRIOR.mean.tolist(), strict=True))
    table = group_table(values, PRIOR.std, PRIOR)
    for group in table.values():
        assert group.value == group.prior_value and group.std == pytest.approx(group.prior_std)


def test_one_drive_is_not_surer_of_a_slow_group_than_half_the_population():
    values = dict(zip(PRIOR.names, PRIOR.mean.tolist(), strict=True))
    table = group_table(values, 0.01 * PRIOR.std, PRIOR)
    shares = {name: group.std / group.prior_std for name, group in table.items()}
    assert shares == pytest.approx({"K": 0.01, "pi1": 0.5, "eta": 0.5, "rho": 0.5})


def test_what_trades_and_what_changed_is_said(ready, batch):
    lines = warnings_of(ready, batch, learnt=True)
    assert any("K and steer scale trade" in line and "correlation" in line for line in lines)
    assert not any("first half" in line for line in lines)
    halves = dataclasses.replace(batch.halves, first=5.0, second=4.5, apart=APART + 1)
    changed = dataclasses.replace(batch, halves=halves, settled=False)
    lines = warnings_of(ready, changed, learnt=True)
    assert any("first half" in line and "148" in line and "90" in line for line in lines)
    assert any("come to rest" in line for line in lines)
    assert not any("trade" in line for line in warnings_of(ready, changed, learnt=False))
    assert CAR["L"] == ready.setup.L
