"""Hermite form, multiplier and kernels of integer matrices, held against their definitions."""

from fractions import Fraction

import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.symmetry.lattice import canonical, hermite, integers, kernel, saturated, solved

matrices = st.integers(1, 5).flatmap(
    lambda n: st.tuples(
        st.just(n), st.lists(st.lists(st.integers(-6, 6), min_size=n, max_size=n), min_size=0, max_size=4)
    )
)
few = settings(max_examples=60, deadline=None)


@few
@given(matrices)
def test_the_multiplier_is_unimodular_and_makes_the_form(case):
    width, rows = case
    found = hermite(rows, width)
    v = sp.Matrix(found.multiplier)

    assert abs(v.det()) == 1
    product = sp.Matrix(len(rows), width, [x for row in rows for x in row]) * v
    assert product[:, : found.rank].tolist() == found.form
    assert product[:, found.rank :].is_zero_matrix
    assert found.rank == sp.Matrix(len(rows), width, [x for row in rows for x in row]).rank()


@few
@given(matrices)
def test_pivots_are_positive_and_what_stands_left_of_them_is_smaller(case):
    found = hermite(case[1], case[0])
    top = 0
    for j in range(found.rank):
        row = next(i for i in range(top, len(found.form)) if found.form[i][j])
        pivot = found.form[row][j]
        assert pivot > 0
        assert all(0 <= x < pivot for x in found.form[row][:j])
        assert not any(found.form[row][j + 1 :])
        top = row + 1


@few
@given(matrices)
def test_a_kernel_is_all_of_the_integer_kernel(case):
    width, rows = case
    basis = kernel(rows, width)

    assert all(sum(x * y for x, y in zip(row, v, strict=True)) == 0 for row in rows for v in basis)
    assert len(basis) == width - sp.Matrix(len(rows), width, [x for row in rows for x in row]).rank()
    assert saturated(basis, width) == canonical(basis, width) == basis  # no multiple of a shorter vector


@few
@given(matrices, st.randoms(use_true_random=False))
def test_a_kernel_does_not_depend_on_the_order_or_combination_of_the_rows(case, random):
    width, rows = case
    mixed = [list(row) for row in rows]
    random.shuffle(mixed)
    if len(mixed) > 1:
        mixed[0] = [x + 3 * y for x, y in zip(mixed[0], mixed[1], strict=True)]

    assert kernel(mixed, width) == kernel(rows, width)


def test_the_multiplier_of_a_known_matrix():
    found = hermite([[2, 4, 4], [-6, 6, 12]], 3)

    assert found.form == [[2, 0], [0, 6]]
    assert kernel([[2, 4, 4], [-6, 6, 12]], 3) == [[2, -4, 3]]
    assert saturated([[2, 4]], 2) == [[1, 2]]


def test_integers_are_the_shortest_and_start_positive():
    assert integers([Fraction(-1, 2), Fraction(1, 3), 0]) == [3, -2, 0]
    assert integers([0, 0]) == [0, 0]


def test_a_singular_system_has_no_solution():
    assert solved([[1, 2], [2, 4]], [[1], [2]]) is None
    assert solved([[1, 2], [0, 4]], [[1], [2]]) == [[Fraction(0)], [Fraction(1, 2)]]


def test_large_entries_stay_exact():
    big = 10**40 + 1
    found = hermite([[big, big * 7, 3]], 3)

    assert found.form == [[1]] if big % 3 else [[3]]
    product = [sum([big, big * 7, 3][i] * found.multiplier[i][j] for i in range(3)) for j in range(3)]
    assert product[1:] == [0, 0]
