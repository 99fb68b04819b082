"""The discretisation of the paper (eqs 21-27) against the exact zero-order hold."""

import numpy as np
import pytest
import sympy as sp
from scipy import signal

from similitude.estimators.paper_design import exact_coefficients, slopes
from similitude.estimators.paper_model import regression
from similitude.systems.bicycle import bicycle_groups, bicycle_reduction, delta, r, v

T = 0.011
AVERAGE = {"pi1": 0.4431, "pi4_slope": 1.0977, "pi5": 0.2510}
pi1, pi3, pi5, k = sp.symbols("pi1 pi3 pi5 pi4_slope", real=True)


def transfer_function(value):
    """Equation 19 in numbers, from the rewritten model."""
    k_, p1, p5 = AVERAGE["pi4_slope"], AVERAGE["pi1"], AVERAGE["pi5"]
    p2, p3, p4 = 1 - p1, value, k_ * value
    over = [p1 * p3 / p5, p3 * p4 / p5]
    damping = p3 + p4 + (p1**2 * p3 + p2**2 * p4) / p5
    return over, [1, damping, (p3 * p4 - p1 * p3 + p2 * p4) / p5]


def exact(value):
    """b1, b2, a1 + 2, a2 - 1 by scipy."""
    over, under, _ = signal.cont2discrete(transfer_function(value), T, method="zoh")
    return np.array([over[0, 1], over[0, 2], under[1] + 2, under[2] - 1])


def linear(value):
    m1, m2 = slopes(T, **AVERAGE)
    return value * np.array([m1, -m1, m2, -m2])


@pytest.mark.parametrize(
    ("value", "found", "line"),
    [
        (0.1, [0.00193999, None, 0.00466240, -0.00464903], [0.00194187, None, 0.00465987, None]),
        (1.0, [0.0192318, -0.0187148, 0.0461259, -0.0455297], [None] * 4),
        (1.4, [0.0268208, None, 0.0642696, None], [0.0271862, None, 0.0652382, None]),
    ],
)
def test_the_numbers_of_figure_4(value, found, line):
    for numbers, expected in ((exact(value), found), (linear(value), line)):
        for number, wanted in zip(numbers, expected, strict=True):
            if wanted is not None:
                digits = len(f"{abs(wanted):.8f}".rstrip("0")) - 2
                assert number == pytest.approx(wanted, abs=0.501 * 10**-digits)


@pytest.mark.parametrize("value", [0.1, 0.5, 1.4])
def test_our_exact_coefficients_are_those_of_scipy(value):
    assert exact_coefficients(value, T, **AVERAGE)[0] == pytest.approx(exact(value), rel=1e-9)


def test_m1_and_m2_in_symbols():
    """m1 = T d(C B)/d(pi3), m2 = -T d(trace A)/d(pi3), with pi4 = k pi3."""
    groups = bicycle_groups()
    fixed = {sp.Symbol("pi2", real=True): 1 - pi1, sp.Symbol("pi4", real=True): k * pi3}
    f = sp.Matrix([groups.rates[n] for n in ("v", "r")]).subs(fixed)
    A, B = f.jacobian(sp.Matrix([v, r])), f.jacobian(sp.Matrix([delta]))
    derived = regression(bicycle_reduction())

    assert sp.simplify(derived.numerator - sp.diff(B[1], pi3)) == 0
    assert sp.simplify(derived.denominator + sp.diff(A.trace(), pi3)) == 0
    assert sp.simplify(derived.numerator - pi1 / pi5) == 0
    assert sp.simplify(derived.denominator - (1 + k + (pi1**2 + (1 - pi1) ** 2 * k) / pi5)) == 0


def test_the_offsets_stand_outside_pi3():
    """Erratum of eq 22: -2 + m2 pi3, not (-2 + m2 T) pi3; at pi3 = 0.1 they differ by 1.8."""
    m2 = slopes(T, **AVERAGE)[1]
    a1 = exact(0.1)[2] - 2

    assert a1 == pytest.approx(-2 + m2 * 0.1, abs=5e-6)
    assert abs(a1 - (-2 + m2 * T) * 0.1) > 1.7


def test_m2_carries_T_once():
    """Erratum after eq 22: without T the slope would be wrong by a factor of 90."""
    slope = (exact(0.11)[2] - exact(0.09)[2]) / 0.02

    assert slope == pytest.approx(slopes(T, **AVERAGE)[1], rel=0.01)
    assert slopes(2 * T, **AVERAGE)[1] == pytest.approx(2 * slopes(T, **AVERAGE)[1])


def test_equation_23_has_a_common_factor_and_is_a_first_order_lag():
    """Its DC gain m1/m2 does not depend on pi3."""
    z, m1, m2 = sp.symbols("z m1 m2")
    over = m1 * pi3 / z - m1 * pi3 / z**2
    under = 1 + (-2 + m2 * pi3) / z + (1 - m2 * pi3) / z**2
    lag = m1 * pi3 / z / (1 - (1 - m2 * pi3) / z)

    assert sp.simplify(over.subs(z, 1)) == sp.simplify(under.subs(z, 1)) == 0
    assert sp.simplify(over / under - lag) == 0
    assert sp.simplify(lag.subs(z, 1) - m1 / m2) == 0


def test_equations_24_to_27_are_equation_23_multiplied_out():
    z, m1, m2 = sp.symbols("z m1 m2")
    R, D = sp.symbols("R D")  # z-transforms of dimensionless yaw rate and steer
    y = R * (1 - 2 / z + 1 / z**2)
    phi = -m2 * R / z + m2 * R / z**2 + m1 * D / z - m1 * D / z**2
    solved = sp.solve(sp.Eq(y, phi * pi3), R)[0] / D
    lag = m1 * pi3 / z / (1 - (1 - m2 * pi3) / z)

    assert sp.simplify(solved - lag) == 0


def test_the_term_that_the_line_leaves_out():
    """1 + a1 + a2 = pi3 (k pi3 + p2 k - pi1) T^2/pi5, zero on the line, to third order in T."""
    p1, k_, p5 = AVERAGE["pi1"], AVERAGE["pi4_slope"], AVERAGE["pi5"]
    for value in (0.1, 1.0):
        _, _, a1, a2 = exact(value)
        expected = value * (k_ * value + (1 - p1) * k_ - p1) * T**2 / p5
        assert a1 + a2 == pytest.approx(expected, rel=0.05)


def test_the_printed_sample_time():
    """Erratum of section 5: T = 0.011 is 0.010953 at the test vehicle."""
    assert 1e-3 * 4.0 / 0.3652 == pytest.approx(0.010953, abs=5e-7)
