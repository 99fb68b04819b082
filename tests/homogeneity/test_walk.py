"""The walk over an expression finds its dimension, and each part that does not fit."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.homogeneity.measure import NONE, Measure
from similitude.homogeneity.walk import measure_of_expression, mismatches
from similitude.saturation import Saturation
from similitude.units import LENGTH, MASS, TIME, Dimension, parse_unit

UNITS = {"F": "N", "m": "kg", "v": "m/s", "x": "m", "c": "m/s", "phi": "rad", "n": "1", "T": "s"}
SYMBOLS = {
    sp.Symbol(name, real=True): (Measure(parse_unit(unit).dimension, parse_unit(unit).angle), unit)
    for name, unit in UNITS.items()
}
F, m, v, x, c, phi, n, T = (sp.Symbol(name, real=True) for name in UNITS)


@pytest.mark.parametrize(
    ("expression", "dimension"),
    [
        (m * v / T - F, MASS * LENGTH / TIME**2),
        (sp.sqrt(v * x * T), LENGTH),
        (v**2.5 / c**1.5, LENGTH / TIME),
        (sp.Abs(-v) + sp.Max(v, c, 0) + sp.Min(v, 3 * c), LENGTH / TIME),
        (v * sp.sign(x) * sp.Heaviside(x), LENGTH / TIME),
        (sp.Piecewise((v, x > 3 * v * T), (c * n, True)), LENGTH / TIME),
        (F * Saturation(v / c) * sp.exp(-x / (v * T)) * sp.tanh(n) ** n, MASS * LENGTH / TIME**2),
        (sp.log(x / (v * T)) + sp.sin(phi) + sp.pi + n**n, Dimension.none),
        (sp.Mod(x, v * T), LENGTH),
        (v * sp.atan2(x, v * T) / sp.atan(n), LENGTH / TIME),
    ],
)
def test_the_dimension_of_an_expression_that_fits(expression, dimension):
    assert measure_of_expression(expression, SYMBOLS).dimension == dimension


@pytest.mark.parametrize(
    ("expression", "part", "said"),
    [
        (F - m * v, -m * v, "F in N (N against kg m/s)"),
        (sp.sqrt((F - m * v) / m), -m * v, "N against kg m/s"),
        (x + v * T + c, c, "m against m/s"),
        (sp.exp(x), x, "exp takes a pure number"),
        (sp.sin(x), x, "sin takes a pure number"),
        (Saturation(F), F, "Saturation takes a pure number"),
        (sp.Max(x, v * T, v), v, "m against m/s"),
        (sp.Piecewise((x, v > x), (v * T, True)), x, "m/s against m"),
        (n**x, x, "an exponent is a pure number"),
        (x**n, x, "what has the power n is a pure number"),
        (x + 3, x, "- against m"),
    ],
)
def test_the_part_that_does_not_fit_is_named(expression, part, said):
    found = mismatches(expression, SYMBOLS, NONE, "the whole")

    assert found[0].part == part
    assert said in str(found[0])


def test_the_term_that_differs_from_what_is_wanted_is_the_offender():
    """Two terms, one against one: the unit of the whole decides which is wrong."""
    wanted = Measure(MASS * LENGTH / TIME)
    (one,) = mismatches(F - m * v, SYMBOLS, wanted, "the output")
    (other,) = mismatches(F / T * (x - v), SYMBOLS, Measure(MASS * LENGTH**2 / TIME**3), "the output")

    assert (one.part, one.unit) == (F, "N")
    assert (other.part, other.unit) == (-v, "m/s")


def test_a_whole_that_fits_in_itself_is_held_against_what_it_is_for():
    (one,) = mismatches(F * T, SYMBOLS, Measure(LENGTH), "the output 'y'")

    assert str(one) == "F*T is in kg m/s, the output 'y' in m (m against kg m/s)"


def test_zero_fits_everywhere():
    assert mismatches(sp.Integer(0), SYMBOLS, Measure(LENGTH), "the whole") == ()


exponents = st.lists(st.fractions(-2, 2, max_denominator=4), min_size=4, max_size=4)


@settings(max_examples=50, deadline=None)
@given(exponents, exponents)
def test_a_product_of_powers_has_the_product_of_the_powers(one, other):
    def product(powers):
        named = zip((F, m, v, x), powers, strict=True)
        return sp.Mul(*(sp.Abs(s) ** sp.Rational(p.numerator, p.denominator) for s, p in named))

    def dimension(powers):
        result = Dimension.none
        for s, p in zip((F, m, v, x), powers, strict=True):
            result = result * SYMBOLS[s][0].dimension ** p
        return result

    found = measure_of_expression(product(one) * product(other), SYMBOLS)
    assert found.dimension == dimension(one) * dimension(other)
    unlike = dimension(one) != dimension(other)
    assert bool(mismatches(product(one) + product(other), SYMBOLS, Measure(dimension(one)), "")) == unlike
