"""Dimensions are an exact vector space over the rationals."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.dimension import ACCELERATION, FORCE, LENGTH, MASS, SPEED, TIME, Dimension

powers = st.fractions(min_value=-6, max_value=6, max_denominator=6)
dimensions = st.builds(Dimension, mass=powers, length=powers, time=powers, current=powers)


@given(dimensions, dimensions, dimensions)
def test_dimensions_form_a_commutative_group(x, y, z):
    assert x * y == y * x
    assert (x * y) * z == x * (y * z)
    assert x * Dimension.none == x
    assert x / x == Dimension.none
    assert hash((x * y) / y) == hash(x)


@given(dimensions, powers, powers)
def test_powers_obey_the_laws_of_exponents(x, p, q):
    assert x**p * x**q == x ** (p + q)
    assert (x**p) ** q == x ** (p * q)


def test_a_third_root_cubed_is_exact():
    assert (LENGTH ** Fraction(1, 3)) ** 3 == LENGTH


def test_exponents_leave_out_zeros_and_text_is_si():
    assert FORCE.exponents == {"mass": 1, "length": 1, "time": -2}
    assert str(FORCE) == "kg m s^-2"
    assert str(LENGTH ** Fraction(1, 2)) == "m^(1/2)"
    assert str(Dimension.none) == "-"
    assert SPEED / TIME == ACCELERATION
    assert MASS * ACCELERATION == FORCE


@pytest.mark.parametrize("power", [0.5, "1", None, True])
def test_an_inexact_exponent_is_refused(power):
    with pytest.raises(TypeError):
        Dimension(mass=power)
    with pytest.raises(TypeError):
        LENGTH**power
