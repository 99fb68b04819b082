"""Compiled expressions give what SymPy gives, saturations and their slopes included."""

import numpy as np
import pytest
import sympy as sp

from similitude.invariance.compiled import compiled, log_slope
from similitude.saturation import Saturation, SaturationBend, SaturationSlope

x, y = sp.symbols("x lambda", real=True)


def test_numbers_and_arrays_go_in_whatever_the_symbols_are_called():
    function = compiled([x, y], [x * y, sp.sin(x) + sp.sin(x) ** 2])

    assert function(2.0, 3.0) == [6.0, pytest.approx(np.sin(2) + np.sin(2) ** 2)]
    assert function(np.array([1.0, 2.0]), 3.0)[0].tolist() == [3.0, 6.0]


@pytest.mark.parametrize("at", [-3.0, -0.2, 0.0, 0.4, 7.0])
def test_the_saturation_its_slope_and_its_bend_are_each_other_s_derivatives(at):
    step = 1e-5
    s, slope, bend = (compiled([x], [f(x)]) for f in (Saturation, SaturationSlope, SaturationBend))

    def difference(f):
        return (f(at + step)[0] - f(at - step)[0]) / (2 * step)

    assert difference(s) == pytest.approx(slope(at)[0], abs=1e-9)
    assert difference(slope) == pytest.approx(bend(at)[0], abs=2e-5)  # the bend itself has a corner at zero


def test_a_logarithmic_slope():
    assert log_slope(x**3, x) == 3 * x**3
