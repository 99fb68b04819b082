"""A check says which dimensions a base spans and what would complete it, and both are true."""

from itertools import combinations, islice

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.dimensional.base_check import check_base, independent_sets, lonely, product_text
from similitude.dimensional.exact_span import empty_span, span_of
from similitude.dimensional.matrix import dimension_matrix

from .classical import CASES
from .test_pi_groups import some_variables

PIPE = dimension_matrix(CASES["pipe flow"].variables, angle=False)


@pytest.mark.parametrize("name", CASES)
def test_every_base_of_a_textbook_is_valid(name):
    matrix = dimension_matrix(CASES[name].variables, angle=False)
    check = check_base(matrix, CASES[name].base)

    assert check.valid and check.reason.startswith("valid") and not check.completions


@settings(max_examples=60, deadline=None)
@given(some_variables, st.data())
def test_a_completion_completes_and_a_product_has_no_dimension(variables, data):
    matrix = dimension_matrix(variables, angle=False)
    base = data.draw(st.lists(st.sampled_from(list(variables)), unique=True)) if variables else []
    check = check_base(matrix, base)

    for more in check.completions:
        assert check_base(matrix, [*check.kept, *more]).valid
    if not check.valid:
        assert check.completions  # all variables are candidates, so there is always one
    if check.product:
        columns = [matrix.column(name) for name in check.product]
        powers = check.product.values()
        assert not any(sum(c[k] * x for c, x in zip(columns, powers, strict=True)) for k in range(7))
        assert set(check.product) <= set(base)
    assert check.valid == (not check.product and not check.unreached)


@settings(max_examples=40, deadline=None)
@given(some_variables)
def test_the_valid_bases_are_all_and_only_the_independent_sets_of_full_rank(variables):
    matrix = dimension_matrix(variables, angle=False)
    found = list(independent_sets(matrix, matrix.names, empty_span(7)))

    expected = [
        names
        for names in combinations(matrix.names, matrix.rank)
        if span_of([matrix.column(name) for name in names], 7) is not None
    ]
    assert found == expected  # in lexicographic order, each once


def test_bases_are_made_only_when_asked_for():
    units = ("kg", "m", "s", "A", "K", "mol")
    many = dimension_matrix({f"x{i}": units[i % 6] for i in range(300)}, angle=False)

    assert len(list(islice(independent_sets(many, many.names, empty_span(7)), 10))) == 10  # of 1.6e10


@settings(max_examples=40, deadline=None)
@given(some_variables)
def test_lonely_variables_are_those_in_no_group(variables):
    from similitude import pi_groups

    used = {name for group in pi_groups(variables) for name in group}

    assert set(lonely(dimension_matrix(variables, angle=False))) == set(variables) - used


def test_a_long_list_is_cut_and_counted():
    assert "and 1 more" in check_base(PIPE, ["V"]).reason or "more" in check_base(PIPE, []).reason


def test_products_read_as_people_write_them():
    assert product_text({}) == "1"
    assert product_text({"a": 1, "L": -1}) == "a/L"
    assert product_text({"mu": 1, "rho": -1, "V": -1}) == "mu/(rho V)"
    assert product_text({"F": -2}) == "1/F^2"
