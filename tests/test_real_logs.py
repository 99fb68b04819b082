"""What holds on the bundled real logs, and which logs contradict themselves: none has a known truth."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "scripts"))

from real_logs import LOGS, examined

from similitude.verdict import LINEAR, NOTED_SHARE

pytestmark = pytest.mark.slow
EXCITED = [name for name in LOGS if name != "rav4_straight"]
RESTLESS = {"f1tenth_ds5"}  # halves apart by more than both intervals: each ends in slow manoeuvring
NO_NUMBER = {"not_excited", "outside_population"}  # K is said not to be one


@pytest.fixture(scope="module")
def logs():
    return {name: examined(name) for name in LOGS}


def test_a_second_ahead_the_estimate_beats_the_average_car(logs):
    for judge, mean in (("ratio_to_frozen", 0.65), ("ratio_to_averages_with_lag", 0.70)):
        ratio = {name: one.whole.prediction[judge] for name, one in logs.items()}
        assert np.exp(np.mean(np.log(list(ratio.values())))) <= mean, judge
        assert max(ratio.values()) <= 1.05, judge  # never worse
        assert max(ratio[name] for name in EXCITED) <= 0.95, judge


def test_it_predicts_nearly_as_well_as_the_fit_that_has_seen_the_future(logs):
    ratio = {name: one.whole.prediction["ratio_to_batch"] for name, one in logs.items()}
    assert np.exp(np.mean(np.log(list(ratio.values())))) <= 1.12
    assert max(ratio.values()) <= 1.35  # the lane change has 25 predictions


def test_halves_of_a_log_agree_within_their_intervals(logs):
    assert {name for name, one in logs.items() if one.halves_apart > 1} <= RESTLESS


def test_intervals_are_not_much_wider_than_those_of_the_whole_log(logs):
    for name, one in logs.items():
        fit = one.whole.batch.K
        width = one.whole.trace.ln_K_std[-1] / (fit.std / fit.value)
        assert width <= 1.5 or one.whole.verdict in NO_NUMBER, name


def test_a_visit_to_the_limit_leaves_K_where_it_was(logs):
    for name, one in logs.items():
        assert max(map(abs, one.visits), default=0.0) <= 3, name


def test_little_is_learnt_beyond_the_linear_range_or_it_is_said(logs):
    for name in ("f1tenth_ds1", "f1tenth_ds4", "f1tenth_ds5"):
        run = logs[name].whole
        beyond = np.abs(run.trace.ay_kinematic) > LINEAR
        told = np.diff(run.trace.information, prepend=0.0)
        share = float(told[beyond].sum() / told.sum())
        assert share < beyond.mean(), name  # one sample in 0.2 s against every one
        said = run.verdict == "outside_model" or any("beyond 0.3 g" in line for line in run.warnings)
        assert said or share <= NOTED_SHARE, name


def test_no_log_is_surer_of_a_slow_group_than_half_the_population(logs):
    for one in logs.values():
        for name in ("pi1", "eta", "rho"):
            group = one.whole.groups[name]
            relative = 1.0 if name == "pi1" else group.value / group.prior_value
            assert group.std >= 0.5 * group.prior_std * relative * (1 - 1e-9)


def test_the_servo_of_the_f1tenth_is_its_own(logs):
    """3.2 rad/s is the slew that simulators of the car have."""
    told = [logs[name].whole for name in EXCITED[1:] if logs[name].whole.verdict not in NO_NUMBER]
    assert len(told) >= 3
    for run in told:
        assert 2.5 <= run.lag.servo.slew <= 4.2
        assert 0.0 < run.lag.servo.constant <= 0.08
    assert not logs["f1tenth_ds5"].whole.cross_check.structure_error
