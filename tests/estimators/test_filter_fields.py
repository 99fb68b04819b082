"""The layout follows from the Reduction alone: names, order, units, and the scales the step needs."""

from dataclasses import replace

import pytest
import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.estimators.filter_fields import Layout
from similitude.systems.bicycle import bicycle_reduction
from similitude.units import parse_unit

from ..run_statements import evaluate
from ..small_systems import CASES

REDUCTIONS = {name: case().reduction for name, case in CASES.items()}
REDUCTIONS["bicycle"] = bicycle_reduction()
KINDS = {
    "config": ff.config_fields,
    "state": ff.state_fields,
    "sample": ff.sample_fields,
    "output": ff.output_fields,
}
layouts = pytest.mark.parametrize("layout", [Layout(r) for r in REDUCTIONS.values()], ids=[*REDUCTIONS])


def test_the_bicycle_is_laid_out_as_published():
    layout = Layout(REDUCTIONS["bicycle"])

    assert layout.coordinates[:3] == ("v_star", "r_star", "disturbance")
    assert layout.coordinates[3:7] == ("K", "pi1", "eta", "rho")
    assert layout.coordinates[7:] == ("input_scale", "input_offset", "output_bias")
    assert layout.target == "K" and layout.input.name == "delta" and layout.output.name == "r"
    assert [q.name for q in layout.signals] == ["U"] and [q.name for q in layout.scales] == ["L"]
    assert [f.name for f in ff.sample_fields(layout)] == ["dt", "input", "U", "measured"]


@layouts
def test_no_name_is_used_twice_and_each_says_what_it_is(layout):
    fields = [f for make in KINDS.values() for f in make(layout)]
    names = [s.name for f in fields for s in f.symbols]

    assert len(names) == len(set(names))
    assert all(f.meaning and f.unit for f in fields)
    assert layout.covariance.n == len(layout.coordinates) == len(set(layout.coordinates))


@layouts
def test_every_unit_can_be_read(layout):
    for make in KINDS.values():
        for field in make(layout):
            text = field.unit.replace("(", "").replace(")^2", "")
            for part in text.split("/", 1) if ")^2" in field.unit else [field.unit]:
                parse_unit(part)


@layouts
def test_scales_are_those_that_occur_and_are_known_constants(layout):
    """Mass cancels from the bicycle's rates; an airspeed is measured, not configured."""
    names = {q.name for q in layout.scales}

    assert names <= set(layout.reduction.groups.base) - {q.name for q in layout.signals}
    assert names <= {f.name for f in ff.config_fields(layout)}


def test_a_scale_that_only_the_condition_uses_is_configured_too():
    m = sp.Symbol("m", real=True)
    bicycle = replace(REDUCTIONS["bicycle"], live=REDUCTIONS["bicycle"].live & (m > 0))

    assert [q.name for q in Layout(bicycle).scales] == ["m", "L"]


@layouts
def test_reciprocals_are_taken_once_and_change_no_value(layout):
    scales = (*layout.signals, *layout.scales)
    for state in layout.reduction.groups.model.states:
        expression = layout.reduction.groups.scale[state.name] / layout.reduction.groups.time_scale
        expression = sp.sympify(expression)
        if not {s.name for s in expression.free_symbols} <= {q.name for q in scales}:
            continue
        values = {q.name: 1.5 + i for i, q in enumerate(scales)}
        inside = {layout.at(n).name: v for n, v in values.items()}
        inside |= {layout.inverse(n).name: 1 / v for n, v in values.items()}

        inverted = layout.inverted(expression)

        assert not [p for p in inverted.atoms(sp.Pow) if p.exp.is_negative]
        # four factors, five roundings
        assert evaluate(inverted, inside) == pytest.approx(evaluate(expression, values), rel=1e-15)


def test_considered_are_those_of_that_role():
    layout = Layout(REDUCTIONS["drive"])

    assert layout.considered == ("friction",)
    assert layout.prior.size == 6 and layout.covariance.size == 55
