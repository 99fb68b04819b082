"""A model simulated, against closed forms and with a drive."""

import numpy as np
import pytest

from similitude.errors import ModelError
from similitude.invariance.trajectory import trajectory
from similitude.model import Model, Quantity

SPRING = Model(
    "spring", [Quantity("x", "m"), Quantity("v", "m/s")], [Quantity("F", "N")],
    [Quantity("x", "m"), Quantity("E", "J", "energy")], [Quantity("m", "kg"), Quantity("k", "N/m")],
    {"x": "v", "v": "(F - k*x)/m"}, {"x": "x", "E": "m*v^2/2 + k*x^2/2"},
)  # fmt: skip
TIMES = np.linspace(0, 3, 7)


def test_a_free_oscillation_keeps_its_energy():
    found = trajectory(SPRING, TIMES, {"m": "1 kg", "k": "4 N/m", "x": "2 m", "F": 0.0})

    assert found["x"] == pytest.approx(2 * np.cos(2 * TIMES), abs=1e-10)
    assert found["E"] == pytest.approx(np.full(7, 8.0), abs=1e-9)
    assert set(found) == {"t", "x", "v", "E"}


def test_a_driven_one():
    drive = {"F": "P*t"}
    found = trajectory(
        SPRING, TIMES, {"m": 1, "k": 4, "P": 4}, drive=drive, quantities=[Quantity("P", "N/s")]
    )

    assert found["x"] == pytest.approx(TIMES - np.sin(2 * TIMES) / 2, abs=1e-10)


def test_a_missing_value_is_named():
    with pytest.raises(ModelError, match="the value of k"):
        trajectory(SPRING, TIMES, {"m": 1, "F": 0})


@pytest.mark.parametrize(
    ("given", "said"), [(np.zeros(7), r"F is an array of shape \(7,\)"), (1j, "F is the complex")]
)
def test_a_signal_over_time_is_no_value(given, said):
    with pytest.raises(ModelError, match=said):
        trajectory(SPRING, TIMES, {"m": 1, "k": 4, "F": given})
