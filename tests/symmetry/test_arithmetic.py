"""The three arithmetics agree, and series in time are those of the composed function."""

import mpmath
import numpy as np
import pytest
import sympy as sp

from similitude.symmetry.arithmetic import DIGITS, PRIME, BadPoint, Digits, Floats, Modular, Series, run
from similitude.symmetry.tape import record

x, y, t = sp.symbols("x y t", real=True)


def test_modular_values_are_the_residues_of_the_exact_ones():
    e = (x**2 - 3 * y) / (x + y**2) + sp.Rational(2, 7) / y
    parts = [e, e.diff(x), e.diff(y)]
    exact = [part.subs({x: 3, y: 5}) for part in parts]

    got = run(record([e]), Modular(), {"x": np.array([3, 1, 0]), "y": np.array([5, 0, 1])})[0]

    assert [int(v) for v in got] == [Modular().number(sp.Rational(v)) for v in exact]


@pytest.mark.parametrize(
    "e",
    [
        x * y / (1 + x),
        sp.sin(x) * sp.exp(y),
        sp.sqrt(x + y),
        x**y,
        sp.tanh(x) + sp.asin(y / 4),
        sp.Max(x, y) * x,
    ],
    ids=str,
)
def test_series_are_taylor_coefficients(e):
    path = {x: sp.Rational(6, 5) + t + t**2, y: sp.Rational(7, 10) - 2 * t}
    with mpmath.workdps(DIGITS):
        number = Digits().number
        symbols = {
            "x": [
                np.array([number(sp.Rational(6, 5))]),
                np.array([mpmath.mpf(1)]),
                np.array([mpmath.mpf(1)]),
            ],
            "y": [np.array([number(sp.Rational(7, 10))]), np.array([mpmath.mpf(-2)])],
        }
        series = Series(record([e]), Digits(), symbols)
        for order in range(4):
            got = series.advance()[0][0]
            meant = e.subs(path).diff(t, order).subs(t, 0) / sp.factorial(order)
            assert abs(got - number(sp.N(meant.doit(), DIGITS))) < mpmath.mpf(10) ** -45


def test_slopes_of_a_series_are_the_series_of_the_slopes():
    e = x**3 / y
    series = Series(
        record([e]),
        Floats(),
        {"x": [np.array([2.0, 1.0]), np.array([0.5, 0.0])], "y": [np.array([4.0, 0.0])]},
    )
    series.advance()
    path = 2 + t / 2
    a = sp.Symbol("a")
    meant = ((path + a) ** 3 / 4).diff(t).subs(t, 0)

    assert series.advance()[0] == pytest.approx([float(meant.subs(a, 0)), float(meant.diff(a).subs(a, 0))])


@pytest.mark.parametrize(
    ("e", "field", "at"),
    [
        (1 / (x - 1), Floats(), 1.0),
        (1 / (x - 1), Modular(), 1),
        (sp.sqrt(x), Floats(), -1.0),
        (sp.log(x), Digits(), mpmath.mpf(-1)),
        (sp.exp(x), Floats(), 1e9),
    ],
    ids=("pole", "pole modulo", "root", "logarithm", "overflow"),
)
def test_a_singular_point_is_said_to_be_one(e, field, at):
    with pytest.raises(BadPoint):
        run(record([e]), field, {"x": np.array([at, 1], dtype=field.dtype)})


def test_residues_that_are_drawn_are_never_zero():
    drawn = Modular().draw(np.random.default_rng(1), 1000)

    assert drawn.min() >= 1 and drawn.max() < PRIME


def test_residues_follow_the_branches_of_a_point_of_real_numbers():
    tape, choices = record([sp.Max(x, y) * sp.Abs(x - y)]), {}
    run_at = {"x": [np.array([1.0])], "y": [np.array([3.0])]}
    Series(tape, Floats(), run_at, choices).advance()

    residues = {"x": [np.array([5])], "y": [np.array([4])]}  # in whose order there is no meaning
    got = Series(tape, Modular(), residues, choices).advance()[0]

    assert int(got[0]) == 4 * -(5 - 4) % PRIME  # y is the larger, and x - y is negative
