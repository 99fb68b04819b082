"""Where a system comes to rest, and what moves that point, against closed forms."""

import pytest

from similitude.errors import ModelError
from similitude.invariance.invariances import invariances
from similitude.model import Model, Quantity


def tank() -> Model:
    return Model(
        "tank", [Quantity("h", "m")], [Quantity("q", "m^3/s")], [Quantity("h", "m")],
        [Quantity("A", "m^2"), Quantity("a", "m^2"), Quantity("g", "m/s^2", known="9.81 m/s^2")],
        {"h": "(q - a*sqrt(2*g*h))/A"},
    )  # fmt: skip


def test_a_tank_comes_to_rest_at_half_the_square_of_the_speed_over_gravity():
    rows = invariances(tank(), response="steady_state")
    values = {"A": 1.0, "a": "2 cm^2", "q": "0.5 L/s", "h": 0.1}

    assert rows.value(values) == pytest.approx(2.5**2 / (2 * 9.81))
    assert rows.sensitivities(values) == {
        "q": pytest.approx(2), "A": pytest.approx(0, abs=1e-12),
        "a": pytest.approx(-2), "g": pytest.approx(-1),
    }  # fmt: skip
    assert max(rows.verify(values).values()) < 1e-9
    assert rows.verify() == {"length": 0, "time": 0}


def test_what_is_never_at_rest_is_said_not_to_be():
    values = {"A": 1.0, "a": 1.0, "q": 1.0}  # the root of a level of zero has no slope
    with pytest.raises(ModelError, match="was not found at rest"):
        invariances(tank(), response="steady_state").value(values)
