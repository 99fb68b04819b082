"""Values into groups and back, time under a scale that moves, and what is refused."""

import numpy as np
import pytest

from similitude.errors import ModelError
from similitude.rewriting.rewritten import rewrite
from similitude.rewriting.scaling import into_groups, out_of_groups
from similitude.systems.bicycle import BICYCLE

REWRITTEN = rewrite(BICYCLE, base=("m", "L", "U"), moving=["U"])
CAR = {
    "m": "5.451 kg", "Iz": 0.1615, "U": "4 m/s", "a": 0.1461, "b": 0.2191, "L": 0.3652, "Caf": 65, "Car": 110
}  # fmt: skip


def test_the_groups_of_the_papers_vehicle():
    found = into_groups(REWRITTEN, CAR)

    assert found == {
        "pi1": pytest.approx(0.40005, abs=5e-6), "pi2": pytest.approx(0.59995, abs=5e-6),
        "pi3": pytest.approx(0.27217, abs=5e-6), "pi4": pytest.approx(0.46060, abs=5e-6),
        "pi5": pytest.approx(0.22214, abs=5e-6),
    }  # fmt: skip


def test_there_and_back_with_a_speed_that_changes():
    t = np.linspace(0, 2, 5)
    values = CAR | {"U": 4 + t, "t": t, "r": np.sin(t), "delta": 0.1, "U_rate": 1.0}
    there = into_groups(REWRITTEN, values)
    back = out_of_groups(REWRITTEN, there, {"m": 5.451, "L": 0.3652, "U": 4 + t})

    # the pace is linear in time, so trapezoids are exact
    assert there["t"] == pytest.approx((4 * t + t**2 / 2) / 0.3652)
    assert there["U_rate"] == pytest.approx(0.3652 / (4 + t) ** 2)
    for name in ("U", "r", "delta", "U_rate", "Iz", "Caf"):
        assert back[name] == pytest.approx(np.broadcast_to(values[name], np.shape(back[name])))


def test_with_scales_that_stand_still_time_is_counted_from_zero():
    there = into_groups(REWRITTEN, {"m": 1, "L": 2, "U": 4, "t": [1.0, 2.0]})

    assert there["t"].tolist() == [2.0, 4.0] and set(there) == {"t"}
    assert out_of_groups(REWRITTEN, there, {"m": 1, "L": 2, "U": 4})["t"].tolist() == [1.0, 2.0]


def test_what_is_missing_or_strange_is_named():
    with pytest.raises(ModelError, match=r"the value of L \[m\] is missing"):
        into_groups(REWRITTEN, {"m": 1, "U": 1})
    with pytest.raises(ModelError, match="given for q"):
        into_groups(REWRITTEN, {**CAR, "q": 1})
    with pytest.raises(ModelError, match="'Caf' is nothing of the rewritten model"):
        out_of_groups(REWRITTEN, {"Caf": 1.0}, {"m": 1, "L": 2, "U": 4})
