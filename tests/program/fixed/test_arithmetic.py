"""Scaled arithmetic keeps values, whatever the fractions."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st
from tests.program.fixed.test_integer import value

from similitude.program.fixed import integer as it
from similitude.program.fixed.arithmetic import Scaled, by_number, fit, narrowed, ratio, thin, times, total
from similitude.program.fixed.formats import Format

WORD = st.integers(-(2**31), 2**31 - 1)
FRACTION = st.integers(-8, 34)


def variable(name, fraction, bits=31):
    return Scaled(it.name(name, -(2**bits), 2**bits - 1, wide=bits > 31), fraction)


def real(scaled, **names):
    return value(scaled.node, **names) / 2.0**scaled.fraction


@given(WORD, FRACTION, WORD, FRACTION)
def test_a_sum_is_right_to_its_coarser_end(a, f, b, g):
    found = total([variable("a", f), variable("b", g), Fraction(1, 3)])
    exact = a * 2.0**-f + b * 2.0**-g + 1 / 3

    assert abs(real(found, a=a, b=b) - exact) <= 2.0**-found.fraction * 2 + 1e-15 * abs(exact)


@given(WORD, FRACTION, WORD, FRACTION)
def test_a_product_of_two_words_is_exact(a, f, b, g):
    assert real(times(variable("a", f), variable("b", g)), a=a, b=b) == (a * b) * 2.0 ** -(f + g)


@given(st.integers(-(2**60), 2**60), WORD)
def test_a_product_with_a_wide_value_loses_three_units_at_most(a, b):
    found = times(variable("a", 40, 60), variable("b", 20))

    exact = a * b / 2.0 ** (60 - found.fraction)
    assert abs(value(found.node, a=a, b=b) - exact) <= 3 + 2**-50 * abs(exact)


@given(WORD, st.fractions(min_value=-100, max_value=100, max_denominator=10**6))
def test_a_number_is_right_to_thirty_bits(a, c):
    found = by_number(variable("a", 20), c)
    if isinstance(found, Fraction):
        assert c == 0
        return
    exact = Fraction(a, 2**20) * c
    assert abs(Fraction(value(found.node, a=a)) / Fraction(2) ** found.fraction - exact) <= abs(exact) / 2**29


@given(st.integers(-(2**60), 2**60))
def test_forgetting_takes_a_shifted_part_away(a):
    kept = by_number(variable("a", 40, 60), 1 - Fraction(1, 2**14))

    assert abs(value(kept.node, a=a) - a * (1 - 2.0**-14)) <= 1 + abs(a) * 2.0**-52


@given(st.integers(-(2**50), 2**50), st.integers(-5, 40))
def test_what_does_not_fit_a_format_saturates(a, f):
    target = Format(20, -(2**25), 2**25)
    found = value(fit(variable("a", f, 50), target), a=a)
    exact = min(max(a * 2.0 ** (20 - f), target.lo), target.hi)

    assert abs(found - exact) <= 0.5 + abs(exact) * 2**-50


@given(st.integers(-(2**50), 2**50))
def test_thinning_keeps_31_bits(a):
    thinner = thin(variable("a", 30, 50))

    assert thinner.node.is_narrow
    assert abs(real(thinner, a=a) - a / 2**30) <= 2.0 ** -(thinner.fraction + 1)


@given(WORD, st.integers(1, 2**31 - 1))
def test_a_ratio_is_right_in_its_target(a, b):
    under = Scaled(it.name("b", 1, 2**31 - 1), 30)
    found = ratio(variable("a", 30), under, Format(10, -(2**31) + 1, 2**31 - 1))

    assert (
        abs(real(found, a=a, b=b) - min(max(a / b, -(2.0**21)), 2.0**21)) <= 2.0**-10 + abs(a / b) * 2.0**-27
    )


def test_a_condition_narrows_what_it_compares():
    x = it.name("x", -10, 10)
    env = {"x": (-10, 10)}
    below = it.less(x, it.const(3), equal=False)

    assert narrowed(env, below, True) == {"x": (-10, 2)}
    assert narrowed(env, below, False) == {"x": (3, 10)}
