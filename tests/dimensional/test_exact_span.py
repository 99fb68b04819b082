"""Exact elimination against SymPy's own, and against what it means."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.dimensional.exact_span import empty_span, leading, smallest_integers, span_of

small = st.fractions(-4, 4, max_denominator=6)


def columns(most: int = 6, size: int = 4):
    return st.lists(st.tuples(*[small] * size), max_size=most)


def exact(columns, size=4):
    numbers = [sp.Rational(x.numerator, x.denominator) for c in columns for x in c]
    return sp.Matrix(len(columns), size, numbers).T


@settings(max_examples=30, deadline=None)
@given(columns())
def test_the_leading_columns_are_the_pivots_of_the_row_echelon_form(found):
    assert leading(found, 4)[0] == exact(found).rref()[1]


@settings(max_examples=30, deadline=None)
@given(columns(), st.tuples(*[small] * 4))
def test_exponents_make_up_the_column_exactly_or_it_lies_outside(found, wanted):
    places, span = leading(found, 4)
    base = [found[place] for place in places]
    x = span.exponents(wanted)

    inside = exact([*base, wanted]).rank() == len(base)
    assert span.holds(wanted) is inside is (x is not None)
    if inside:
        made = [sum((c[k] * e for c, e in zip(base, x, strict=True)), Fraction(0)) for k in range(4)]
        assert made == list(wanted)


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(*[st.integers(-5, 5)] * 4), min_size=4, max_size=4))
def test_the_operations_of_a_square_base_are_its_adjugate(square):
    span = span_of(square, 4)
    matrix = exact([tuple(map(Fraction, c)) for c in square])
    determinant = matrix.det()

    if determinant == 0:
        assert span is None
    else:
        ratio = sp.Rational(span.pivot) / determinant  # rows may have changed places
        assert ratio in (1, -1)
        assert sp.Matrix(span.operations) == ratio * matrix.adjugate()


def test_a_dependent_column_does_not_extend_a_span():
    span = span_of([(1, 0), (0, 1)], 2)

    assert span.extended((3, 5)) is None and span.rank == 2
    assert span_of([(1, 2), (2, 4)], 2) is None


def test_the_empty_span_holds_zero_alone():
    assert empty_span(3).exponents((0, 0, 0)) == ()
    assert empty_span(3).exponents((0, 1, 0)) is None
    assert leading([], 3)[0] == () and leading([(0, 0, 0)], 3)[0] == ()


@pytest.mark.parametrize(
    ("numbers", "expected"),
    [
        # the least common multiple, not the largest denominator: 1/2, 1/3 -> 3, 2 and not 3/2
        ((Fraction(1, 2), Fraction(1, 3)), (3, 2)),
        ((Fraction(-2), Fraction(4)), (1, -2)),
        ((Fraction(0), Fraction(-6), Fraction(9)), (0, 2, -3)),
        ((Fraction(1, 6), Fraction(1, 4), Fraction(0)), (2, 3, 0)),
        ((Fraction(0), Fraction(0)), (0, 0)),
        ((), ()),
    ],
)
def test_smallest_integers(numbers, expected):
    assert smallest_integers(numbers) == expected
