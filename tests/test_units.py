"""Quantities and uncertain values; the door to units stays cheap."""

import subprocess
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.errors import SimilitudeError, UnitError
from similitude.units import LENGTH, MASS, TIME, Dimension, parse_quantity, parse_uncertain

positive = st.floats(min_value=1e-6, max_value=1e9)


def test_importing_units_is_cheap():
    heavy = "numpy pint sympy scipy pyarrow"
    code = (
        "import sys, similitude.units as u; u.parse_uncertain('2010 ± 50 kg');"
        f"sys.exit(', '.join(set('{heavy}'.split()) & set(sys.modules)) or None)"
    )

    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)

    assert done.returncode == 0, done.stderr


@given(positive)
def test_a_value_reads_the_same_in_any_unit(length):
    metres = parse_quantity(f"{length!r} m")[0]

    assert metres == length
    for unit, factor in (("mm", 1e3), ("km", 1e-3), ("in", 1 / 0.0254)):
        # two roundings each way
        assert parse_quantity(f"{length * factor!r} {unit}", expect=LENGTH)[0] == pytest.approx(
            metres, rel=1e-15
        )


@given(positive, positive)
def test_the_ways_to_write_an_uncertain_value_agree(value, sd):
    ways = [
        f"{value!r} ± {sd!r} kg",
        f"{value!r} +- {sd!r} kg",
        f"{value!r} +/- {sd!r} kg",
        f"{value!r} kg ± {sd!r} kg",
        f"({value!r} ± {sd!r}) kg",
        {"value": f"{value!r} kg", "sd": f"{sd!r} kg"},
    ]

    read = [parse_uncertain(way, expect=MASS) for way in ways]

    assert {(one.value, one.sd) for one in read} == {(value, sd)}


def test_a_deviation_may_have_its_own_unit_and_may_be_absent():
    both = parse_uncertain({"value": "2 t", "sd": "50 kg"})

    assert (both.value, both.sd, both.unit.text) == (2000.0, 50.0, "t")
    assert parse_uncertain("10 ms", expect=TIME).sd is None


def test_a_pure_number_needs_no_unit_only_where_one_is_expected():
    assert parse_quantity("15.3", expect=Dimension.none)[0] == 15.3
    with pytest.raises(UnitError, match=r"'2\.69' has no unit of dimension 'm'"):
        parse_quantity("2.69", expect=LENGTH)


@pytest.mark.parametrize(
    ("text", "word", "paste"),
    [
        ("2,69 m", "does not begin with a number", "2.69 m"),
        ("2.69", "has no unit", "2.69 m"),
        ("kg", "does not begin with a number", ""),
        ("1e999 kg", "too large", ""),
        ("2010 ± -5 kg", "not positive", "2010 kg"),
        ("2010 ± 0 kg", "not positive", "2010 kg"),
        ("2010 kg ± 1 m", "dimension", ""),
        ("1 ± 2 ± 3 kg", "no part of a unit", ""),
        ({"value": "1 kg", "sigma": "2 kg"}, "'sigma' is not known", ""),
        ({"value": 3}, "3 has no unit", ""),
        ({"sd": "1 kg"}, "'value' is missing", ""),
    ],
)
def test_what_is_no_value_is_refused_in_words(text, word, paste):
    with pytest.raises(UnitError, match=word) as caught:
        parse_uncertain(text)

    assert not paste or caught.value.paste == paste


@given(st.text(max_size=40))
def test_any_text_is_a_value_or_a_unit_error(text):
    try:
        parse_uncertain(text)
    except SimilitudeError as error:
        assert all([error.what, error.usually, error.paste, error.read])
