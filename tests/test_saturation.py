"""A saturating force: linear with a cubic onset, never above its limit, printed without a library."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from similitude.program.ir import Assign
from similitude.saturation import CUBIC, Saturation, SaturationSlope, arguments, spelt

x, y = sp.symbols("x y", real=True)


def number(f, at):
    return float(f(sp.Float(at)).doit())


@given(st.floats(-1e6, 1e6))
def test_it_is_odd_and_never_above_its_limit(at):
    value = number(Saturation, at)
    assert abs(value) <= 1
    assert value == -number(Saturation, -at)


@given(st.floats(-50, 50), st.floats(1e-6, 10))
def test_it_rises_everywhere(at, step):
    assert number(Saturation, at + step) >= number(Saturation, at)


def test_near_zero_it_is_linear_with_a_cubic_onset():
    """x - (1 - c) x^3: the tangent formula of tyres has a third of x^3, within what c says."""
    a = sp.Symbol("a", positive=True)
    series = sp.series(Saturation(a).doit().subs(sp.Max(a, -a), a), a, 0, 4).removeO()
    assert sp.simplify(series - (a - (1 - CUBIC) * a**3)) == 0


@pytest.mark.parametrize("at", [-30.0, -2.0, -1e-3, 1e-3, 0.3, 1.0, 7.0])
def test_the_slope_is_the_derivative(at):
    step = 1e-6 * max(abs(at), 1e-3)
    rise = (number(Saturation, at + step) - number(Saturation, at - step)) / (2 * step)
    assert number(SaturationSlope, at) == pytest.approx(rise, rel=1e-6, abs=1e-9)
    assert Saturation(x).diff(x) == SaturationSlope(x)


def test_without_a_force_nothing():
    assert Saturation(sp.Integer(0)) == 0


def test_each_load_is_saturated_once_and_its_statements_are_the_function():
    named = {"f": 3 * Saturation(x - y) + Saturation(y), "J": SaturationSlope(x - y) * y}
    loads = arguments(named)
    lines, plain = spelt(named, loads)

    assert sorted(loads.values(), key=str) == sorted([x - y, y], key=str)
    assert len([line for line in lines if line.target.startswith("part")]) == 2
    values = {x: 1.7, y: -0.4}
    known = dict(values)
    for line in [*(Assign(name, e) for name, e in loads.items()), *lines]:
        known[sp.Symbol(line.target, real=True)] = line.expression.subs(known)
    for name, expression in named.items():
        direct = expression.replace(lambda e: isinstance(e, Saturation | SaturationSlope), lambda e: e.doit())
        assert float(plain[name].subs(known)) == pytest.approx(float(direct.subs(values)), rel=1e-14)


def test_the_limit_is_reached_far_away():
    assert 1 - number(Saturation, 100.0) == pytest.approx(0, abs=2e-6)
    assert np.isfinite(number(Saturation, 1e6))
