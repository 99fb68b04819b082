"""When the first unknown is taken to have jumped, against the statistics it should have."""

import numpy as np
import pytest
import sympy as sp
from tests.run_statements import evaluate, run_statements

from similitude.estimators.filter_jump import doubt, jump, moved_score, quiet_drift

DT, RATE = 0.01, 0.2  # s, 1/s
SOUND = {
    "dt": DT, "score_rate": RATE, "score_enough": 2.0, "score_most": 5.0, "prior_information": 4.0,
    "linear": 1.0, "sensitivity": 0.2, "inv_spread": 1.0, "heard": 0.0, "score": 0.0,
}  # fmt: skip
INFORMATION = SOUND["sensitivity"] ** 2 / DT / RATE  # of five seconds, once they are over


def followed(innovations, variance=0.0):
    """Score over its variance after each innovation of sd one, the unknown held."""
    values, found = dict(SOUND), []
    lines = doubt(sp.Float(variance))
    for e in innovations:
        values = run_statements(lines, values | {"innovation": float(e)})
        found.append(values["score"] ** 2 / values["score_variance"])
    return np.array(found), values


def test_the_information_is_that_of_the_last_seconds():
    _, values = followed(np.zeros(4000))
    # exp(-8) of it is not there yet, and a sample counts whole
    assert values["heard"] == pytest.approx(INFORMATION, rel=2e-3)


def test_white_innovations_leave_half_of_the_claimed_variance():
    """A sum that forgets has half the variance of its information."""
    rng = np.random.default_rng(1)
    ratio = np.mean([followed(rng.standard_normal(10_000))[0][2000:].mean() for _ in range(4)])
    expected = 0.5 * INFORMATION / (INFORMATION + SOUND["prior_information"])
    # 4 runs of 80 s hold 64 independent values of a chi-squared: sd sqrt(2/64) of the mean, three of them
    assert abs(ratio - expected) < 3 * np.sqrt(2 / 64) * expected


def test_a_jump_moves_the_score_by_information_times_its_size():
    d = -0.69
    found, values = followed(np.full(4000, SOUND["sensitivity"] * d))
    assert values["score"] == pytest.approx(values["heard"] * d)
    assert found[-1] > SOUND["score_enough"]


def test_an_unknown_that_is_as_wide_as_the_jump_is_not_doubted():
    d = 0.69
    found, _ = followed(np.full(4000, SOUND["sensitivity"] * d), variance=d**2)
    assert found.max() < 1.0


def test_a_move_by_what_was_wrong_leaves_no_score():
    d = 0.3
    _, values = followed(np.full(3000, SOUND["sensitivity"] * d))
    after = run_statements([moved_score(sp.Float(d))], values)
    assert after["score"] == pytest.approx(0.0, abs=1e-9 * abs(values["score"]) + 1e-9)


@pytest.mark.parametrize("surprise", [0.2, 1.0, 2.0, 8.0])
@pytest.mark.parametrize("seen", [-2.0, 0.0, 4.0])
def test_a_jump_is_never_negative(surprise, seen):
    values = {"surprise": surprise, "restlessness": 0.1, "jump_ratio": 8.0, "surprise_limit": 1.5,
              "dt": DT, "noise_adapt": 0.05, "doubt": seen}  # fmt: skip
    found = run_statements(jump(), values)["jump"]
    assert found == max(0.0, surprise - 1.5, seen)


@pytest.mark.parametrize(("heard", "expected"), [(0.0, 1.1e-3), (30.0, 6e-4), (60.0, 1e-4), (900.0, 1e-4)])
def test_drift_falls_with_what_is_heard(heard, expected):
    values = {"drift": 1e-4, "faint_drift": 1e-3, "inv_telling": 1 / 60, "heard": heard}
    assert evaluate(quiet_drift(), values) == pytest.approx(expected)
