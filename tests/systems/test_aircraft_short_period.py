"""The short period against the approximation of the textbook, and its printed roots for the NAVION."""

import numpy as np
import pytest
import sympy as sp

from similitude.systems.aircraft_short_period import AIRCRAFT_SHORT_PERIOD, SYSTEM


def test_the_roots_of_the_navion_are_those_that_the_textbook_computes():
    """Short-period sums in dimensional derivatives, with Cz = -(CLa + CD) replaced by -CLa here."""
    p = SYSTEM.numbers()
    pressure = p["rho"] * p["V"] ** 2 / 2
    Za = -pressure * p["S"] * p["CLa"] / p["m"]  # m/s^2
    Ma = pressure * p["S"] * p["c"] * p["Cma"] / p["Iy"]  # 1/s^2
    slow = p["c"] / (2 * p["V"]) * pressure * p["S"] * p["c"] / p["Iy"]
    Mq, Mad = slow * p["Cmq"], slow * p["Cmad"]  # 1/s
    known = {AIRCRAFT_SHORT_PERIOD.quantity(n).symbol: value for n, value in p.items()}
    rates = sp.Matrix([AIRCRAFT_SHORT_PERIOD.rates[n] for n in ("alpha", "q")]).subs(known)
    A = np.array(rates.jacobian([q.symbol for q in AIRCRAFT_SHORT_PERIOD.states]), float)

    assert np.poly(A) == pytest.approx([1, -(Mq + Mad + Za / p["V"]), Za * Mq / p["V"] - Ma], rel=1e-12)
    # about 3.6 rad/s and 0.7 for this aircraft: roots near -2.5 and 2.6 i
    roots = np.linalg.eigvals(A)
    assert roots.real == pytest.approx([-2.5, -2.5], abs=0.05)
    assert abs(roots.imag) == pytest.approx([2.6, 2.6], abs=0.05)


def test_the_coefficients_are_groups_by_themselves():
    groups = {g.parameter: dict(g.exponents) for g in SYSTEM.groups().groups}

    assert groups["Cma"] == {"Cma": 1}
    assert groups["m"] == {"m": 1, "rho": -1, "c": -3}
    assert len(groups) == 9
