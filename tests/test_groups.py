"""Rewriting a Model in groups: exact, for any base that can measure it, and refused for others."""

from fractions import Fraction

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.groups import reparameterize
from similitude.model import Model, Quantity
from similitude.systems.bicycle import BICYCLE

x, F, m1, m2, k, reach, tau = sp.symbols("x F m1 m2 k reach tau", real=True)


def lag(rate) -> Model:
    return Model(
        name="lag",
        states=(Quantity("x", "m"),),
        inputs=(Quantity("F", "N"),),
        outputs=(Quantity("x", "m"),),
        parameters=tuple(
            Quantity(name, unit)
            for name, unit in (("m1", "kg"), ("reach", "m"), ("tau", "s"), ("m2", "kg"), ("k", "N/m"))
        ),
        rates={"x": rate},
        output_map={"x": x},
    )


BASE = ("m1", "reach", "tau")
RATE = tau * (F - k * x) / m1


def test_groups_follow_the_models_order_with_exponent_one_of_their_own():
    groups = reparameterize(lag(RATE), base=BASE).groups

    assert [(g.name, g.parameter) for g in groups] == [("pi1", "m2"), ("pi2", "k")]
    assert groups[0].exponents == {"m2": 1, "m1": -1}
    assert groups[1].exponents == {"k": 1, "m1": -1, "tau": 2}


def test_the_rewritten_rate_and_the_scales_that_lead_back():
    groups = reparameterize(lag(RATE), base=BASE)
    pi2 = groups.groups[1].symbol

    assert sp.expand(groups.rates["x"] - (F - pi2 * x)) == 0
    assert groups.time_scale == tau
    assert groups.scale["F"] == m1 * reach / tau**2 and groups.scale["x"] == reach
    assert groups.output_map["x"] == x


def test_exponents_may_be_fractions():
    """Base k, m1, reach: the time is sqrt(m1/k)."""
    groups = reparameterize(lag(sp.sqrt(k / m1) * x), base=("m1", "reach", "k"))

    assert groups.groups[0].exponents == {"tau": 1, "m1": Fraction(-1, 2), "k": Fraction(1, 2)}
    assert groups.rates["x"] == x
    assert groups.value({"tau": 3, "m1": 4, "k": 9, "m2": 2})["pi1"] == pytest.approx(4.5)


@pytest.mark.parametrize(
    ("rate", "rewritten"),
    [
        (tau * F / (m1 + m2), lambda pi1: F / (1 + pi1)),
        (x**2 / (reach + x) / tau, lambda pi1: x**2 / (1 + x)),
        (sp.sqrt(reach**2 + x**2) / tau, lambda pi1: sp.sqrt(1 + x**2)),
        ((m1 + m2) ** 2 * x / (m1**2 + m2**2) / tau, lambda pi1: x * (1 + pi1) ** 2 / (1 + pi1**2)),
    ],
)
def test_sums_under_fractions_and_roots_cancel_too(rate, rewritten):
    groups = reparameterize(lag(rate), base=BASE)

    assert sp.simplify(groups.rates["x"] - rewritten(groups.groups[0].symbol)) == 0


@pytest.mark.parametrize("rate", [tau * F / m1 + k * x, F, x / tau + x, sp.sin(x) / tau])
def test_a_rate_whose_terms_differ_in_units_is_refused(rate):
    with pytest.raises(ModelError, match="not homogeneous") as caught:
        reparameterize(lag(rate), base=BASE)

    assert "the rate of 'x'" in str(caught.value)


@pytest.mark.parametrize(
    ("base", "said"),
    [
        (("m1", "m2", "tau"), "does not reach x"),  # no length, masses dependent
        (("m1", "reach"), "cannot be a base"),  # no time
        (("m1", "reach", "tau", "k"), "cannot be a base"),  # one too many
        (("m1", "reach", "speed"), "no quantity 'speed'"),
    ],
)
def test_a_base_that_does_not_span_is_refused(base, said):
    with pytest.raises(ModelError, match=said):
        reparameterize(lag(RATE), base=base)


def test_constraints_are_rewritten():
    both = Model(
        name="two",
        states=(Quantity("x", "m"),),
        inputs=(Quantity("u", "m"),),
        outputs=(Quantity("x", "m"),),
        parameters=(Quantity("reach", "m"), Quantity("tau", "s"), Quantity("a", "m"), Quantity("b", "m")),
        rates={"x": (sp.Symbol("u", real=True) - x) / tau},
        output_map={"x": x},
        constraints={"b": reach - sp.Symbol("a", real=True)},
    )
    groups = reparameterize(both, base=("reach", "tau"))

    assert groups.constraints == {"pi2": 1 - groups.groups[0].symbol}


def test_groups_that_carry_the_radian_are_told():
    """Of the bicycle the cornering stiffnesses, in newton per radian."""
    groups = reparameterize(BICYCLE, base=("m", "L", "U"))

    assert groups.angles == {"pi3": -1, "pi4": -1}


def test_a_constraint_on_a_base_parameter_is_solved_for_a_group():
    groups = reparameterize(BICYCLE, base=("m", "b", "U"))

    assert groups.constraints == {"pi1": groups.groups[1].symbol + 1}
