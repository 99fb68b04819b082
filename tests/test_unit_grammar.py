"""The grammar of units knows no unit."""

from fractions import Fraction

import pytest

from similitude.unit_grammar import GrammarError, parse_terms


@pytest.mark.parametrize(
    ("text", "terms"),
    [
        ("N m/rad", [("N", 1), ("m", 1), ("rad", -1)]),
        ("a/(b c)^2", [("a", 1), ("b", -2), ("c", -2)]),
        ("x^-1.5", [("x", Fraction(-3, 2))]),
        ("1/x2", [("x", -2)]),
        ("long_name", [("long_name", 1)]),
        ("1", []),
    ],
)
def test_text_becomes_names_with_exact_powers(text, terms):
    assert parse_terms(text) == terms


@pytest.mark.parametrize(
    "text", ["a/b c", "a/b*c", "a b/c d", "a^b", "1.5", "10 m", "1e3 m", "1m", "a^", "()"]
)
def test_what_people_and_programs_read_differently_is_refused(text):
    with pytest.raises(GrammarError):
        parse_terms(text)
