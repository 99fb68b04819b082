"""Handling numbers a chassis engineer asks for, from the unknowns and their joint covariance.

Invariant: each number is a function of (K, pi1, eta, rho), speed and mass alone, and its interval holds
95 % of the cars drawn from the joint normal of the coordinates, so an interval need not be symmetric;
where it reaches cars that do not have the number, its end is the value that the number tends to there.

Definitions and order as in ISO 4138 (steady state) and ISO 7401 (yaw mode), at the road wheel:

    understeer gradient   L (1 - pi1)(1 - 1/eta)/K        = (m/L)(b/Caf - a/Car)
    characteristic speed  sqrt(L/gradient)                 critical speed  sqrt(-L/gradient)
    m  mass [kg];  Iz = rho pi1 (1 - pi1) m L^2 [kg m^2];  Caf = K m/L,  Car = eta pi1/(1 - pi1) Caf [N/rad]
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from similitude.units import Uncertain

GRAVITY = 9.80665  # m/s^2
DEGREE = np.pi / 180
DRAWS = 2000  # a 2.5 % quantile of a normal is then good to 0.06 sd
SEED = 4138
ORDER = ("K", "pi1", "eta", "rho")
Cars = Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True)
class _Number:
    """Unit, meaning and function of the cars' unknowns of one number."""

    unit: str
    meaning: str
    of: Callable[[Cars], NDArray[np.float64]]


def understeer_gradient(L: float, K, pi1, eta, rho=None):
    """Steer angle per lateral acceleration beyond L/R [rad per m/s^2], of one car or of many (n,)."""
    return L * (1 - pi1) * (1 - 1 / eta) / K


def handling(
    unknowns: Mapping[str, float],
    covariance: NDArray[np.float64],
    *,
    L: float,
    U: float,
    mass: Uncertain | None = None,
) -> dict[str, dict[str, float | str]]:
    """Understeer gradient, characteristic or critical speed, gains, yaw mode, axles and yaw inertia.

    Parameters
    ----------
    unknowns : K [m^2/s^2], pi1, eta, rho [-].
    covariance : (4, 4) of ln K, pi1, ln eta, ln rho.
    L, U : wheelbase [m] and speed [m/s]; at U = 0 or below there are no gains and no yaw mode.
    mass : of the vehicle [kg]; without one there are no axle stiffnesses and no yaw inertia.

    Returns
    -------
    dict    name -> value, std, lo, hi, unit, meaning, in the order of a test report; numbers this car
            does not have are left out. ``std`` is half the middle 68 %; an end of an interval that
            reaches cars without the number may be infinite.
    """
    here = {name: np.array([float(unknowns[name])]) for name in ORDER}
    drawn = _drawn(here, covariance)
    mean_mass, spread = (mass.value, (mass.sd or 0.0) / mass.value) if mass else (None, 0.0)
    here["m"] = np.array([mean_mass or np.nan])
    drawn["m"] = here["m"] * np.exp(spread * _standard_normal()[:, 4])
    found = {}
    for name, number in _numbers(L, U, understeer_gradient(L, **unknowns), mean_mass is not None).items():
        value = float(number.of(here)[0])
        if not np.isfinite(value) or (name == "yaw_frequency" and value == 0):
            continue
        lo, low, high, hi = _quantiles(number.of(drawn), (0.025, 0.1587, 0.8413, 0.975))
        found[name] = {
            "value": value,
            "std": 0.5 * (high - low),
            "lo": lo,
            "hi": hi,
            "unit": number.unit,
            "meaning": number.meaning,
        }
    return found


@lru_cache
def _standard_normal() -> NDArray[np.float64]:
    """Draws (DRAWS, 5), each with its mirror image, so that their mean is the estimate."""
    half = np.random.default_rng(SEED).standard_normal((DRAWS // 2, 5))
    return np.concatenate([half, -half])


def _drawn(here: Cars, covariance: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    values, vectors = np.linalg.eigh(covariance)
    away = _standard_normal()[:, :4] @ (vectors * np.sqrt(np.maximum(values, 0.0))).T
    moved = dict(zip(ORDER, away.T, strict=True))
    pi1 = np.clip(here["pi1"] + moved["pi1"], 0.01, 0.99)
    return {name: pi1 if name == "pi1" else here[name] * np.exp(moved[name]) for name in ORDER}


def _quantiles(values: NDArray[np.float64], shares: tuple[float, ...]) -> list[float]:
    """Quantiles of values some of which may be infinite; each is one of them."""
    ordered = np.sort(values)
    return [float(ordered[round(share * (len(ordered) - 1))]) for share in shares]


def _numbers(L: float, U: float, gradient: float, has_mass: bool) -> dict[str, _Number]:
    """Each number this car can have, in the order of a test report."""
    numbers = {
        "understeer_gradient": _Number(
            "deg/g",
            "road-wheel steer per lateral acceleration beyond L/R",
            lambda p: GRAVITY / DEGREE * _gradient(L, p),
        )
    }
    if gradient > 0:
        numbers["characteristic_speed"] = _Number(
            "m/s", "speed of the highest yaw-rate gain", lambda p: _special_speed(L, p, 1)
        )
    if gradient < 0:
        numbers["critical_speed"] = _Number(
            "m/s", "speed beyond which the car is unstable", lambda p: _special_speed(L, p, -1)
        )
    return numbers | (_at_speed(L, U) if U > 0 else {}) | (_with_mass(L) if has_mass else {})


def _at_speed(L: float, U: float) -> dict[str, _Number]:
    at = f"at {U:.1f} m/s"
    gain = f"steady, per road-wheel steer, {at}"
    g_per_degree = U * U / L * DEGREE / GRAVITY
    return {
        "yaw_rate_gain": _Number("1/s", gain, lambda p: U / L * _gain(L, U, p)),
        "lateral_gain": _Number("g/deg", f"acceleration, {gain}", lambda p: g_per_degree * _gain(L, U, p)),
        "sideslip_gain": _Number("-", gain, lambda p: _sideslip_gain(L, U, p)),
        "yaw_frequency": _Number("Hz", f"natural, {at}", lambda p: _yaw_mode(L, U, p)[0]),
        "yaw_damping": _Number("-", f"damping ratio {at}", lambda p: _yaw_mode(L, U, p)[1]),
    }


def _with_mass(L: float) -> dict[str, _Number]:
    def front(p: Cars) -> NDArray[np.float64]:
        return p["K"] * p["m"] / L

    def rear(p: Cars) -> NDArray[np.float64]:
        return front(p) * p["eta"] * p["pi1"] / (1 - p["pi1"])

    def inertia(p: Cars) -> NDArray[np.float64]:
        return p["rho"] * p["pi1"] * (1 - p["pi1"]) * p["m"] * L * L

    return {
        "front_stiffness": _Number("N/deg", "both front tyres", lambda p: front(p) * DEGREE),
        "rear_stiffness": _Number("N/deg", "both rear tyres", lambda p: rear(p) * DEGREE),
        "Caf": _Number("N/rad", "the same, front", front),
        "Car": _Number("N/rad", "the same, rear", rear),
        "yaw_inertia": _Number("kg m^2", "Iz about the centre of gravity", inertia),
    }


def _gradient(L: float, p: Cars) -> NDArray[np.float64]:
    return understeer_gradient(L, p["K"], p["pi1"], p["eta"])


def _special_speed(L: float, p: Cars, sign: int) -> NDArray[np.float64]:
    """Characteristic (1) or critical (-1) speed; infinite for cars of the other kind."""
    with np.errstate(divide="ignore"):
        return np.sqrt(L / np.maximum(sign * _gradient(L, p), 0.0))


def _gain(L: float, U: float, p: Cars) -> NDArray[np.float64]:
    """Steady gain against that of a neutral car; infinite where no steady state is ever reached."""
    with np.errstate(divide="ignore"):
        return 1 / np.maximum(1 + _gradient(L, p) * U * U / L, 0.0)


def _sideslip_gain(L: float, U: float, p: Cars) -> NDArray[np.float64]:
    p2 = 1 - p["pi1"]
    rear = U * U * p2 / (p["K"] * p["eta"])  # rear slip angle per r* at steady state
    return (p2 - rear) * _gain(L, U, p)


def _yaw_mode(L: float, U: float, p: Cars) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Natural frequency [Hz] and damping (paper, eq 19); an unstable car tends to none and to infinite."""
    pi1, p2 = p["pi1"], 1 - p["pi1"]
    pi3 = p["K"] / U**2
    pi4, pi5 = pi3 * p["eta"] * pi1 / p2, p["rho"] * pi1 * p2
    natural = np.sqrt(np.maximum((pi3 * pi4 - pi1 * pi3 + p2 * pi4) / pi5, 0.0))
    with np.errstate(divide="ignore"):
        damping = (pi3 + pi4 + (pi1**2 * pi3 + p2**2 * pi4) / pi5) / (2 * natural)
    return np.where(natural > 0, natural, 0.0) * U / L / (2 * np.pi), damping
