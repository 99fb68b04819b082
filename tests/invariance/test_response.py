"""A certificate is zero where its formula is homogeneous as stated, and what is left over where not."""

import sympy as sp

from similitude.homogeneity.measure import NONE, Measure
from similitude.invariance.response import Certificate
from similitude.units import LENGTH, TIME

x, t = sp.symbols("x t", real=True)
SYMBOLS = {x: Measure(LENGTH), t: Measure(TIME)}


def test_a_certificate_holds_for_the_right_measure_alone():
    speed = Measure(LENGTH / TIME)

    assert Certificate("speed", 3 * x / t, speed).residual(SYMBOLS, "time") == 0
    assert Certificate("speed", 3 * x / t, NONE).residual(SYMBOLS, "length") == 3 * x / t
