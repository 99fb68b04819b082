"""Products of powers are read as people write them, and nothing else is."""

from fractions import Fraction

import pytest

from similitude.errors import UsageError
from similitude.populations.monomial import monomial_text, read_monomial

NAMES = ("a", "b", "m", "L", "Iz", "z1", "z_dot2")


@pytest.mark.parametrize(
    ("text", "powers"),
    [
        ("a*b", {"a": 1, "b": 1}),
        ("a b", {"a": 1, "b": 1}),
        ("Iz/(m L^2)", {"Iz": 1, "m": -1, "L": -2}),
        ("a/L*b", {"a": 1, "L": -1, "b": 1}),
        ("a/b/m", {"a": 1, "b": -1, "m": -1}),
        ("z1^2/z_dot2", {"z1": 2, "z_dot2": -1}),
        ("m^(1/2)", {"m": Fraction(1, 2)}),
        ("a*a/a", {"a": 1}),
    ],
)
def test_a_product_is_read(text, powers):
    assert read_monomial(text, NAMES) == powers


@pytest.mark.parametrize("powers", [{"Iz": 1, "m": -1, "a": -1}, {"a": Fraction(1, 2)}, {"m": -1}, {"a": 3}])
def test_what_is_written_is_read_again(powers):
    exact = {name: Fraction(p) for name, p in powers.items()}
    if any(p > 0 for p in exact.values()):
        assert read_monomial(monomial_text(exact), NAMES) == exact
    assert monomial_text({"m": Fraction(-1)}) == "1/m"


@pytest.mark.parametrize("text", ["", "a+b", "q", "a**", "(a", "a/(b", "^2", "a/", "2 a"])
def test_anything_else_is_refused_with_the_parameters(text):
    with pytest.raises(UsageError) as error:
        read_monomial(text, NAMES)
    assert "Iz" in error.value.what and error.value.paste
