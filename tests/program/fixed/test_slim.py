"""Sums in 32 bits: right to a few units of their fraction, and never wider than a word."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st
from tests.program.fixed.test_integer import value

from similitude.program.fixed import integer as it
from similitude.program.fixed.arithmetic import Scaled, filled
from similitude.program.fixed.formats import SLIM
from similitude.program.fixed.slim import Term, odd_part, plain, product, settled, total

WORD = st.integers(-SLIM, SLIM)
NUMBER = st.fractions(min_value=-4, max_value=4, max_denominator=10**6)


def variable(name, fraction=26):
    return Scaled(it.name(name, -SLIM, SLIM), fraction)


@given(WORD, WORD, NUMBER, NUMBER, NUMBER)
def test_a_sum_of_products_is_right_to_a_unit_each(a, b, c, d, rest):
    terms = [Term(variable(n), k) for n, k in (("a", c), ("b", d)) if k]
    if not terms:
        return
    found = total(terms, rest, None, lambda term, fraction: term)
    exact = float(rest) + (a * float(c) + b * float(d)) / 2.0**26

    assert found is not None and found.node.is_narrow
    # a unit of each product, half a unit of each shift and of the number, 31 bits of each literal
    assert (
        abs(value(found.node, a=a, b=b) / 2.0**found.fraction - exact)
        <= 4.5 * 2.0**-found.fraction + 2.0**-26
    )


@given(WORD, WORD)
def test_a_product_keeps_its_upper_half(a, b):
    found = product([variable("a"), variable("b")])

    assert found.node.is_narrow
    assert 0 <= a * b / 2.0**52 - value(found.node, a=a, b=b) / 2.0**found.fraction < 2.0**-found.fraction
    assert filled(variable("a")).node.bits == 31 - 0


@given(st.integers(0, 30), WORD)
def test_a_power_of_two_only_moves_the_point(k, a):
    term = Term(variable("a"), Fraction(1, 2**k))

    assert plain(term.number) == -k
    assert value(settled(term, 26 + k), a=a) == a


@given(st.fractions(min_value=Fraction(1, 1000), max_value=1000), st.integers(-9, 9))
def test_numbers_that_differ_by_a_power_of_two_have_the_same_odd_part(c, k):
    assert odd_part(c) == odd_part(c * Fraction(2) ** k)
    assert 1 <= odd_part(c) < 2


def test_what_is_wider_than_a_word_is_left_to_64_bits():
    wide = Scaled(it.name("w", -(2**50), 2**50, wide=True), 40)

    assert product([wide, variable("a")]) is None
