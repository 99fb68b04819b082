"""The chain rule's terms against a car whose speed changes, simulated with dimensions."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from similitude.groups import reparameterize
from similitude.rewriting.moving_scales import chain_terms, rate_symbol
from similitude.rewriting.rewritten import rewrite
from similitude.systems.bicycle import BICYCLE

CAR = {"m": 1500.0, "Iz": 2500.0, "a": 1.2, "b": 1.5, "L": 2.7, "Caf": 9e4, "Car": 1.1e5}
SPEEDING = 3.0  # m/s^2


def test_terms_carry_the_power_of_the_scale():
    groups = reparameterize(BICYCLE, base=("m", "a", "U"))
    v, r = sp.symbols("v r", real=True)

    assert chain_terms(groups, ["a"]) == {"r": r * rate_symbol("a")}  # r is counted in U/a
    assert chain_terms(groups, ["U"]) == {"v": -v * rate_symbol("U"), "r": -r * rate_symbol("U")}
    assert chain_terms(groups, ["m"]) == {}


def test_with_the_terms_a_car_that_speeds_up_is_the_same_car():
    """Dimensionless and dimensional equations side by side, t* carried along as dt*/dt = U/L."""
    rewritten = rewrite(BICYCLE, base=("m", "L", "U"), moving=["U"])
    names = [q.name for q in BICYCLE.quantities]
    real = sp.lambdify(names, list(BICYCLE.rates.values()))
    star = sp.lambdify([q.name for q in rewritten.model.quantities], list(rewritten.model.rates.values()))

    def rhs(t, x):
        U, delta = 10 + SPEEDING * t, 0.02 * np.sin(2 * t)
        known = CAR | {"U": U, "delta": delta}
        dimensional = real(*(({"v": x[0], "r": x[1]} | known)[n] for n in names))
        groups = rewritten.groups.value(known)
        bare = groups | {"v": x[2], "r": x[3], "delta": delta, "U_rate": SPEEDING * CAR["L"] / U**2}
        dimensionless = star(*(bare[q.name] for q in rewritten.model.quantities))
        return [*dimensional, *(U / CAR["L"] * f for f in dimensionless)]

    end = solve_ivp(rhs, (0, 3), [0, 0, 0, 0], rtol=1e-11, atol=1e-14).y[:, -1]
    U = 10 + SPEEDING * 3

    assert end[2] * U == pytest.approx(end[0], rel=1e-8)
    assert end[3] * U / CAR["L"] == pytest.approx(end[1], rel=1e-8)
