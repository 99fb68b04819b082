"""Equations 1 to 20: the model, Euler's theorem, sensitivities, groups, the rewritten model."""

from __future__ import annotations

import numpy as np
import sympy as sp

from similitude.estimators.paper_design import PAPER_GROUPS
from similitude.estimators.paper_model import proportional_matrices
from similitude.paper import printed
from similitude.paper.bode import (
    PARAMETERS,
    exponents,
    right_sides,
    row_sums,
    state_space,
    step_response,
    transfer_function,
)
from similitude.paper.claims_groups import test_vehicle_groups
from similitude.paper.claims_invariance import degree
from similitude.populations.shipped import shipped_population
from similitude.simulation.car import Car
from similitude.simulation.lqr import path_matrices
from similitude.systems.bicycle import bicycle_groups, bicycle_reduction

AT = 0.3  # s
W = 5.0j  # rad/s


def _car() -> Car:
    return Car(**{n: v for n, v in printed.TEST_VEHICLE.items() if n != "U"})


def _state_space() -> float:
    """Eqs 1 to 3: the yaw rate of x' = A x + B u is that of eq 4."""
    A, B = path_matrices(_car(), printed.TEST_VEHICLE["U"])
    by_states = np.linalg.solve(W * np.eye(4) - A, B)[3]
    return abs(by_states / transfer_function(printed.TEST_VEHICLE, W)[0] - 1)


def _matrices() -> float:
    """Eq 2: the driver's matrices, entry by entry, against the print and against the shipped model."""
    car, U = _car(), 3.0
    A, B = path_matrices(car, U)
    found = np.column_stack([A, B])
    turn, both = car.b * car.Car - car.a * car.Caf, car.Caf + car.Car
    about = car.a**2 * car.Caf + car.b**2 * car.Car
    as_printed = np.array([
        [0, 1, 0, 0, 0],
        [0, -both / (car.m * U), both / car.m, turn / (car.m * U), car.Caf / car.m],
        [0, 0, 0, 1, 0],
        [0, turn / (car.Iz * U), -turn / car.Iz, -about / (car.Iz * U), car.a * car.Caf / car.Iz],
    ])  # fmt: skip
    values = {sp.Symbol(n, real=True): x for n, x in {**printed.TEST_VEHICLE, "U": U}.items()}
    shipped = np.array([[0, 1, 0, 0, 0], [0] * 5, [0, 0, 0, 1, 0], [0] * 5], float)
    for place, entry in state_space().items():
        shipped[place] = float(entry.subs(values))
    scale = np.abs(found).max(axis=1, keepdims=True)
    return float(max(np.abs((found - other) / scale).max() for other in (as_printed, shipped)))


def _states() -> float:
    """Eq 3: position is the integral of the first rate, heading of the yaw rate."""
    A, B = path_matrices(_car(), 4.0)
    kinematic = np.array([[0, 1, 0, 0], [0, 0, 0, 1]])
    return float(np.abs(A[[0, 2]] - kinematic).max() + np.abs(B[[0, 2]]).max())


def _eq_4() -> float:
    """Eq 4 in its printed letters against the shipped model."""
    m, Iz, U, a, b, Cf, Cr = (printed.TEST_VEHICLE[n] for n in PARAMETERS)
    L = printed.WHEELBASE
    over = a * Cf / Iz * W + Cf * Cr * L / (m * Iz * U)
    damping = (Cf + Cr) / (m * U) + (a * a * Cf + b * b * Cr) / (Iz * U)
    under = W * W + damping * W + Cf * Cr * L * L / (m * Iz * U * U) - (a * Cf - b * Cr) / Iz
    return abs(transfer_function(printed.TEST_VEHICLE, W)[0] / (over / under) - 1)


def _eq_5() -> float:
    return abs(degree("7*x1**2 + 2*x2**2", "x1", "x2") - 2)


def _scaled(factors: tuple[float, float, float]) -> tuple[dict[str, float], float]:
    """The test vehicle and a time in other units of mass, length and time (eqs 7 and 8)."""
    vehicle = {
        n: v * float(np.prod(np.power(factors, exponents("time", n))))
        for n, v in printed.TEST_VEHICLE.items()
    }
    return vehicle, AT * float(np.prod(np.power(factors, exponents("time", "t"))))


def _homogeneous() -> float:
    """Eqs 6 to 8: in other units the yaw rate is the same quantity."""
    factors = (2.2046, 3.2808, 1 / 60)
    vehicle, t = _scaled(factors)
    one, other = step_response(printed.TEST_VEHICLE, AT)[0], step_response(vehicle, t)[0]
    return abs(other / (one * np.prod(np.power(factors, right_sides("time")))) - 1)


def _rows() -> float:
    """Eqs 9, 13, 14 and 16, with time among the arguments and the sign of its row put right."""
    _, S = step_response(printed.TEST_VEHICLE, AT)
    return float(np.abs(row_sums("time", S) - right_sides("time")).max())


def _cube() -> float:
    """Eqs 10 to 12."""
    return abs(degree("S**3", "S") - 3)


def _bode() -> float:
    """Eq 15: the exact sensitivity against a difference of logarithms."""
    _, S = step_response(printed.TEST_VEHICLE, AT)
    h = 1e-4
    up, down = (
        step_response({**printed.TEST_VEHICLE, "Caf": printed.TEST_VEHICLE["Caf"] * np.exp(s * h)}, AT)[0]
        for s in (1, -1)
    )
    return float(abs((np.log(up) - np.log(down)) / (2 * h) - S["Caf"]))


def _groups() -> float:
    found, ours = test_vehicle_groups(4.0), printed.groups_of(printed.TEST_VEHICLE)
    return max(abs(found[n] / ours[n] - 1) for n in ours)


def _averages() -> float:
    """Eq 18: what the estimators take as averages is what is printed."""
    taken = (PAPER_GROUPS["pi1"], PAPER_GROUPS["pi4_slope"], PAPER_GROUPS["pi5"])
    found = shipped_population("passenger_cars").prior
    prior = dict(zip(found.names, found.mean.tolist(), strict=True))
    pairs = [*zip(taken, (printed.PI1, printed.SLOPE, printed.PI5), strict=True)]
    pairs += [(prior["K"], printed.K), (prior["pi1"], printed.PI1)]
    return max(abs(x / y - 1) for x, y in pairs)


def _rewritten() -> float:
    """Eq 19: the rewritten model at s L/U, in units of U/L, against eq 4."""
    groups = bicycle_groups()
    g = groups.value({**printed.TEST_VEHICLE, "L": printed.WHEELBASE})
    x = sp.Matrix([q.symbol for q in groups.model.states])
    u = sp.Matrix([q.symbol for q in groups.model.inputs])
    f = sp.Matrix([groups.rates[q.name] for q in groups.model.states])
    at = {sp.Symbol(n, real=True): v for n, v in g.items()}
    A, B = (np.array(J.subs(at), float) for J in (f.jacobian(x), f.jacobian(u)))
    tau = printed.WHEELBASE / printed.TEST_VEHICLE["U"]
    r = np.linalg.solve(W * tau * np.eye(2) - A, B)[1, 0]
    return abs(r / tau / transfer_function(printed.TEST_VEHICLE, W)[0] - 1)


def _slope_taken_out() -> float:
    """Eq 20: what the regression is derived from, as a transfer function, against the print with k for π4."""
    A, B, C = proportional_matrices(bicycle_reduction(), unknown="pi3", slopes=("pi4",))
    over, under = as_printed_20()
    s = sp.Symbol("s")
    found = (C * (s * sp.eye(2) - A).inv() * B)[0]
    return float(sp.simplify(found - over / under) != 0)


def as_printed_20() -> tuple[sp.Expr, sp.Expr]:
    """Numerator and denominator of eq 20 in s, pi1, pi3, pi5 and pi4_slope, which is its π4."""
    p1, p3, p5, k = (sp.Symbol(n, real=True) for n in ("pi1", "pi3", "pi5", "pi4_slope"))
    s = sp.Symbol("s")
    over = p1 / p5 * p3 * s + k / p5 * p3**2
    under = s**2 + (1 + k + (p1**2 + (1 - p1) ** 2 * k) / p5) * p3 * s
    return over, under + (k * p3**2 - p1 * p3 + (1 - p1) * k * p3) / p5


_LQR = "similitude.simulation.lqr.path_matrices"
_RULE = "similitude.invariance.invariances."
_BODE = "similitude.paper.bode."
_MODEL = "similitude.estimators.paper_model."
_BICYCLE = "similitude.systems.bicycle."
TABLE = (
    (1, "x' = A x + B u, y = C x + D u", _LQR, _state_space),
    (2, "A and B of the bicycle in path-error coordinates", _LQR, _matrices),
    (3, "x = [y, ẏ, ψ, ψ̇]", _LQR, _states),
    (4, "ψ̇/δ as a transfer function, and the parameters of the test vehicle", _BICYCLE + "BICYCLE", _eq_4),
    (5, "f(k x) = k² f(x) for 7 x1² + 2 x2²", _RULE + "euler_rows", _eq_5),
    (6, "y = f(x1 … xn)", _RULE + "invariances", _homogeneous),
    (7, "K y = f(K1 x1 … Kn xn)", _RULE + "invariances", _homogeneous),
    (8, "K = Aᵃ Bᵇ Cᶜ, Ki likewise: exponents of the units", _BODE + "exponents", _homogeneous),
    (9, "a y = Σ ai xi ∂y/∂xi, one row a unit", _RULE + "invariances", _rows),
    (10, "V = S³", _RULE + "euler_rows", _cube),
    (11, "A³ V = (A S)³", _RULE + "euler_rows", _cube),
    (12, "3 V = S dV/dS", _RULE + "euler_rows", _cube),
    (13, "the three rows of the yaw rate: 0, 0, −1, time included", _RULE + "invariances", _rows),
    (14, "the same as a matrix, over y", _RULE + "invariances", _rows),
    (15, "S = (∂G/∂a)(a/G), Bode's sensitivity", _RULE + "Invariances", _bode, 1e-7),
    (16, "d = D S", _RULE + "Invariances", _rows),
    (
        17,
        "π1 = a/L, π2 = b/L, π3 = Caf L/(m U²), π4 = Car L/(m U²), π5 = Iz/(m L²)",
        _BICYCLE + "bicycle_groups",
        _groups,
    ),
    (18, "averages of over 700 vehicles", "similitude.estimators.paper_design.PAPER_GROUPS", _averages),
    (19, "r*/δ in the groups and dimensionless s", _BICYCLE + "bicycle_groups", _rewritten),
    (20, "the same with π4 = k π3", _MODEL + "proportional_matrices", _slope_taken_out),
)
