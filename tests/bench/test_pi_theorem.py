"""What is weighed against one another finds the same groups."""

from fractions import Fraction

import pytest
import sympy as sp
from bench.measurements import QUICK, dimensional
from bench.pi_theorem import BASE, SIZES, actions, variables

from similitude.dimensional.matrix import dimension_matrix

NAMES = list(variables(40))


def rows_of(tool: str, found) -> list[list]:
    """The groups as rows of exponents, from whatever a tool returns."""
    if tool.startswith("SymPy, D"):
        return found.to_Matrix().tolist()
    if tool.startswith("SymPy"):
        return [list(column) for column in found]
    if tool == "buckinghampy":
        return [list(map(sp.Rational, number.vector)) for number in found]
    if tool == "nodimo":
        (relation,) = found.relations.values()
        found = [_exponents(product) for product in relation.quantities]
    return [[sp.Rational(Fraction(str(group.get(n, 0)))) for n in NAMES] for group in found]


def _exponents(product) -> dict:
    """Of a product of nodimo's, which is a quantity, a power or several of those."""
    factors = getattr(product, "factors", [product])
    return {getattr(f, "_base", f).name: getattr(f, "_exponent", 1) for f in factors}


@pytest.mark.parametrize(
    "tool",
    [
        "similitude",
        "similitude, base given",
        "SymPy, Matrix",
        "SymPy, DomainMatrix",
        "pint",
        "buckinghampy",
        "nodimo",
    ],
)
def test_every_tool_finds_the_null_space(tool):
    action = actions(40).get(tool)
    if action is None:
        pytest.skip(f"{tool} is not installed: pip install 'similitude[bench]'")
    columns = dimension_matrix(variables(40), angle=False).columns
    D = sp.Matrix([[sp.Rational(x.numerator, x.denominator) for x in c] for c in columns]).T
    groups = sp.Matrix(rows_of(tool, action()))

    assert not any(D * groups.T)
    assert groups.rank() == groups.rows == 40 - D.rank()


def test_the_cases_have_a_base_and_are_the_same_each_time():
    for size in SIZES:
        assert variables(size) == variables(size) and len(variables(size)) == size
        columns = dimension_matrix(variables(size), angle=False)
        assert columns.rank == len(BASE) or size == 7  # all five dimensions from the base on


def test_bounds_are_in_milliseconds():
    rows, bounds = dimensional(QUICK)

    assert {bound.under for bound in bounds} == {"ms"} and len(bounds) == 2
    assert all(row.per == "list" and row.median_us > 0 for row in rows)
