"""What the lowering does with choices, extremes, ratios and comparisons."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from tests.program.fixed.test_integer import value

from similitude.errors import ProgramError
from similitude.program.fixed import integer as it
from similitude.program.fixed.expressions import Expressions
from similitude.program.fixed.formats import Format

a, b = sp.symbols("a b", real=True)
WORD = st.integers(-(2**31), 2**31 - 1)
FORMATS = {"a": Format(28, -(2**31), 2**31 - 1), "b": Format(20, -(2**31), 2**31 - 1)}


def lowered(expression):
    return Expressions({}, FORMATS, {}, {n: (f.lo, f.hi) for n, f in FORMATS.items()}).value(expression)


@given(WORD, WORD)
def test_the_larger_of_two_values_with_different_fractions(x, y):
    expressions = Expressions({}, FORMATS, {}, {n: (f.lo, f.hi) for n, f in FORMATS.items()})
    found = expressions.value(sp.Max(a, b))
    names = {"a": x, "b": y}
    for name, node in expressions.made:
        names[name] = value(node, **names)

    assert value(found.node, **names) / 2.0**found.fraction == max(x / 2.0**28, y / 2.0**20)


@given(WORD, st.fractions(min_value=-9, max_value=9, max_denominator=1000))
def test_a_comparison_with_a_number_is_exact(x, number):
    e = Expressions({"c": number}, FORMATS, {}, {"a": (-(2**31), 2**31 - 1)})
    c = sp.Symbol("c", real=True)
    for condition, wanted in ((a < c, Fraction(x, 2**28) < number), (a <= c, Fraction(x, 2**28) <= number)):
        made = e.condition(condition)
        if made.kind in ("true", "false"):
            assert (made == it.TRUE) == wanted
        else:
            sides = [value(side, a=x) for side in made.args]
            assert (sides[0] < sides[1] if made.kind == "lt" else sides[0] <= sides[1]) == wanted


def test_numbers_alone_are_exact():
    third = Expressions({"a": Fraction(1, 3)}, {}, {}, {})

    assert third.exact(3 * a**2 + sp.Rational(1, 3)) == Fraction(2, 3)
    assert third.exact(sp.Max(a, 2) / a) == 6


def test_a_root_is_refused():
    with pytest.raises(ProgramError, match="not a whole one"):
        lowered(sp.sqrt(a))
