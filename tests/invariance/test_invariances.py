"""The noun and its verbs: what is printed, what is refused, Euler's theorem, nothing left after rewriting."""

from dataclasses import replace
from fractions import Fraction

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.invariance.invariances import RESPONSES, euler_rows, invariances
from similitude.model import Quantity
from similitude.rewriting.rewritten import rewrite
from similitude.systems.bicycle import BICYCLE


def test_the_cube_of_the_paper():
    """Eqs 10-12: 3 V = 1 S dV/dS."""
    rows = euler_rows("S**3", [Quantity("S", "m", "edge")])

    assert [str(row) for row in rows.rows] == ["length: S_S = 3"]
    assert rows.verify() == {"length": 0} and rows.verify({"S": "20 cm"}) == {"length": 0.0}
    assert rows.sensitivities() == {"S": 3}


def test_the_function_of_the_paper_is_homogeneous_of_order_two():
    """Eq 5."""
    rows = euler_rows("7*x1^2 + 2*x2^2", [Quantity("x1", "m"), Quantity("x2", "m")])

    assert str(rows.rows[0]) == "length: S_x1 + S_x2 = 2"
    assert rows.verify({"x1": 3.0, "x2": 5.0})["length"] < 1e-15


@pytest.mark.parametrize(
    ("expression", "output", "said"),
    [
        ("x + x**2", "", "not homogeneous"),
        ("x", "s", "not homogeneous"),
        (sp.Symbol("q"), "", "q, which is not"),
    ],
)
def test_a_function_that_is_not_homogeneous_is_refused(expression, output, said):
    with pytest.raises(ModelError, match=said):
        euler_rows(expression, [Quantity("x", "m")], output=output)


@pytest.mark.parametrize("kind", RESPONSES)
def test_after_the_rewrite_every_row_is_empty(kind):
    bare = rewrite(BICYCLE, base=("m", "L", "U")).model

    assert invariances(bare, response=kind).rows == ()
    shown = invariances(bare, response=kind, dimensions=("mass", "length", "time"))
    assert len(shown.rows) == 3 and all(row.is_empty for row in shown.rows)
    assert "every row is empty" in str(shown)
    assert shown.verify() == {"mass": 0, "length": 0, "time": 0}


def test_a_page_of_rows():
    assert str(invariances(BICYCLE, response="poles")).splitlines() == [
        "poles [1/s], a function of m, U, a, b, Caf, Car, Iz",
        "  mass:   S_m + S_Caf + S_Car + S_Iz = 0",
        "  length: S_U + S_a + S_b + S_Caf + S_Car + 2 S_Iz = 0",
        "  time:   -S_U - 2 S_Caf - 2 S_Car = -1",
    ]


def test_what_does_not_exist_is_refused_with_what_does():
    with pytest.raises(ModelError, match="there are time, frequency"):
        invariances(BICYCLE, response="bode")
    with pytest.raises(ModelError, match="no closed form"):
        invariances(BICYCLE).sensitivities()
    with pytest.raises(ModelError, match="with angles as a dimension"):
        invariances(BICYCLE, angle=True)
    with pytest.raises(ModelError, match="is missing"):
        invariances(BICYCLE).verify({"m": 1.0})


def test_angles_are_a_row_where_the_model_keeps_them_apart():
    rows = euler_rows("M/c", [Quantity("M", "N m"), Quantity("c", "N m/rad")], angle=True)

    assert str(rows.rows[-1]) == "angle: -S_c = 1" and rows.verify()["angle"] == 0


@pytest.mark.parametrize("response", ["time", "frequency", "dc_gain", "steady_state"])
def test_a_falsified_row_is_not_proven(response):
    found = invariances(BICYCLE, "r", response)
    first, *rest = found.rows
    name = next(iter(first.coefficients))
    wrong = {**first.coefficients, name: first.coefficients[name] + Fraction(1, 2)}
    for bad in (replace(first, coefficients=wrong), replace(first, rhs=first.rhs + 1)):
        residual = replace(found, rows=(bad, *rest)).verify()
        assert residual[first.dimension] != 0
        assert all(residual[row.dimension] == 0 for row in rest)


def test_a_row_with_an_argument_left_out_is_not_proven():
    """The paper's eq 13 leaves out time."""
    found = invariances(BICYCLE, "r", "time")
    rows = tuple(
        replace(r, coefficients={n: c for n, c in r.coefficients.items() if n != "t"}) for r in found.rows
    )
    residual = replace(found, rows=rows).verify()
    assert residual["time"] == -sp.Symbol("S_t")
    assert residual["mass"] == residual["length"] == 0
