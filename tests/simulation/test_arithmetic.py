"""Floats and arrays answer alike."""

import numpy as np
import pytest

from similitude.simulation.arithmetic import ARRAYS, FLOATS, arithmetic_for


@pytest.mark.parametrize("name", ["sin", "cos", "atan", "sign"])
@pytest.mark.parametrize("x", [-2.5, -0.0, 0.0, 0.3, 1.7])
def test_functions_of_one_value(name, x):
    many = getattr(ARRAYS, name)(np.array([x]))[0]

    # one unit in the last place: two libraries may round differently
    assert getattr(FLOATS, name)(x) == pytest.approx(many, rel=3e-16, abs=0)


def test_functions_of_two_values_and_the_choice():
    x, y = 0.3, -0.7
    for on, one in ((FLOATS, float), (ARRAYS, lambda v: np.array([v]))):
        assert on.minimum(one(x), one(y)) == y and on.maximum(one(x), one(y)) == x
        assert on.where(one(x) > 0, one(x), one(y)) == x and on.sqrt(one(4.0)) == 2
        assert on.any(one(x) > 0) and not on.any(one(x) < 0)


def test_which_one_is_wanted():
    assert arithmetic_for(1.0, 2) is FLOATS and arithmetic_for(1.0, np.zeros(2)) is ARRAYS
