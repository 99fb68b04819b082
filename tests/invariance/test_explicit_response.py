"""A formula as a response: arguments are what occurs in it, slopes those of calculus."""

import numpy as np
import sympy as sp

from similitude.homogeneity.measure import NONE, Measure
from similitude.invariance.explicit_response import explicit_response
from similitude.units import LENGTH

x, y = sp.symbols("x y", real=True)
MEASURES = {"x": Measure(LENGTH), "unused": NONE, "y": Measure(LENGTH)}


def test_values_and_slopes():
    response = explicit_response(x**2 / y, MEASURES, Measure(LENGTH), "function", "test")
    value, slopes = response.evaluate({"x": np.array([2.0, 3.0]), "y": 4.0})

    assert list(response.arguments) == ["x", "y"]
    assert value.tolist() == [1.0, 2.25]
    assert slopes["x"].tolist() == [2.0, 4.5] and slopes["y"].tolist() == [-1.0, -2.25]
