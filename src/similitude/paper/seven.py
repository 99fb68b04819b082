"""Identifying the seven parameters at once, on the drive of Figure 5 with its stiffness left alone.

    ln p of m, Iz, U, a, b, Caf, Car;  J = Σ s sᵀ/σ²,  s = d r/d ln p   (Fisher information)

Invariant: one record, one noise, one fit method for seven parameters, four groups and one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from similitude.paper import printed
from similitude.paper.bode import PARAMETERS
from similitude.paper.drives import NOISE, square
from similitude.simulate import bicycle_response

Array = NDArray[np.float64]
EVERY = 10  # of the 1 kHz rows: 100 Hz are enough for a fit of 10 s
SECONDS = 10.0  # before the first change of stiffness
STEP = 1e-5  # of a logarithm
GROUPS = ("pi1", "K", "eta", "rho")  # coordinates of the four-parameter fit


@dataclass(frozen=True, eq=False)
class Record:
    """Steer (n,) [rad] and yaw rate with noise of 0.1 deg/s (n,) [rad/s] at times (n,) [s]."""

    t: Array
    delta: Array
    r: Array


@dataclass(frozen=True, eq=False)
class Fit:
    """Where a fit ended: parameters by name, and the rms of what it left over the noise [-]."""

    values: dict[str, float]
    misfit: float


@lru_cache
def record() -> Record:
    """Ten seconds of Figure 5's steer, and the linear car's answer with noise of a fixed seed."""
    drive = square()
    rows = drive.during(0.0, SECONDS)
    t, delta = drive.t[rows][::EVERY], drive.delta[rows][::EVERY]
    noise = NOISE * np.random.default_rng(7).standard_normal(t.size)
    return Record(t, delta, yaw_rate(t, delta, [printed.TEST_VEHICLE])[0] + noise)


def yaw_rate(t: Array, delta: Array, vehicles: Sequence[dict[str, float]]) -> Array:
    """Yaw rate of vehicles given by the seven parameters, (vehicles, n) [rad/s]."""
    p = {n: np.array([[v[n]] for v in vehicles]) for n in PARAMETERS}
    L = p["a"] + p["b"]
    shape = (len(vehicles), t.size)
    r, _ = bicycle_response(
        t,
        np.broadcast_to(delta, shape),
        p["U"],
        L=L,
        K=p["Caf"] * L / p["m"],
        pi1=p["a"] / L,
        eta=p["Car"] * p["b"] / (p["Caf"] * p["a"]),
        rho=p["Iz"] / (p["m"] * p["a"] * p["b"]),
    )
    return r


def of_coordinates(x: dict[str, float]) -> dict[str, float]:
    """The seven parameters from K, pi1, eta and rho; mass, wheelbase and speed are the paper's."""
    m, L, U = printed.TEST_VEHICLE["m"], printed.WHEELBASE, printed.TEST_VEHICLE["U"]
    a = x["pi1"] * L
    b = L - a
    Caf = x["K"] * m / L
    return {
        "m": m,
        "Iz": x["rho"] * m * a * b,
        "U": U,
        "a": a,
        "b": b,
        "Caf": Caf,
        "Car": x["eta"] * Caf * a / b,
    }


def slopes(model: Callable[[list[dict[str, float]]], Array], x: dict[str, float]) -> Array:
    """d(answer)/d ln x, (n, unknowns), by central differences."""
    both = [{**x, n: x[n] * np.exp(sign * STEP)} for n in x for sign in (1, -1)]
    r = model(both)
    return ((r[0::2] - r[1::2]) / (2 * STEP)).T


def information(x: dict[str, float], model: Callable) -> Array:
    """Fisher information of ln x on the record, (unknowns, unknowns) [-]."""
    s = slopes(model, x) / NOISE
    return s.T @ s


def seven_model(vehicles: list[dict[str, float]]) -> Array:
    """Answers of vehicles by their seven parameters on the record's steer."""
    return yaw_rate(record().t, record().delta, vehicles)


def four_model(points: list[dict[str, float]]) -> Array:
    """Answers of vehicles by K, pi1, eta and rho on the record's steer."""
    return seven_model([of_coordinates(x) for x in points])


def true_coordinates() -> dict[str, float]:
    """K, pi1, eta and rho of the paper's vehicle."""
    v = printed.TEST_VEHICLE
    L = v["a"] + v["b"]
    return {
        "pi1": v["a"] / L,
        "K": v["Caf"] * L / v["m"],
        "eta": v["Car"] * v["b"] / (v["Caf"] * v["a"]),
        "rho": v["Iz"] / (v["m"] * v["a"] * v["b"]),
    }


def rank(J: Array) -> int:
    """Number of directions of which there is information, beyond 1e-9 of the largest."""
    values = np.linalg.eigvalsh(J)
    return int(np.sum(values > 1e-9 * values.max()))


def fit_seven(start: dict[str, float]) -> Fit:
    """Least squares over the logarithms of the seven parameters (Levenberg and Marquardt).

    Parameters
    ----------
    start : the seven parameters to begin with.
    """
    data, x, damping = record(), dict(start), 1e-3
    left = data.r - seven_model([x])[0]
    for _ in range(60):
        s = slopes(seven_model, x)
        normal, right = s.T @ s, s.T @ left
        move = np.linalg.solve(normal + damping * np.diag(np.diag(normal)), right)
        tried = {
            n: v * float(np.exp(d)) for (n, v), d in zip(x.items(), np.clip(move, -0.5, 0.5), strict=True)
        }
        after = data.r - seven_model([tried])[0]
        if after @ after < left @ left:
            done = 1 - after @ after / (left @ left) < 1e-9
            x, left, damping = tried, after, damping / 5
            if done:
                break
        else:
            damping *= 10
            if damping > 1e9:
                break
    return Fit(x, float(np.sqrt(np.mean(left**2)) / NOISE))
