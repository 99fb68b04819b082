"""Constraints are found when they are exact, and only then."""

import numpy as np
import pytest

from similitude.populations.exact_constraints import find_constraints


def columns(seed, n=60):
    rng = np.random.default_rng(seed)
    return rng.normal(0.44, 0.03, n), rng.normal(2.0, 0.3, n), rng.normal(0.25, 0.03, n)


def test_two_shares_add_to_one():
    a, c, d = columns(0)
    found = find_constraints(np.column_stack([a, 1 - a, c, d]), ["pi1", "pi2", "pi3", "pi4"])

    assert found == [{"pi1": 1.0, "pi2": 1.0, "constant": 1.0, "rows": 60.0}]


def test_three_columns_may_be_tied_and_digits_of_a_table_do_not_matter():
    a, c, d = columns(1)
    b = np.round(3 - a - 2 * c, 4)
    (found,) = find_constraints(np.column_stack([a, b, c, d]), ["a", "b", "c", "d"])

    assert {n: found[n] for n in "abc"} == pytest.approx({"a": 1.0, "b": 1.0, "c": 2.0}, rel=1e-3)
    assert found["constant"] == pytest.approx(3.0, rel=1e-3)


@pytest.mark.parametrize("seed", range(20))
def test_a_scatter_of_three_per_cent_or_chance_is_no_constraint(seed):
    a, c, d = columns(seed, n=9)
    near = 1.1 * c * np.exp(0.03 * np.random.default_rng(seed).normal(size=9))

    assert find_constraints(np.column_stack([a, c, near, d]), list("acnd")) == []


def test_missing_values_cost_rows_and_nothing_else():
    a, c, _ = columns(2)
    table = np.column_stack([a, 1 - a, c])
    table[::2, 1] = np.nan
    (found,) = find_constraints(table, ["x", "y", "z"])
    assert found["rows"] == 30
