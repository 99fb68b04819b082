"""Equations 21 to 28: the z-transform, its lines, the regression and the recursion."""

from __future__ import annotations

import numpy as np
import sympy as sp

from similitude.estimators.paper_design import (
    PAPER_GROUPS,
    exact_coefficients,
    paper_config,
    slopes,
)
from similitude.estimators.paper_model import regression
from similitude.paper import printed
from similitude.paper.bode import sampled_transfer
from similitude.paper.claims_discrete import recursion
from similitude.program.library import shipped
from similitude.systems.bicycle import bicycle_reduction

PI3 = 0.3
STEPS = 600
U, L = printed.TEST_VEHICLE["U"], printed.WHEELBASE
AROUND = tuple(np.exp(1j * w) for w in (0.3, 0.9, 1.7, 2.9))  # z, rad a sample
SMALL_T = 1e-3
NO_FILTER = ((1.0, -2.0, 1.0, -2.0, 1.0),) * 2  # two poles on two zeros, twice


def _zero_order_hold() -> float:
    """Eq 21: the shipped coefficients against the sampled response of the dimensional model, at four z."""
    vehicle = printed.of_groups(printed.PI1, PI3, printed.SLOPE, printed.PI5)
    coefficients = exact_coefficients(PI3, printed.T, **PAPER_GROUPS)[0]
    return max(abs(_ratio(z, coefficients) / sampled_transfer(vehicle, z, printed.T)[0] - 1) for z in AROUND)


def _ratio(z: complex, coefficients: np.ndarray) -> complex:
    """(b1 z + b2)/(z² + a1 z + a2) of b1, b2, a1 + 2, a2 − 1."""
    b1, b2, a1, a2 = coefficients
    return (b1 * z + b2) / (z * z + (a1 - 2) * z + a2 + 1)


def _lines() -> float:
    """Eq 22 with its offsets outside: the slopes of the exact coefficients at small T."""
    T, d = 1e-4, 1e-3
    exact = exact_coefficients(np.array([PI3 - d, PI3 + d]), T, **PAPER_GROUPS)
    m1, m2 = slopes(T, **PAPER_GROUPS)
    return float(np.abs((exact[1] - exact[0]) / (2 * d) / [m1, -m1, m2, -m2] - 1).max())


def _with_its_lines() -> float:
    """Eq 23 with the regression's own m1, m2 is eq 21 to first order in T, over and under, at four z.

    Under, what T moves of (z − 1)² is compared. What is left falls as T does: extrapolated from T and
    T/2 it falls as T².
    """
    derived = regression(bicycle_reduction())
    at = {"pi1": printed.PI1, "pi4_slope": printed.SLOPE, "pi5": printed.PI5}
    m1, m2 = (
        float(e.subs({sp.Symbol(n, real=True): x for n, x in at.items()}))
        for e in (derived.numerator, derived.denominator)
    )
    z = np.array(AROUND)

    def off(T: float) -> np.ndarray:
        lines = PI3 * T * np.array([m1, -m1, m2, -m2])
        exact = exact_coefficients(PI3, T, **PAPER_GROUPS)[0]
        return np.array([(lines[i] * z + lines[i + 1]) / (exact[i] * z + exact[i + 1]) - 1 for i in (0, 2)])

    return float(np.abs(2 * off(SMALL_T / 2) - off(SMALL_T)).max())


def _answer_of_23() -> tuple[np.ndarray, np.ndarray]:
    """Steer [rad] and dimensionless yaw rate of eq 23 from rest, (STEPS,) each."""
    m1, m2 = slopes(printed.SAMPLE_TIME * U / L, **PAPER_GROUPS)
    d = 0.02 * np.sign(np.sin(np.arange(STEPS) / 40.0)) * (np.arange(STEPS) > 5)
    r = np.zeros(STEPS)
    for q in range(2, STEPS):
        r[q] = (2 - m2 * PI3) * r[q - 1] - (1 - m2 * PI3) * r[q - 2] + m1 * PI3 * (d[q - 1] - d[q - 2])
    return d, r


def _regression() -> float:
    """Eqs 24 to 27: the compiled estimator, filters passed through, finds the pi3 that made its rows."""
    library = shipped("bicycle_paper")
    d, r = _answer_of_23()
    config = paper_config(
        library,
        sample_time=printed.SAMPLE_TIME,
        L=L,
        speed=U,
        noise_std=1e-6,
        **PAPER_GROUPS,
        biquads=NO_FILTER,
        dead_zone=0.0,
        settle_samples=4,
        output_jump=100.0,
        P_start=1e12,
    )
    rows = np.column_stack([np.full(STEPS, printed.SAMPLE_TIME), d, np.full(STEPS, U), r * U / L])
    outputs, _ = library.run(config, library.start(config), rows)
    return abs(outputs[-1, library.index("output", "pi3")] / PI3 - 1)


def _stacked() -> float:
    """Eq 28: least squares over Φ is what the recursion comes to."""
    rng = np.random.default_rng(5)
    phi = rng.standard_normal(50)
    y = 0.7 * phi + 0.1 * rng.standard_normal(50)
    Phi = phi[:, None]
    batch = np.linalg.solve(Phi.T @ Phi, Phi.T @ y)[0]
    return abs(recursion(y, phi, forgetting=1.0)[0] / batch - 1)


_DESIGN = "similitude.estimators.paper_design."
_REGRESSION = "similitude.estimators.paper.paper_regression"
TABLE = (
    (21, "b1, b2, a1, a2 of the zero-order hold", _DESIGN + "exact_coefficients", _zero_order_hold),
    (22, "b1 = m1 π3, b2 = −b1, a1 = −2 + m2 π3, a2 = 1 − m2 π3", _DESIGN + "slopes", _lines, 1e-3),
    (
        23,
        "the same as a transfer function",
        "similitude.estimators.paper_model.regression",
        _with_its_lines,
        1e-5,
    ),
    (24, "as a difference equation", _REGRESSION, _regression, 1e-6),
    (25, "the terms without π3 to the left", _REGRESSION, _regression, 1e-6),
    (26, "y(q), θ and φ(q−1)", _REGRESSION, _regression, 1e-6),
    (27, "y = φᵀ θ", _REGRESSION, _regression, 1e-6),
    (
        28,
        "Φ, the regressors one below the other",
        "similitude.paper.claims_discrete.recursion",
        _stacked,
        1e-6,
    ),
)
