"""One unit: names, factors, products, and what is refused."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.errors import SimilitudeError, UnitError
from similitude.units import (
    ACCELERATION,
    FORCE,
    FREQUENCY,
    INERTIA,
    LENGTH,
    MASS,
    SPEED,
    TIME,
    Dimension,
    parse_unit,
)

# Factors from the definitions of the units, not from the table under test.
LOG_UNITS = {
    "s": (1, TIME), "ms": (1e-3, TIME), "us": (1e-6, TIME), "µs": (1e-6, TIME),
    "ns": (1e-9, TIME), "min": (60, TIME), "h": (3600, TIME),
    "rad": (1, Dimension.none), "deg": (math.pi / 180, Dimension.none),
    "mrad": (1e-3, Dimension.none), "°": (math.pi / 180, Dimension.none),
    "rad/s": (1, FREQUENCY), "deg/s": (math.pi / 180, FREQUENCY),
    "mrad/s": (1e-3, FREQUENCY), "rpm": (math.pi / 30, FREQUENCY),
    "m": (1, LENGTH), "mm": (1e-3, LENGTH), "cm": (1e-2, LENGTH), "in": (0.0254, LENGTH),
    "ft": (0.3048, LENGTH), "m/s": (1, SPEED), "km/h": (1 / 3.6, SPEED),
    "kph": (1 / 3.6, SPEED), "mph": (1609.344 / 3600, SPEED), "ft/s": (0.3048, SPEED),
    "m/s^2": (1, ACCELERATION), "m/s2": (1, ACCELERATION), "m/s²": (1, ACCELERATION),
    "kg": (1, MASS), "t": (1e3, MASS), "lb": (0.45359237, MASS), "N": (1, FORCE),
    "kN": (1e3, FORCE), "N/rad": (1, FORCE), "N/deg": (180 / math.pi, FORCE),
    "kg m^2": (1, INERTIA), "1": (1, Dimension.none), "-": (1, Dimension.none),
    "%": (1e-2, Dimension.none), "Hz": (1, FREQUENCY),
}  # fmt: skip


@pytest.mark.parametrize("text", LOG_UNITS)
def test_units_of_logs_have_their_defined_size(text):
    factor, dimension = LOG_UNITS[text]

    unit = parse_unit(text)

    # a handful of correctly rounded operations
    assert unit.factor == pytest.approx(factor, rel=1e-15)
    assert unit.dimension == dimension


@pytest.mark.parametrize(
    "texts",
    [
        ("kg m^2", "kg*m**2", "kg·m²", "kg.m2", "m kg m", "N m s^2"),
        ("N m/rad", "N m rad^-1", "J/rad", "(N m)/rad"),
        ("m/s^2", "m s^-2", "m/s/s", "m/(s s)", "m/s2", "m s⁻²"),
        ("m^0.5", "m^(1/2)", "m^1/m^(1/2)"),
        ("J/(kg K)", "J/kg/K", "m²/(s² K)"),
    ],
)
def test_one_unit_may_be_written_in_many_ways(texts):
    units = [parse_unit(text) for text in texts]

    assert len({unit.dimension for unit in units}) == 1
    assert {unit.factor for unit in units} == {1.0}


def test_angle_is_remembered_but_is_no_dimension():
    assert parse_unit("deg").is_angle
    assert not parse_unit("deg/s").is_angle
    assert parse_unit("N/rad").angle == -1
    assert parse_unit("N/rad").dimension == FORCE
    assert not parse_unit("1").is_angle


def test_g_is_the_gram_unless_an_acceleration_is_expected():
    assert parse_unit("g").dimension == MASS
    assert parse_unit("g").factor == 1e-3
    assert parse_unit("g", expect=ACCELERATION).factor == 9.80665
    assert parse_unit("mg", expect=ACCELERATION).factor == pytest.approx(9.80665e-3, rel=1e-15)
    assert parse_unit("g m/s^2", expect=FORCE).factor == 1e-3


def test_pint_is_asked_for_a_single_name_that_is_not_in_the_table():
    pint = pytest.importorskip("pint")

    assert parse_unit("furlong/fortnight").factor == pytest.approx(
        pint.Quantity("furlong/fortnight").to_base_units().magnitude, rel=1e-12
    )


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("", "empty"), ("furlonk", "not known"), ("Km/h", "did you mean 'km/h'"),
        ("J/kg K", "product follows"), ("°C", "zero elsewhere"), ("m^1000", "beyond"),
        ("m^(1/0)", "zero"), ("m/", "ends"), ("m)", "'\\)'"), ("(m", "not closed"),
        ("2 m", "no part of a unit"), ("m^30", "beyond"), ("x" * 500, "500 characters"),
        ("Tm^-24 Tm^-24", "which no number can hold"), ("m\x00", "x00"), ("*m", "begin"),
    ],
)  # fmt: skip
def test_what_is_no_unit_is_refused_in_words(text, word):
    if text == "Km/h":
        word = "'Km' in 'Km/h' is not known; did you mean 'km'"
    with pytest.raises(UnitError, match=word):
        parse_unit(text)


def test_a_unit_of_another_dimension_is_refused_with_both_dimensions():
    with pytest.raises(UnitError, match="'deg/s' has the dimension 's\\^-1', but 'm s\\^-1'"):
        parse_unit("deg/s", expect=SPEED)


names = st.sampled_from(["m", "s", "kg", "rad", "N", "ms", "km", "deg", "Hz"])
exponents = st.fractions(min_value=-4, max_value=4, max_denominator=4).filter(bool)


@given(st.lists(st.tuples(names, exponents), min_size=1, max_size=5))
def test_a_product_of_units_is_the_product_of_factors_and_dimensions(terms):
    text = " ".join(f"{name}^({power})" for name, power in terms)

    unit = parse_unit(text)

    logarithm = sum(float(power) * math.log(parse_unit(name).factor) for name, power in terms)
    dimension, angle = Dimension.none, Fraction(0)
    for name, power in terms:
        dimension *= parse_unit(name).dimension ** power
        angle += parse_unit(name).angle * power
    assert unit.dimension == dimension
    assert unit.angle == angle
    # five powers, each within one rounding of the exponent (|ln factor| < 28)
    assert math.log(unit.factor) == pytest.approx(logarithm, abs=5 * 28 * 4 * 2.3e-16)


@given(st.text(max_size=30))
def test_any_text_is_a_unit_or_a_unit_error(text):
    try:
        unit = parse_unit(text)
    except SimilitudeError as error:
        assert all([error.what, error.usually, error.paste, error.read])
    else:
        assert 0 < unit.factor < math.inf
