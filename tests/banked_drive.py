"""Cars on a banked, gusty road with an accelerometer aboard, whose truth is known.

The accelerometer's reading is kinematics, v' + U r less what the bank pulls, so that it shares no
formula with the model under test.
"""

from dataclasses import replace

import numpy as np
from scipy.signal import butter, sosfilt

from similitude.vehicle_file import Vehicle

from .simulated_drive import CAR, FINE, NOISE, log_of, metres, wandering_steer

BEHIND = 1.3  # m: the accelerometer behind the front axle
STEP = 5  # rows of the fine grid from one row of a plant to the next: 200 Hz


def slow_noise(seconds, sd, corner, seed):
    """Wandering (n,) at `FINE` Hz, of that sd, with a corner frequency [Hz]."""
    rng = np.random.default_rng(seed)
    sos = butter(1, corner, fs=FINE, output="sos")
    ahead = int(3 * FINE / corner)
    x = sosfilt(sos, rng.standard_normal(int(seconds * FINE) + ahead))[ahead:]
    return sd * x / x.std()


def rates(v, r, steer, sideways, car, U):
    """v', r' [m/s^2, rad/s^2] of the linear bicycle, ``sideways`` pushing at the centre of gravity."""
    L, p1 = car["L"], car["pi1"]
    a, b = p1 * L, (1 - p1) * L
    front, rear = car["K"] / L, car["K"] / L * car["eta"] * p1 / (1 - p1)
    Ff, Fr = front * (steer - (v + a * r) / U), rear * (b * r - v) / U
    return Ff + Fr - U * r + sideways, (a * Ff - b * Fr) / (car["rho"] * a * b)


def banked_drive(*, seconds=60.0, rms=6e-3, U=25.0, bank=0.0, gust=0.0, seed=0, place=BEHIND, **car):
    """A Log with ``ay`` and the truth {"car", "bank"} behind it.

    bank, gust : sd of the road's bank and of the wind's push [m/s^2].
    """
    car = {**CAR, **car}
    steer = wandering_steer(seconds, rms, seed=seed)
    leaning, blowing = slow_noise(seconds, bank, 0.05, seed + 1), slow_noise(seconds, gust, 0.5, seed + 2)
    h, n = STEP / FINE, (steer.size - 1) // STEP + 1
    at = np.arange(n) * STEP
    v, r, accelerations = np.zeros(n), np.zeros(n), np.zeros((n, 2))
    push = leaning + blowing
    for i, k in enumerate(at):
        accelerations[i] = rates(v[i], r[i], steer[k], push[k], car, U)
        if i + 1 == n:
            break
        middle, end = k + STEP // 2, k + STEP
        v1, r1 = accelerations[i]
        v2, r2 = rates(v[i] + h / 2 * v1, r[i] + h / 2 * r1, steer[middle], push[middle], car, U)
        v3, r3 = rates(v[i] + h / 2 * v2, r[i] + h / 2 * r2, steer[middle], push[middle], car, U)
        v4, r4 = rates(v[i] + h * v3, r[i] + h * r3, steer[end], push[end], car, U)
        v[i + 1] = v[i] + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4)
        r[i + 1] = r[i] + h / 6 * (r1 + 2 * r2 + 2 * r3 + r4)
    ahead = car["pi1"] * car["L"] - place
    felt = accelerations[:, 0] + U * r - leaning[at] + ahead * accelerations[:, 1]
    rng = np.random.default_rng(seed + 1000)
    rows = np.arange(0, n, 2)  # 100 Hz
    yaw = r[rows] + NOISE * rng.standard_normal(rows.size)
    log = log_of(rows * h, steer[at[rows]], yaw, np.full(rows.size, float(U)))
    log = replace(log, ay=felt[rows] + 0.1 * rng.standard_normal(rows.size))
    return log, {"car": car, "bank": leaning[at[rows]]}


def without_ay(log):
    """The same log, the accelerometer taken out."""
    return replace(log, ay=None)


def with_place(sd=0.05, place=BEHIND):
    """A car of which wheelbase and the accelerometer's place are known."""
    return Vehicle("test car", L=metres(CAR["L"]), accelerometer=metres(place, sd))
