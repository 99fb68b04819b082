"""A base measures everything, takes parameters first and whole exponents where there are any."""

from fractions import Fraction

import pytest

from similitude.symmetry.base import choose_base, exponents


def test_parameters_come_before_states():
    weights = [[1, 1, 0], [0, 1, 1]]

    assert choose_base(weights, preference=[1, 0, 0]) == [1, 2]
    assert choose_base(weights, preference=[0, 1, 0]) == [0, 2]


def test_whole_exponents_are_found_by_a_swap():
    # columns: the first two make a determinant of two, the third mends it
    weights = [[1, 1, 0, 3], [1, -1, 1, 0]]
    base = choose_base(weights, preference=[0, 0, 0, 0])

    assert all(x.denominator == 1 for row in exponents(weights, base) for x in row)


def test_where_there_is_none_fractions_are_kept():
    weights = [[1, 0, -1, -1], [0, 1, 1, -1]]  # x' = a - b x^2
    base = choose_base(weights, preference=[4, 1, 0, 0])

    assert base == [2, 3]
    assert exponents(weights, base)[0][:2] == [Fraction(-1, 2), Fraction(1, 2)]


@pytest.mark.parametrize("base", [[0, 1], [1, 3], [2, 3]])
def test_a_base_measures_itself_by_itself(base):
    weights = [[1, 0, 2, 1], [0, 1, 1, 3]]
    powers = exponents(weights, base)

    assert [[row[b] for b in base] for row in powers] == [[1, 0], [0, 1]]
    for row in weights:  # weights = weights of the base times X
        for j in range(4):
            assert sum(row[b] * powers[i][j] for i, b in enumerate(base)) == row[j]
