"""Equations 1 to 20: the model, Euler's theorem, sensitivities, groups, the rewritten model."""

from __future__ import annotations

import numpy as np
import sympy as sp

from similitude.estimators.paper_design import PAPER_GROUPS
from similitude.paper import printed
from similitude.paper.bode import (
    PARAMETERS,
    dimension_row,
    row_sums,
    state_space_residual,
    step_response,
    transfer_function,
)
from similitude.paper.claims_discrete import transfer_19
from similitude.paper.claims_groups import test_vehicle_groups
from similitude.paper.claims_invariance import YAW_RATE, euler
from similitude.populations.shipped import shipped_population
from similitude.simulation.car import Car
from similitude.simulation.lqr import path_matrices
from similitude.systems.bicycle import bicycle_groups

AT = 0.3  # s
W = 5.0j  # rad/s


def _car() -> Car:
    return Car(**{n: v for n, v in printed.TEST_VEHICLE.items() if n != "U"})


def _state_space() -> float:
    """Eqs 1 to 3: the yaw rate of x' = A x + B u is that of eq 4."""
    A, B = path_matrices(_car(), printed.TEST_VEHICLE["U"])
    by_states = np.linalg.solve(W * np.eye(4) - A, B)[3]
    return abs(by_states / transfer_function(printed.TEST_VEHICLE, W)[0] - 1)


def _matrix_dimensions() -> float:
    return float(state_space_residual()[1])


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
    x, y = sp.symbols("x1 x2", positive=True)
    return float(abs(euler(7 * x**2 + 2 * y**2, (x, y)) - 2))


def _scaled(factors: tuple[float, float, float]) -> tuple[dict[str, float], float]:
    """The test vehicle and a time in other units of mass, length and time (eqs 7 and 8)."""
    powers = {n: dimension_row(n) for n in PARAMETERS}
    vehicle = {n: v * float(np.prod(np.power(factors, powers[n]))) for n, v in printed.TEST_VEHICLE.items()}
    return vehicle, AT * factors[2]


def _homogeneous() -> float:
    """Eqs 6 to 8: in other units the yaw rate is the same quantity."""
    factors = (2.2046, 3.2808, 1 / 60)
    vehicle, t = _scaled(factors)
    one, other = step_response(printed.TEST_VEHICLE, AT)[0], step_response(vehicle, t)[0]
    return abs(other / (one * np.prod(np.power(factors, YAW_RATE))) - 1)


def _rows() -> float:
    """Eqs 9, 13, 14 and 16, with time among the arguments and the sign of its row put right."""
    _, S = step_response(printed.TEST_VEHICLE, AT)
    return float(np.abs(row_sums(S) - YAW_RATE).max())


def _cube() -> float:
    S = sp.Symbol("S", positive=True)
    return float(abs(euler(S**3, (S,)) - 3))


def _cube_scaled() -> float:
    """Eqs 10 and 11: a side A times as long makes A³ the volume."""
    S, A = sp.symbols("S A", positive=True)
    return float(abs(sp.simplify((S**3).subs(S, A * S) / S**3 - A**3)))


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
    """Eq 20 with k = π4/π3 is eq 19."""
    return float(sum(e != 0 for e in transfer_19(False)))


_LQR = "similitude.simulation.lqr.path_matrices"
_BODE = "similitude.paper.bode."
_INVARIANCE = "similitude.paper.claims_invariance."
_BICYCLE = "similitude.systems.bicycle."
TABLE = (
    (1, "x' = A x + B u, y = C x + D u", _LQR, _state_space),
    (2, "A and B of the bicycle in path-error coordinates", _LQR, _matrix_dimensions),
    (3, "x = [y, ẏ, ψ, ψ̇]", _LQR, _states),
    (4, "ψ̇/δ as a transfer function, and the parameters of the test vehicle", _BICYCLE + "BICYCLE", _eq_4),
    (5, "f(k x) = k² f(x) for 7 x1² + 2 x2²", _INVARIANCE + "euler", _eq_5),
    (6, "y = f(x1 … xn)", _BODE + "step_response", _homogeneous),
    (7, "K y = f(K1 x1 … Kn xn)", _BODE + "step_response", _homogeneous),
    (8, "K = Aᵃ Bᵇ Cᶜ, Ki likewise: exponents of the units", _BODE + "dimension_row", _homogeneous),
    (9, "a y = Σ ai xi ∂y/∂xi, one row a unit", _BODE + "row_sums", _rows),
    (10, "V = S³", _INVARIANCE + "euler", _cube),
    (11, "A³ V = (A S)³", _INVARIANCE + "euler", _cube_scaled),
    (12, "3 V = S dV/dS", _INVARIANCE + "euler", _cube),
    (13, "the three rows of the yaw rate: 0, 0, −1, time included", _INVARIANCE + "rows_of_13", _rows),
    (14, "the same as a matrix, over y", _BODE + "row_sums", _rows),
    (15, "S = (∂G/∂a)(a/G), Bode's sensitivity", _BODE + "step_response", _bode, 1e-7),
    (16, "d = D S", _BODE + "row_sums", _rows),
    (
        17,
        "π1 = a/L, π2 = b/L, π3 = Caf L/(m U²), π4 = Car L/(m U²), π5 = Iz/(m L²)",
        _BICYCLE + "bicycle_groups",
        _groups,
    ),
    (18, "averages of over 700 vehicles", "similitude.estimators.paper_design.PAPER_GROUPS", _averages),
    (19, "r*/δ in the groups and dimensionless s", _BICYCLE + "bicycle_groups", _rewritten),
    (20, "the same with π4 = k π3", "similitude.estimators.paper_model.regression", _slope_taken_out),
)
