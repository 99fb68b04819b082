"""The regressions' coefficients, derived from models; refusals for what does not fit."""

import dataclasses

import numpy as np
import pytest
import sympy as sp
from scipy import signal

from similitude.errors import ModelError
from similitude.estimators.paper_design import slopes
from similitude.estimators.second_order import second_order
from similitude.groups import reparameterize
from similitude.systems.bicycle import BICYCLE, bicycle_reduction, r

VALUES = {"K": 120.0, "pi1": 0.45, "eta": 1.5, "rho": 1.05, "L": 2.7, "U": 22.0, "pi3": 0.25}


def number(expression):
    return float(expression.subs({s: VALUES[s.name] for s in expression.free_symbols}))


def test_the_coefficients_are_those_of_the_car_s_transfer_function():
    """Against numerator and denominator from the matrices of the model in SI units, by scipy."""
    found = second_order(bicycle_reduction())
    K, p1, eta, rho, L, U = (VALUES[n] for n in ("K", "pi1", "eta", "rho", "L", "U"))
    p2, f = 1 - p1, K / L
    b, a, rear, J = p2 * L, p1 * L, f * eta * p1 / p2, rho * p1 * p2 * L * L
    A = [[-(f + rear) / U, (b * rear - a * f) / U - U],
         [(b * rear - a * f) / (J * U), -(a * a * f + b * b * rear) / (J * U)]]  # fmt: skip
    over, under = signal.ss2tf(
        np.array(A), np.array([[f], [a * f / J]]), np.array([[0, 1.0]]), np.zeros((1, 1))
    )

    assert K * number(found.input_gain * found.per_input_rate) == pytest.approx(over[0, 1], rel=1e-10)
    assert K**2 * number(found.pair_input * found.per_pair_input) == pytest.approx(over[0, 2], rel=1e-10)
    assert K * number(found.damping * found.per_rate) == pytest.approx(under[1], rel=1e-10)
    stiffness = K * number(found.stiffness * found.per_output)
    stiffness += K**2 * number(found.pair_output * found.per_pair_output)
    assert stiffness == pytest.approx(under[2], rel=1e-10)


def test_the_first_two_are_the_paper_s_slopes():
    found = second_order(bicycle_reduction())
    p1 = VALUES["pi1"]
    k, pi5 = VALUES["eta"] * p1 / (1 - p1), VALUES["rho"] * p1 * (1 - p1)

    m1, m2 = slopes(1.0, pi1=p1, pi4_slope=k, pi5=pi5)
    assert number(found.input_gain) == pytest.approx(m1, rel=1e-12)
    assert number(found.damping) == pytest.approx(m2, rel=1e-12)


def test_names_are_those_of_the_reduction():
    found = second_order(bicycle_reduction())
    assert (found.target, found.frozen, found.speed) == ("K", ("pi1", "eta", "rho"), "U")


def changed(**changes):
    groups = reparameterize(dataclasses.replace(BICYCLE, **changes), base=("m", "L", "U"))
    return dataclasses.replace(bicycle_reduction(), groups=groups)


def damped():
    m, Iz, L, U = sp.symbols("m Iz L U", real=True)
    return {**BICYCLE.rates, "r": BICYCLE.rates["r"] - r * m * U * L / Iz}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"rates": {**BICYCLE.rates, "r": BICYCLE.rates["r"] * (1 + r**2 * sp.Symbol("L") ** 2)}}, "."),
        ({"signals": ()}, "measured along"),
        ({"rates": damped()}, "another form"),
    ],
)
def test_a_model_the_form_does_not_hold_for_is_refused(changes, said):
    with pytest.raises(ModelError, match=said):
        second_order(changed(**changes))


def test_a_group_that_is_no_scale_times_the_unknown_is_refused():
    with pytest.raises(ModelError, match="not a scale times"):
        second_order(bicycle_reduction(), unknown="pi4")
