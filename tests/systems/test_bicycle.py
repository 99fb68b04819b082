"""The bicycle against the numbers and formulas of the paper, and against itself unreduced."""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.systems.bicycle import BICYCLE, bicycle_groups, bicycle_reduction

# the paper's test vehicle
CAR = {
    "m": 5.451, "Iz": 0.1615, "U": 4.0, "a": 0.1461, "b": 0.2191, "L": 0.3652, "Caf": 65.0,
    "Car": 110.0,
}  # fmt: skip
fractions = st.fractions(Fraction(1, 10), 10, max_denominator=60)
v, r, delta = sp.symbols("v r delta", real=True)
pi1, pi2, pi3, pi4, pi5 = sp.symbols("pi1:6", real=True)


def test_groups_of_the_papers_test_vehicle():
    found = bicycle_groups().value(CAR)

    # printed to five digits
    printed = {"pi1": 0.40005, "pi3": 0.27217, "pi4": 0.46060, "pi5": 0.22214}
    assert {name: round(found[name], 5) for name in printed} == printed
    assert bicycle_groups().value(CAR | {"U": 3.0})["pi3"] == pytest.approx(0.48387, abs=5e-6)


def test_exponents_are_those_of_equation_17():
    exponents = {g.name: dict(g.exponents) for g in bicycle_groups().groups}

    assert exponents["pi1"] == {"a": 1, "L": -1}
    assert exponents["pi3"] == {"Caf": 1, "L": 1, "m": -1, "U": -2}
    assert exponents["pi5"] == {"Iz": 1, "m": -1, "L": -2}


def test_rewritten_rates_are_those_of_the_paper():
    groups, k = bicycle_groups(), pi4 / pi3
    sideslip = pi3 * (-(1 + k) * v + (pi2 * k - pi1) * r + delta) - r
    yaw = pi3 / pi5 * ((pi2 * k - pi1) * v - (pi1**2 + pi2**2 * k) * r + pi1 * delta)

    assert sp.expand(groups.rates["v"] - sideslip) == 0
    assert sp.expand(groups.rates["r"] - yaw) == 0
    assert groups.constraints == {"pi2": 1 - pi1}
    assert groups.time_scale == sp.Symbol("L", real=True) / sp.Symbol("U", real=True)


def test_the_yaw_transfer_function_is_that_of_section_2():
    """Poles and static gain of the rates at the paper's numbers against its printed formula."""
    m, Iz, U, a, b, L, Cf, Cr = (CAR[n] for n in ("m", "Iz", "U", "a", "b", "L", "Caf", "Car"))
    x = sp.Matrix([v, r])
    f = sp.Matrix([BICYCLE.rates["v"], BICYCLE.rates["r"]]).subs(
        {BICYCLE.quantity(n).symbol: value for n, value in CAR.items()}
    )
    A = np.array(f.jacobian(x), dtype=float)
    B = np.array(f.jacobian([delta]), dtype=float)

    damping = (Cf + Cr) / (m * U) + (a**2 * Cf + b**2 * Cr) / (Iz * U)
    stiffness = Cf * Cr * L**2 / (m * Iz * U**2) - (a * Cf - b * Cr) / Iz
    gain = Cf * Cr * L / (m * Iz * U) / stiffness
    # L is printed as 0.3652 = a + b: all sums agree to rounding
    assert np.poly(A) == pytest.approx([1, damping, stiffness], rel=1e-12)
    assert -np.linalg.solve(A, B)[1, 0] == pytest.approx(gain, rel=1e-12)


@settings(max_examples=12, deadline=None)
@given(*[fractions] * 10)
def test_the_reduced_rates_are_the_dimensional_ones(m, L, U, share, Caf, Car, Iz, at_v, at_r, at_d):
    """Exactly, in rational numbers, for any car: units, unknowns and scales lose nothing."""
    a = L * share / 11  # between the axles
    car = {"m": m, "L": L, "U": U, "a": a, "b": L - a, "Caf": Caf, "Car": Car, "Iz": Iz}
    reduction, b = bicycle_reduction(), L - a
    unknowns = {
        "K": Caf * L / m, "pi1": a / L, "eta": Car * b / (Caf * a), "rho": Iz / (m * a * b)
    }  # fmt: skip
    scale = {"v": U, "r": U / L}
    star = {"v": at_v / U, "r": at_r * L / U, "delta": at_d, "U": U, **unknowns}
    now = {"v": at_v, "r": at_r, "delta": at_d, **car}

    for name in ("v", "r"):
        dimensional = exactly(BICYCLE.rates[name], now)
        assert exactly(reduction.rates[name], star) * scale[name] * U / L == dimensional


def exactly(expression, values) -> Fraction:
    symbols = {sp.Symbol(n, real=True): sp.Rational(x.numerator, x.denominator) for n, x in values.items()}
    found = sp.Rational(expression.subs(symbols))
    return Fraction(int(found.p), int(found.q))


def test_the_first_unknown_does_not_depend_on_speed():
    reduction = bicycle_reduction()
    U, K = sp.symbols("U K", real=True)

    assert sp.simplify(reduction.substitution["pi3"] * U**2 - K) == 0
    assert reduction.unknowns[0].name == "K" and reduction.unknowns[0].role == "identify"


@pytest.mark.parametrize(("speed", "seen"), [(-5.0, False), (0.0, False), (3.0, False), (5.0, True)])
def test_dynamics_are_seen_where_pi3_is_below_ten_going_forward(speed, seen):
    live = bicycle_reduction().live
    symbols = {sp.Symbol("U", real=True): speed, sp.Symbol("K_prior", real=True): 145.68}

    assert bool(live.subs(symbols)) is seen
