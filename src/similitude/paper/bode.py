"""Bode (logarithmic) sensitivities of the bicycle in four forms, by exact differentiation.

    S_i = d ln y/d ln x_i   [-]        D S = d: one row a unit, of mass, length and time

y is the yaw-rate step response r(t), the transfer function G(s), an entry of A or B (eq 2), or a
coefficient of the z-transform (eq 21). Derivatives of matrix exponentials are Fréchet derivatives.

References
----------
Brennan & Alleyne 2004, eqs 6-9 and eqs 13-16; with t, s or the sample time among the arguments, which
the paper leaves out.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

import numpy as np
import sympy as sp
from numpy.typing import NDArray
from scipy.linalg import expm_frechet

from similitude.systems.bicycle import BICYCLE
from similitude.units import parse_unit

PARAMETERS = ("m", "Iz", "U", "a", "b", "Caf", "Car")  # L = a + b is no argument of its own
BASES = ("mass", "length", "time")
EXTRA = {"t": "s", "s": "1/s", "Ts": "s"}  # the argument of each form that is no parameter
Sensitivities = dict[str, complex]


def dimension_row(name: str) -> tuple[float, float, float]:
    """Exponents of mass, length and time of an argument (eq 8), from the units of the model."""
    unit = EXTRA[name] if name in EXTRA else BICYCLE.quantity(name).unit
    exponents = parse_unit(unit).dimension.exponents
    return tuple(float(exponents.get(base, 0)) for base in BASES)


def row_sums(S: Mapping[str, complex], *, without: tuple[str, ...] = ()) -> NDArray[np.complex128]:
    """Left sides D S of the three rows of eq 16, (3,) [-].

    Parameters
    ----------
    S : sensitivity of each argument. without : arguments to leave out, as the paper does.
    """
    return sum(np.array(dimension_row(n)) * value for n, value in S.items() if n not in without)


@lru_cache
def _model() -> tuple:
    """A, B and their derivatives by each parameter as functions of the parameters."""
    x = sp.Matrix([q.symbol for q in BICYCLE.states])
    f = sp.Matrix([BICYCLE.rates[q.name] for q in BICYCLE.states]).subs(
        sp.Symbol("L", real=True), sp.Symbol("a", real=True) + sp.Symbol("b", real=True)
    )
    p = [sp.Symbol(n, real=True) for n in PARAMETERS]
    block = sp.zeros(3)
    block[:2, :2] = f.jacobian(x)
    block[:2, 2] = f.jacobian(sp.Matrix([q.symbol for q in BICYCLE.inputs]))
    return sp.lambdify(p, block), [sp.lambdify(p, block.diff(q)) for q in p], block, p


def _blocks(vehicle: Mapping[str, float]) -> tuple[NDArray, dict[str, NDArray]]:
    """[[A, B], [0, 0]] (3, 3) [per s] and its derivative by the logarithm of each parameter."""
    of, slopes, _, _ = _model()
    at = [vehicle[n] for n in PARAMETERS]
    derivatives = {n: vehicle[n] * np.array(d(*at), float) for n, d in zip(PARAMETERS, slopes, strict=True)}
    return np.array(of(*at), float), derivatives


def step_response(vehicle: Mapping[str, float], t: float) -> tuple[float, Sensitivities]:
    """Yaw rate after a unit step of the steer [1/s] and its sensitivities, time among them.

    Parameters
    ----------
    vehicle : `PARAMETERS` in SI units. t : time since the step [s].
    """
    block, slopes = _blocks(vehicle)
    moves = {n: expm_frechet(block * t, d * t)[1][1, 2] for n, d in slopes.items()}
    value, by_time = (x[1, 2] for x in expm_frechet(block * t, block * t))
    return float(value), {n: float(d / value) for n, d in {**moves, "t": by_time}.items()}


@lru_cache
def _transfer() -> tuple:
    """G(s) and its derivative by each argument, s last, as functions of all of them."""
    _, _, block, p = _model()
    z = sp.Symbol("s")
    G = sp.cancel(((z * sp.eye(2) - block[:2, :2]).inv() * block[:2, 2])[1])
    return sp.lambdify([*p, z], [G, *(G.diff(q) for q in [*p, z])])


def transfer_function(vehicle: Mapping[str, float], s: complex) -> tuple[complex, Sensitivities]:
    """G(s) of eq 4 and its sensitivities at a complex frequency s [rad/s], s among them."""
    at = {**{n: vehicle[n] for n in PARAMETERS}, "s": s}
    value, *slopes = _transfer()(*at.values())
    moves = {n: x * d / value for (n, x), d in zip(at.items(), slopes, strict=True)}
    return complex(value), {n: complex(d) for n, d in moves.items()}


def state_space_residual() -> tuple[int, sp.Expr]:
    """Number of entries of A and B of eq 2 that are not zero or one, and Σ |D S − d| over them, in symbols.

    An entry's d follows from the units of the two states (or state and input) that it joins.
    """
    m, Iz, U, a, b, Cf, Cr = p = [sp.Symbol(n, positive=True) for n in PARAMETERS]
    turn = b * Cr - a * Cf
    A = {  # row and column of the states y, y', psi, psi' -> entry, dimension of the entry
        (1, 1): (-(Cf + Cr) / (m * U), (0, 0, -1)),
        (1, 2): ((Cf + Cr) / m, (0, 1, -2)),
        (1, 3): (turn / (m * U), (0, 1, -1)),
        (3, 1): (turn / (Iz * U), (0, -1, -1)),
        (3, 2): (-turn / Iz, (0, 0, -2)),
        (3, 3): (-(a * a * Cf + b * b * Cr) / (Iz * U), (0, 0, -1)),
        (1, 4): (Cf / m, (0, 1, -2)),
        (3, 4): (a * Cf / Iz, (0, 0, -2)),
    }
    left = sp.Integer(0)
    rows = [dimension_row(n) for n in PARAMETERS]
    for entry, d in A.values():
        S = [q * entry.diff(q) / entry for q in p]
        for i in range(3):
            left += sp.Abs(
                sp.simplify(sum(sp.nsimplify(row[i]) * x for row, x in zip(rows, S, strict=True)) - d[i])
            )
    return len(A), left


def z_coefficients(vehicle: Mapping[str, float], Ts: float) -> dict[str, tuple[float, Sensitivities]]:
    """b1, b2, a1, a2 of eq 21 for the dimensional yaw rate, each with its sensitivities and Ts among them.

    Parameters
    ----------
    vehicle : `PARAMETERS` in SI units. Ts : sample time [s].
    """
    block, slopes = _blocks(vehicle)
    E = expm_frechet(block * Ts, block * Ts)
    moves = {n: expm_frechet(block * Ts, d * Ts)[1] for n, d in slopes.items()} | {"Ts": E[1]}
    values = _coefficients(E[0])
    return {
        name: (value, {n: _slope(E[0], move)[name] / value for n, move in moves.items()})
        for name, value in values.items()
    }


def _coefficients(E: NDArray) -> dict[str, float]:
    F, G = E[:2, :2], E[:2, 2]
    b2 = F[1, 0] * G[0] - F[0, 0] * G[1]
    return {"b1": G[1], "b2": b2, "a1": -np.trace(F), "a2": F[0, 0] * F[1, 1] - F[0, 1] * F[1, 0]}


def _slope(E: NDArray, d: NDArray) -> dict[str, float]:
    """The same four to first order in a change d of E."""
    F, G, f, g = E[:2, :2], E[:2, 2], d[:2, :2], d[:2, 2]
    b2 = f[1, 0] * G[0] + F[1, 0] * g[0] - f[0, 0] * G[1] - F[0, 0] * g[1]
    a2 = f[0, 0] * F[1, 1] + F[0, 0] * f[1, 1] - f[0, 1] * F[1, 0] - F[0, 1] * f[1, 0]
    return {"b1": g[1], "b2": b2, "a1": -np.trace(f), "a2": a2}
