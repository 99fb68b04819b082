"""When the first unknown is taken to have jumped, against the statistics it should have."""

import pytest
from tests.run_statements import evaluate, run_statements

from similitude.estimators.filter_jump import heard, jump, quiet_drift

DT, RATE = 0.01, 0.2  # s, 1/s


def test_the_information_is_that_of_the_last_seconds():
    values = {"dt": DT, "heard_rate": RATE, "sensitivity": 0.2, "inv_spread": 1.5, "heard": 0.0}
    line = [heard()]
    for _ in range(4000):
        values = run_statements(line, values)
    # exp(-8) of it is not there yet, and a sample counts whole
    assert values["heard"] == pytest.approx(1.5 * 0.2**2 / DT / RATE, rel=2e-3)


@pytest.mark.parametrize("surprise", [0.2, 1.0, 2.0, 8.0])
def test_a_jump_is_never_negative(surprise):
    values = {"surprise": surprise, "restlessness": 0.1, "jump_ratio": 8.0, "surprise_limit": 1.5,
              "dt": DT, "noise_adapt": 0.05}  # fmt: skip
    found = run_statements(jump(), values)["jump"]
    assert found == max(0.0, surprise - 1.5)


@pytest.mark.parametrize(("heard", "expected"), [(0.0, 1.1e-3), (30.0, 6e-4), (60.0, 1e-4), (900.0, 1e-4)])
def test_drift_falls_with_what_is_heard(heard, expected):
    values = {"drift": 1e-4, "faint_drift": 1e-3, "inv_telling": 1 / 60, "heard": heard}
    assert evaluate(quiet_drift(), values) == pytest.approx(expected)
