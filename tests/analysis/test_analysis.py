"""An analysis agrees with itself: units, groups, scalings and rows tell one story."""

from fractions import Fraction

import pytest
import sympy as sp

from similitude.analysis.analysis import analyze_model
from similitude.errors import ModelError
from similitude.model import Model, Quantity
from similitude.systems.bicycle import BICYCLE
from similitude.systems.shipped import SHIPPED, shipped_system

DECAY = Model(
    name="decay",
    states=(Quantity("x", "m"),),
    inputs=(),
    outputs=(Quantity("x", "m"),),
    parameters=(Quantity("k", "1/s"),),
    rates={"x": "-k*x"},
    output_map={"x": "x"},
)


@pytest.fixture(scope="module")
def bicycle():
    system = shipped_system("bicycle")
    return analyze_model(system.model, base=system.base, meanings=system.meanings)


def test_a_bicycle_has_three_units_and_is_linear(bicycle):
    assert bicycle.units == 3
    assert bicycle.scalings.count == 4
    assert bicycle.beyond == ({"v": 1, "r": 1, "delta": 1},)
    assert bicycle.check


def test_groups_are_those_of_the_paper_with_the_words_of_the_system(bicycle):
    named = {group.name: group for group in bicycle.groups}

    assert named["pi3"].exponents == {"Caf": 1, "m": -1, "L": 1, "U": -2}
    assert named["pi1"].meaning
    assert bicycle.rows_after == 0
    assert bicycle.equivalence.holds


def test_every_row_of_a_bicycle_is_proven_and_counts_time(bicycle):
    rows = {row.dimension: row for row in bicycle.invariances}

    assert list(rows) == ["mass", "length", "time"]
    assert all(row.residual == 0 for row in rows.values())
    assert (rows["time"].coefficients["t"], rows["time"].rhs) == (1, -1)  # erratum of eq 13


def test_speed_that_changes_shows_more(bicycle):
    assert (bicycle.seen.determined, bicycle.steady.determined) == (5, 4)


@pytest.mark.slow
@pytest.mark.parametrize("name", SHIPPED)
def test_units_are_scalings_of_every_shipped_system(name):
    system = shipped_system(name)
    found = analyze_model(system.model, base=system.base)

    assert found.check
    assert found.units + len(found.beyond) == found.scalings.count
    for group in found.groups:  # a Pi group is left alone by the units' scalings
        column = [sum(p * found.matrix.column(n)[i] for n, p in group.exponents.items()) for i in range(7)]
        assert not any(column)
    names = found.matrix.names
    units = [list(map(int, row)) for row in zip(*found.matrix.columns, strict=True) if any(row)]
    beyond = [[row.get(n, 0) for n in names] for row in found.beyond]
    assert sp.Matrix([*units, *beyond]).rank() == found.scalings.count


def test_scalings_hold_for_every_dimension_of_the_matrix(bicycle):
    names = bicycle.scalings.equations.names
    weights = sp.Matrix([[row.get(n, 0) for n in names] for row in bicycle.scalings.weights])
    for i in range(3):
        unit = sp.Matrix([[int(bicycle.matrix.column(n)[i]) for n in names]])
        assert sp.Matrix([*weights.tolist(), *unit.tolist()]).rank() == weights.rank()


def test_without_a_base_of_parameters_the_rest_is_still_said():
    found = analyze_model(DECAY)

    assert (found.base, found.rewritten) == ((), None)
    assert "x [m]" in found.why
    assert [dict(g.exponents) for g in found.groups] == [{"t": Fraction(1), "k": Fraction(1)}]
    assert found.scalings.count == 2
    assert found.seen.is_complete


def test_a_base_is_advised_where_none_is_given():
    found = analyze_model(BICYCLE)

    assert len(found.base) == 3
    assert found.base_origin == "advised"


def test_a_base_that_cannot_measure_is_refused():
    with pytest.raises(ModelError, match="cannot be a base"):
        analyze_model(BICYCLE, base=["m", "L"])


def test_what_enters_as_a_product_is_said_in_two_names():
    block = Model(
        name="block",
        states=(Quantity("x", "m"), Quantity("v", "m/s")),
        inputs=(Quantity("F", "N"),),
        outputs=(Quantity("P", "W"),),
        parameters=(Quantity("m", "kg"), Quantity("mu", "1"), Quantity("g", "m/s^2"), Quantity("c", "kg/m")),
        rates={"x": "v", "v": "F/m - mu*g*sign(v) - c/m*v*abs(v)"},
        output_map={"P": "F*v"},
    )

    assert analyze_model(block).beyond == ({"mu": 1, "g": -1},)


def test_known_values_are_known():
    pendulum = Model(
        name="pendulum",
        states=(Quantity("phi", "rad"), Quantity("w", "rad/s")),
        inputs=(),
        outputs=(Quantity("phi", "rad"),),
        parameters=(Quantity("g", "m/s^2", "gravity", known="9.81 m/s^2"), Quantity("l", "m")),
        rates={"phi": "w", "w": "-g/l*sin(phi)"},
        output_map={"phi": "phi"},
    )

    assert analyze_model(pendulum).seen.seen == ({"l": 1},)
