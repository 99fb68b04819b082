"""Handling numbers a chassis engineer asks for, from the unknowns and their joint covariance.

Invariant: each number is a function of (K, pi1, eta, rho) and speed alone; its sd is first order.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

GRAVITY = 9.80665  # m/s^2
Z95 = 1.96


def understeer_gradient(L: float, K: float, pi1: float, eta: float, rho: float) -> float:
    """Steer angle per lateral acceleration beyond L/R, rad per m/s^2: L (1 - pi1)(1 - 1/eta)/K.

    With the axles' stiffness that is (m/L)(b/Caf - a/Car).
    """
    return L * (1 - pi1) * (1 - 1 / eta) / K


def handling(
    unknowns: dict[str, float], covariance: NDArray[np.float64], *, L: float, U: float
) -> dict[str, dict[str, float | str]]:
    """Understeer gradient, characteristic or critical speed, gains and yaw mode at speed U.

    Parameters
    ----------
    unknowns : K [m^2/s^2], pi1, eta, rho [-].
    covariance : (4, 4) of ln K, pi1, ln eta, ln rho.
    L, U : wheelbase [m] and speed [m/s]; at U = 0 or below there are no gains and no yaw mode.

    Returns
    -------
    dict    name -> value, std, lo, hi, unit, meaning; numbers that do not exist are left out.
    """
    result = {}
    for name, unit, meaning, f in _numbers(L, U, understeer_gradient(L, **unknowns)):
        value, std = _propagate(f, unknowns, covariance)
        if np.isfinite(value) and np.isfinite(std):
            result[name] = {
                "value": value,
                "std": std,
                "lo": value - Z95 * std,
                "hi": value + Z95 * std,
                "unit": unit,
                "meaning": meaning,
            }
    return result


def _numbers(L: float, U: float, gradient: float) -> list[tuple[str, str, str, Callable[..., float]]]:
    """Name, unit, meaning and function of the unknowns, of each number this car can have."""
    per_g = GRAVITY * 180 / np.pi
    steer = "road-wheel steer"
    special = {
        1.0: ("characteristic_speed", "m/s", "speed of the highest yaw-rate gain"),
        -1.0: ("critical_speed", "m/s", "speed beyond which the car is unstable"),
    }
    sign = float(np.sign(gradient))
    return [
        (
            "understeer_gradient",
            "deg/g",
            f"{steer} per lateral acceleration beyond L/R",
            lambda **p: per_g * understeer_gradient(L, **p),
        ),
        *([(*special[sign], _special_speed(L, sign))] if sign else []),
        (
            "yaw_rate_gain",
            "1/s",
            f"steady yaw rate per {steer} at {U:.1f} m/s",
            lambda **p: U / L * _against_neutral(L, U, **p),
        ),
        (
            "sideslip_gain",
            "-",
            f"steady sideslip per {steer} at {U:.1f} m/s",
            lambda **p: _sideslip_gain(L, U, **p),
        ),
        (
            "yaw_frequency",
            "Hz",
            f"natural frequency of the yaw mode at {U:.1f} m/s",
            lambda **p: _yaw_mode(L, U, **p)[0],
        ),
        (
            "yaw_damping",
            "-",
            f"damping ratio of the yaw mode at {U:.1f} m/s",
            lambda **p: _yaw_mode(L, U, **p)[1],
        ),
    ]


def _special_speed(L: float, sign: float) -> Callable[..., float]:
    def speed(**p: float) -> float:
        inside = sign * L / understeer_gradient(L, **p)
        return float(np.sqrt(inside)) if inside > 0 else np.nan

    return speed


def _against_neutral(L: float, U: float, **p: float) -> float:
    """Steady gain against that of a neutral car; NaN where no steady state is ever reached."""
    demand = 1 + understeer_gradient(L, **p) * U * U / L
    return 1 / demand if demand > 0 and U > 0 else np.nan


def _sideslip_gain(L: float, U: float, K: float, pi1: float, eta: float, rho: float) -> float:
    p2 = 1 - pi1
    rear = U * U * p2 / (K * eta)  # rear slip angle per r* at steady state
    return (p2 - rear) * _against_neutral(L, U, K=K, pi1=pi1, eta=eta, rho=rho)


def _yaw_mode(L: float, U: float, K: float, pi1: float, eta: float, rho: float) -> tuple[float, float]:
    """Natural frequency [Hz] and damping of the characteristic polynomial (paper, eq 19)."""
    if U <= 0:
        return np.nan, np.nan
    p2 = 1 - pi1
    pi3 = K / U**2
    pi4, pi5 = pi3 * eta * pi1 / p2, rho * pi1 * p2
    stiffness = (pi3 * pi4 - pi1 * pi3 + p2 * pi4) / pi5
    if stiffness <= 0:
        return np.nan, np.nan
    natural = np.sqrt(stiffness)
    damping = (pi3 + pi4 + (pi1**2 * pi3 + p2**2 * pi4) / pi5) / (2 * natural)
    return natural * U / L / (2 * np.pi), damping


def _propagate(
    f: Callable[..., float], unknowns: dict[str, float], covariance: NDArray[np.float64]
) -> tuple[float, float]:
    """Value and first-order sd, by central differences in the coordinates."""
    value = float(f(**unknowns))
    slope = np.zeros(len(unknowns))
    for i, name in enumerate(unknowns):
        step = 1e-4
        sides = []
        for sign in (1, -1):
            moved = dict(unknowns)
            moved[name] = moved[name] + sign * step if name == "pi1" else moved[name] * np.exp(sign * step)
            sides.append(float(f(**moved)))
        slope[i] = (sides[0] - sides[1]) / (2 * step)
    return value, float(np.sqrt(max(slope @ covariance @ slope, 0.0)))
