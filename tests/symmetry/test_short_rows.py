"""Shorter rows span the same beside the given ones."""

import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.symmetry.short_rows import shortened

rows = st.lists(st.lists(st.integers(-3, 3), min_size=5, max_size=5), min_size=1, max_size=3)


@settings(max_examples=50, deadline=None)
@given(rows, rows)
def test_the_span_beside_the_given_rows_stays(short, units):
    if sp.Matrix([*short, *units]).rank() < len(short) + len(units):
        return
    found = shortened(short, units)

    assert len(found) == len(short)
    assert sp.Matrix([*found, *units]).rank() == len(short) + len(units)
    assert sp.Matrix([*found, *units, *short]).rank() == len(short) + len(units)
    for new, old in zip(found, short, strict=True):
        assert sum(map(bool, new)) <= sum(map(bool, old))


def test_what_enters_as_a_product_is_said_to():
    # time, speed, force, mu, g: units of time and of length; mu g is one acceleration
    assert shortened([[1, -1, -2, -2, 0]], [[1, -1, -2, 0, -2]]) == [[0, 0, 0, 1, -1]]


def test_nothing_to_shorten():
    assert shortened([], [[1, 2]]) == []
    assert shortened([[1, 0]], []) == [[1, 0]]
