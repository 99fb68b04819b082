"""m1 and m2 derived from models: the paper's for the bicycle, refusals for what does not fit."""

import dataclasses

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.estimators.paper_model import regression
from similitude.groups import reparameterize
from similitude.reduction import Reduction
from similitude.systems.bicycle import BICYCLE, bicycle_reduction, delta, r, v

pi1, pi5, k, U = sp.symbols("pi1 pi5 pi4_slope U", real=True)


def changed(**changes) -> Reduction:
    groups = reparameterize(dataclasses.replace(BICYCLE, **changes), base=("m", "L", "U"))
    return dataclasses.replace(bicycle_reduction(), groups=groups)


def test_the_bicycle_has_the_slopes_of_equation_22():
    found = regression(bicycle_reduction())

    assert sp.simplify(found.numerator - pi1 / pi5) == 0
    assert sp.simplify(found.denominator - (1 + k + (pi1**2 + (1 - pi1) ** 2 * k) / pi5)) == 0
    assert sp.simplify(found.per_target - U**-2) == 0
    assert found.known == ("pi1", "pi4_slope", "pi5")
    assert found.speed == "U"


def test_lateral_speed_as_the_output_has_slopes_of_its_own():
    seen = dataclasses.replace(BICYCLE.states[0])
    found = regression(changed(outputs=(seen,), output_map={"v": v}))

    assert sp.simplify(found.numerator - 1) == 0  # v*' = pi3 delta + ...
    assert sp.simplify(found.denominator - regression(bicycle_reduction()).denominator) == 0


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"rates": {**BICYCLE.rates, "r": BICYCLE.rates["r"] * (1 + delta**2)}}, "linear"),
        ({"output_map": {"r": r + delta * sp.Symbol("U", real=True) / 2}}, "homogeneous"),
        ({"signals": ()}, "measured along"),
    ],
)
def test_a_model_the_regression_does_not_hold_for_is_refused(changes, said):
    with pytest.raises(ModelError, match=said):
        regression(changed(**changes))


def test_a_damper_that_does_not_scale_with_stiffness_is_refused():
    m, Iz, L, Uu = sp.symbols("m Iz L U", real=True)
    damped = {**BICYCLE.rates, "r": BICYCLE.rates["r"] - r * m * Uu * L / Iz}

    with pytest.raises(ModelError, match="not proportional to pi3"):
        regression(changed(rates=damped))


def test_a_group_that_is_no_scale_times_the_unknown_is_refused():
    with pytest.raises(ModelError, match="not a scale times"):
        regression(bicycle_reduction(), unknown="pi4", slopes=("pi3",))
