"""Measures multiply exactly and print as people write units."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.homogeneity.measure import NONE, Measure, measure_of
from similitude.units import Dimension, parse_unit

powers = st.fractions(-3, 3, max_denominator=6)
measures = st.builds(
    lambda m, x, t, a: Measure(Dimension(mass=m, length=x, time=t), a), powers, powers, powers, powers
)


@given(measures, measures, powers)
def test_measures_are_a_group_with_rational_powers(one, other, power):
    assert one * other / other == one
    assert (one * other) ** power == one**power * other**power
    assert (one / one).is_none


@given(measures)
def test_what_is_printed_can_be_read_back(measure):
    unit = parse_unit(str(measure))

    assert measure_of(unit, angle=True) == measure


@pytest.mark.parametrize(
    ("unit", "printed"),
    [("N", "kg m/s^2"), ("N/rad", "kg m/s^2"), ("1", "-"), ("1/s", "1/s"), ("Pa", "kg/(m s^2)")],
)
def test_a_unit_prints_with_one_slash(unit, printed):
    assert str(measure_of(parse_unit(unit), angle=False)) == printed


def test_an_angle_counts_where_it_is_asked_to():
    stiffness = parse_unit("N/rad")

    assert measure_of(stiffness, angle=True).exponents["angle"] == Fraction(-1)
    assert measure_of(parse_unit("rad"), angle=False) == NONE
