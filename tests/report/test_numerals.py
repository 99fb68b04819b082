import math
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.report.numerals import (
    for_people,
    narrower,
    plain,
    pretty_name,
    pretty_unit,
    stated,
    uncertain,
)


def _number(text):
    return float(text.replace("−", "-").replace("\u202f", ""))


@given(st.floats(-1e8, 1e8), st.floats(1e-6, 1e8))
def test_rounding_moves_a_value_by_less_than_a_tenth_of_its_deviation(value, std):
    shown_value, shown_std = uncertain(value, std)
    # Two digits of the deviation: half a unit in its second digit is at most 5 % of it.
    assert abs(_number(shown_value) - value) <= 0.0501 * std + 1e-6 * abs(value)
    assert _number(shown_std) == pytest.approx(std, rel=0.051)


@pytest.mark.parametrize(
    ("value", "std", "shown"),
    [
        (145.678, 12.34, ("146", "12")),
        (54210.0, 2712.0, ("54\u202f200", "2700")),
        (-0.00213, 0.00018, ("−0.00213", "0.00018")),
        (99.96, 9.96, ("100", "10")),
        (3.2, 0.0, ("3.20", "0")),
        (0.0, 0.5, ("0.00", "0.50")),
        (math.nan, 1.0, ("–", "–")),
        (1.0, math.inf, ("1.00", "–")),
    ],
)
def test_two_digits_of_the_deviation_decide(value, std, shown):
    assert uncertain(value, std) == shown


def test_a_deviation_far_above_the_value_leaves_the_value_readable():
    assert uncertain(1.2, 5000.0)[0] == "1.2"


@pytest.mark.parametrize(
    ("unit", "shown"),
    [
        ("m^2/s^2", "m²/s²"),
        ("-", ""),
        ("1/s", "1/s"),
        ("deg/(m/s^2)", "deg/(m/s²)"),
        ("s^-1", "s⁻¹"),
    ],
)
def test_powers_are_raised_and_brackets_kept(unit, shown):
    assert pretty_unit(unit) == shown


@pytest.mark.parametrize(
    ("unit", "shown", "factor"),
    [
        ("rad", "deg", 180 / math.pi),
        ("rad/s", "deg/s", 180 / math.pi),
        ("rad/(m/s^2)", "deg/(m/s^2)", 180 / math.pi),
        ("N/rad", "N/rad", 1.0),
        ("m/s", "m/s", 1.0),
    ],
)
def test_only_a_unit_that_begins_with_rad_becomes_degrees(unit, shown, factor):
    assert for_people(1.0, unit) == (pytest.approx(factor), shown)


def test_names_and_given_numbers():
    assert pretty_name("pi3") == "π3"
    assert pretty_name("eta") == "η"
    assert pretty_name("steer_offset") == "steer offset"
    assert [stated(x) for x in (2.69, 2010.0, 100.0, 0.1)] == ["2.69", "2010", "100", "0.1"]
    assert plain(0.0) == "0"
    assert plain(1.5e12) == "1.50e+12"


@pytest.mark.parametrize(
    ("value", "std", "share"),
    [(10.0, 1.0, 0.8), (20.0, 2.0, 0.8), (10.0, 5.0, 0.0), (10.0, 9.0, 0.0), (10.0, 0.0, 1.0)],
)
def test_narrower_counts_the_spread_against_the_value(value, std, share):
    group = SimpleNamespace(value=value, std=std, prior_value=100.0, prior_std=50.0)

    assert narrower(group) == pytest.approx(share)
