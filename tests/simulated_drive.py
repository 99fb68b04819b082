"""Logs of simulated cars whose truth is known, for tests of everything that reads a Log."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.signal import butter, sosfilt

from similitude.log import Log
from similitude.simulate import bicycle_response
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

CAR = {"L": 2.65, "K": 110.0, "pi1": 0.4431, "eta": 1.42, "rho": 1.017}
NOISE = 0.0026  # rad/s: 0.15 deg/s
FINE = 1000  # Hz of the plant; a log keeps every n-th row


def metres(value, sd=None):
    """A length as a vehicle file gives it."""
    return Uncertain(value, sd, "m")


def vehicle(**more):
    """A passenger car of which nothing but the wheelbase is known."""
    return Vehicle("test car", L=metres(CAR["L"]), **more)


def wandering_steer(seconds, rms, *, band=(0.15, 3.0), seed=0):
    """Band-limited random steer (n,) [rad] at `FINE` Hz."""
    rng = np.random.default_rng(seed)
    sos = butter(2, band, "bandpass", fs=FINE, output="sos")
    steer = sosfilt(sos, rng.standard_normal(int(seconds * FINE) + 5000))[5000:]
    return steer * rms / steer.std()


def drive(
    *, seconds=30.0, rms=0.006, U=25.0, rate=100, lag=0.0, noise=NOISE, band=(0.15, 3.0), seed=0, **car
):
    """A Log of a car driven with random steer; the steer acts ``lag`` later than it is logged.

    U is a number or a function of time [s]; ``car`` replaces entries of `CAR`.
    """
    steer = wandering_steer(seconds, rms, band=band, seed=seed)
    t = np.arange(steer.size) / FINE
    late = round(lag * FINE)
    acting = np.concatenate([np.zeros(late), steer[: steer.size - late]])
    speed = np.broadcast_to(U(t) if callable(U) else U, t.shape).astype(float)
    every = FINE // rate
    if callable(U):
        yaw = yaw_rate(acting, speed, 1 / FINE, **{**CAR, **car})[::every]
    else:
        yaw = bicycle_response(t, acting, speed, **{**CAR, **car})[0][::every]
    rng = np.random.default_rng(seed + 1000)
    return log_of(t[::every], steer[::every], yaw + noise * rng.standard_normal(yaw.size), speed[::every])


def yaw_rate(steer, speed, dt, *, L, K, pi1, eta, rho):
    """Yaw rate (n,) of the bicycle with 1 kg, midpoint rule, the speed changing as it does."""
    a = pi1 * L
    b, front = L - a, K / L
    rear, inertia = front * eta * a / b, rho * a * b
    v = r = 0.0
    yaw = []

    def rates(v, r, d, U):
        at_front, at_rear = front * (d - (v + a * r) / U), -rear * (v - b * r) / U
        return at_front + at_rear - U * r, (a * at_front - b * at_rear) / inertia

    for d, U in zip(steer.tolist(), speed.tolist(), strict=True):
        yaw.append(r)
        dv, dr = rates(v, r, d, U)
        dv, dr = rates(v + dt / 2 * dv, r + dt / 2 * dr, d, U)
        v, r = v + dt * dv, r + dt * dr
    return np.array(yaw)


def log_of(t, delta, r, U):
    """A Log of arrays in SI units, as if it had been read from a file."""
    columns = (np.asarray(x, dtype=float).copy() for x in (t, delta, r, U))
    t, delta, r, U = columns
    return Log("drive", Path("drive.csv"), t, delta, r, U, None, {})


def spoilt(log, **cells):
    """The log with the named columns NaN at the given rows."""
    changed = {}
    for name, rows in cells.items():
        changed[name] = getattr(log, name).copy()
        changed[name][rows] = np.nan
    return replace(log, **changed)
