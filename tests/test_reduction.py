"""A Reduction gives every group in unknowns and scales, or is refused."""

from dataclasses import replace

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.reduction import Unknown
from similitude.systems.bicycle import bicycle_reduction

from .small_systems import CASES

BICYCLE = bicycle_reduction()


def test_a_group_without_an_expression_is_refused():
    partial = {name: e for name, e in BICYCLE.substitution.items() if name != "pi4"}
    with pytest.raises(ModelError, match="pi4 has no expression"):
        replace(BICYCLE, substitution=partial)


def test_a_symbol_that_nobody_knows_is_refused():
    with pytest.raises(ModelError, match="rho is neither an unknown nor a scale"):
        replace(BICYCLE, unknowns=BICYCLE.unknowns[:3])


@pytest.mark.parametrize("name", CASES)
def test_the_reduced_rates_hold_states_inputs_unknowns_and_scales_only(name):
    reduction = CASES[name]().reduction
    model = reduction.groups.model
    known = {u.name for u in reduction.unknowns} | set(reduction.groups.base)
    known |= {q.name for q in (*model.states, *model.inputs)}

    used = {
        s.name for e in (*reduction.rates.values(), *reduction.output_map.values()) for s in e.free_symbols
    }
    assert used <= known


def test_groups_are_replaced_all_at_once():
    """pi1 -> pi2 and pi2 -> pi1 is a swap, not a chain."""
    one, two = (Unknown(n, "-", "log", "identify", "") for n in ("pi2", "pi1"))
    case = CASES["spring"]().reduction
    swapped = replace(case, unknowns=(one, two), substitution={"pi1": one.symbol, "pi2": two.symbol})
    a, b = sp.symbols("a b", real=True)

    pi1, pi2 = (g.symbol for g in case.groups.groups)
    want = case.groups.rates["v"].subs({pi1: a, pi2: b}).subs({a: pi2, b: pi1})
    assert sp.expand(swapped.rates["v"] - want) == 0


def test_the_coordinate_of_a_positive_unknown_is_its_logarithm():
    log, linear = (Unknown("q", "-", kind, "identify", "") for kind in ("log", "linear"))

    assert log.jacobian == log.symbol and linear.jacobian == 1
