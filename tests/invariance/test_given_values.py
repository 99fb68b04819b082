"""Values in SI or as text; what is known or follows is filled in; the rest is asked for by name."""

import numpy as np
import pytest

from similitude.errors import ModelError, UnitError
from similitude.homogeneity.measure import Measure
from similitude.invariance.given_values import read_values
from similitude.model import Model, Quantity
from similitude.systems.bicycle import BICYCLE
from similitude.units import LENGTH, MASS

WANTED = {"m": Measure(MASS), "L": Measure(LENGTH)}


def test_text_numbers_and_arrays():
    values = read_values({"m": "2 t", "L": [1, 2]}, WANTED)

    assert values["m"] == 2000.0 and values["L"].tolist() == [1, 2]
    assert read_values({"m": 1, "L": 2j}, WANTED)["L"] == 2j


def test_a_constraint_gives_what_is_not_given():
    wanted = {"b": Measure(LENGTH)}

    assert read_values({"L": 3.0, "a": "1 m"}, wanted, model=BICYCLE) == {"b": 2.0}
    assert read_values({"L": 3.0, "a": 1.0, "b": 5.0}, wanted, model=BICYCLE) == {"b": 5.0}


def test_a_known_value_need_not_be_given():
    drop = Model(
        "drop", [Quantity("v", "m/s")], [], [Quantity("v", "m/s")],
        [Quantity("g", "m/s^2", known="981 cm/s^2")], {"v": "-g"},
    )  # fmt: skip

    assert read_values({}, {"g": Measure()}, model=drop)["g"] == pytest.approx(9.81)


@pytest.mark.parametrize(
    ("given", "error", "said"),
    [
        ({"m": 1.0}, ModelError, r"the value of L \[m\] is missing"),
        ({}, ModelError, r"the value of m \[kg\] is missing \(and of L\)"),
        ({"m": 1, "L": 1, "q": 2}, ModelError, r"a value is given for q, .*arguments: m, L"),
        ({"m": "1 m", "L": 1}, UnitError, "dimension"),
        ({"m": np.nan, "L": 1}, ModelError, "the value of m is nan"),
        ({"m": None, "L": 1}, ModelError, "the value of m is None"),
        ({"m": ["a"], "L": 1}, ModelError, "no finite number"),
    ],
)
def test_a_value_that_is_none_is_refused_by_name(given, error, said):
    with pytest.raises(error, match=said):
        read_values(given, WANTED)
