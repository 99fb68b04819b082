"""What counts as shown of a decision, on steps small enough to be counted by hand."""

import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts" / "embedded_decisions.py"
STEP = "def step(a, b):\n    if (a > 0) and not (b > 0):\n        return 1\n    return 2 if a > 5 else 3\n"


@pytest.fixture(scope="module")
def decisions():
    spec = importlib.util.spec_from_file_location("embedded_decisions", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("calls", "left"),
    [
        ([], 3),
        ([(1, 0), (0, 0), (1, 1), (6, 1)], 0),
        ([(0, 0), (0, 1), (6, 1)], 2),  # the first was never decisive as true, the second never as false
        ([(1, 0), (0, 1), (1, 1), (6, 1)], 1),  # with b > 0 it does not matter what a is
    ],
)
def test_a_condition_is_shown_where_it_decided_both_ways(decisions, calls, left):
    watch, layout = decisions.watched(STEP, "small")
    plain = {}
    exec(STEP, plain)

    assert [layout.step(*c) for c in calls] == [plain["step"](*c) for c in calls]
    assert len(watch.trees) == 2 and sum(map(len, watch.leaves)) == 3
    assert len(watch.unshown()) == left
