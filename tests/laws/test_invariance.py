"""Laws of the rewriting: no group feels a change of units, and nothing is lost on the way back."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.groups import reparameterize
from similitude.model import Model, Quantity
from similitude.systems.bicycle import bicycle_groups

from ..small_systems import CASES

FOOT, POUND, MINUTE = 0.3048, 0.45359237, 60.0
SYSTEMS = {name: case().reduction.groups for name, case in CASES.items()}
SYSTEMS["bicycle"] = bicycle_groups()
positive = st.floats(1e-3, 1e3)
rationals = st.fractions(Fraction(1, 9), 9, max_denominator=9)


def number_in(units: dict[str, float], si: float, dimension) -> float:
    """An SI number as it reads when the base units have the given sizes in SI."""
    for name, exponent in dimension.exponents.items():
        si /= units.get(name, 1.0) ** float(exponent)
    return si


@pytest.mark.parametrize("name", SYSTEMS)
@settings(max_examples=25, deadline=None)
@given(st.data())
def test_groups_do_not_feel_a_change_of_units(name, data):
    groups = SYSTEMS[name]
    units = {"mass": POUND, "length": FOOT, "time": MINUTE, "temperature": 5 / 9}
    if data.draw(st.booleans()):
        units = {base: data.draw(positive) for base in units}
    values = {q.name: data.draw(positive) for q in groups.model.parameters}
    other = {q.name: number_in(units, values[q.name], q.dimension) for q in groups.model.parameters}

    before, after = groups.value(values), groups.value(other)

    # powers up to four of up to five numbers, each rounded once: about 50 roundings
    assert after == {g: pytest.approx(v, rel=1e-13) for g, v in before.items()}


@pytest.mark.parametrize("name", SYSTEMS)
@settings(max_examples=10, deadline=None)
@given(st.data())
def test_the_rewritten_rates_are_the_dimensional_ones(name, data):
    """Exactly, in rational arithmetic, at random parameters, states and inputs."""
    assert_nothing_lost(SYSTEMS[name], lambda: data.draw(rationals))


def assert_nothing_lost(groups, draw) -> None:
    model = groups.model
    values = {q.symbol: rational(draw()) for q in model.parameters}
    values |= {q.symbol: rational(draw()) for q in (*model.states, *model.inputs)}
    pi = {g.symbol: value_of(g, values) for g in groups.groups}
    star = {
        q.symbol: values[q.symbol] / groups.scale[q.name].subs(values) for q in (*model.states, *model.inputs)
    }
    time = groups.time_scale.subs(values)
    for q in model.states:
        back = groups.rates[q.name].subs(pi | star) * groups.scale[q.name].subs(values) / time
        assert sp.simplify(back - model.rates[q.name].subs(values)) == 0
    for q in model.outputs:
        back = groups.output_map[q.name].subs(pi | star) * groups.scale[q.name].subs(values)
        assert sp.simplify(back - sp.sympify(model.output_map[q.name]).subs(values)) == 0


def rational(value: Fraction) -> sp.Rational:
    return sp.Rational(value.numerator, value.denominator)


def value_of(group, values):
    return sp.Mul(*(values[sp.Symbol(n, real=True)] ** rational(e) for n, e in group.exponents.items()))


UNITS = st.tuples(*[st.integers(-2, 2)] * 3).map(lambda e: f"kg^{e[0]} m^{e[1]} s^{e[2]}")


@settings(max_examples=25, deadline=None)
@given(st.data())
def test_any_homogeneous_polynomial_model_is_rewritten_without_loss(data):
    """A random state and input unit, and coefficients whose units make every term fit."""
    x, u = sp.symbols("x u", real=True)
    state, driven = (Quantity(n, data.draw(UNITS)) for n in ("x", "u"))
    powers = data.draw(st.lists(st.tuples(*[st.integers(0, 3)] * 2), min_size=1, max_size=4))
    terms, parameters = [], []
    second = Quantity("T", "s").dimension
    for i, (a, b) in enumerate(powers):
        dimension = state.dimension / second / state.dimension**a / driven.dimension**b
        unit = " ".join(f"{n}^{e}" for n, e in si(dimension).items()) or "1"
        parameters.append(Quantity(f"c{i}", unit))
        terms.append(parameters[-1].symbol * x**a * u**b)
    measures = [Quantity("M", "kg"), Quantity("D", "m"), Quantity("T", "s")]
    model = Model(
        name="random",
        states=(state,),
        inputs=(driven,),
        outputs=(state,),
        parameters=(*measures, *parameters),
        rates={"x": sp.Add(*terms)},
        output_map={"x": x},
    )

    groups = reparameterize(model, base=("M", "D", "T"))

    assert len(groups.groups) == len(powers)
    assert_nothing_lost(groups, lambda: data.draw(rationals))


def si(dimension) -> dict[str, Fraction]:
    symbols = {"mass": "kg", "length": "m", "time": "s"}
    return {symbols[name]: e for name, e in dimension.exponents.items()}
