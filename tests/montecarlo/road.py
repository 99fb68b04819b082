"""Drives with what a road does to a car: speed changes, kerbs, gusts, cross wind, imperfect sensors.

Cars as in the reference experiment; 100 Hz. Kinds of driving: ``highway`` steer 2-6 mrad rms in 0.15-1 Hz,
``slalom`` 10-30 mrad in 0.3-0.8 Hz at 10-20 m/s, ``straight`` 0.1-0.4 mrad, ``mixed`` all three in
stretches of a minute. Lateral acceleration stays in the linear range.
"""

from dataclasses import dataclass

import numpy as np
from scipy.signal import butter, sosfilt

from .experiment import (
    K_RATIO,
    LN_K_RATIO_SD,
    LN_K_SD,
    LN_PI5_SD,
    NOISE,
    PI1,
    PI1_SD,
    PI5,
    RATE,
    STEER_STEP,
    Fleet,
    K,
)

KINDS = ("highway", "slalom", "straight", "mixed")
BANDS = {"highway": (0.15, 1.0), "slalom": (0.3, 0.8), "straight": (0.15, 1.0)}  # Hz
STEER = {"highway": (2e-3, 6e-3), "slalom": (10e-3, 30e-3), "straight": (1e-4, 4e-4)}  # rad rms
SPEED = {"highway": (18.0, 36.0), "slalom": (10.0, 20.0), "straight": (18.0, 36.0), "mixed": (14.0, 26.0)}
LINEAR = 2.5  # m/s^2: no drive asks more of its tyres


@dataclass(frozen=True)
class Installation:
    """What is wrong with the sensors and the road that nobody told the filter."""

    scale: float = 0.0  # of the steer angle, either way
    lag: float = 0.0  # s
    offset: float = 0.0  # rad, sd
    bias: float = 0.0  # rad/s, sd
    wander: float = 0.0  # rad, sd of the slow disturbance as an equivalent steer
    share: float = 0.0  # of the steer that is disturbance


GOOD = Installation(offset=2e-3, bias=1e-3, wander=0.1e-3)
NUISANCE = Installation(scale=0.03, lag=0.030, offset=0.010, bias=0.003, wander=0.7e-3, share=0.04)


def road(
    seed, *, cars, kind, duration=600.0, installation=GOOD, events=True, changes=(), lateral=None,
):  # fmt: skip
    """Drive cars along a road.

    ``changes``: (time [s], factor of K) pairs. ``lateral`` [m/s^2]: rms of the lateral acceleration before
    the first change, in place of the kind's steer. Returns a Fleet whose U is (cars, n).
    """
    rng = np.random.default_rng(seed)
    n = int(duration * RATE)
    t = np.arange(n) / RATE
    L = rng.uniform(2.3, 3.2, cars)
    pi1 = rng.normal(PI1, PI1_SD, cars)
    k = K_RATIO * np.exp(rng.normal(0, LN_K_RATIO_SD, cars))
    pi5 = PI5 * np.exp(rng.normal(0, LN_PI5_SD, cars))
    stiffness = np.repeat(K * np.exp(rng.normal(0, LN_K_SD, cars))[:, None], n, axis=1)
    for at, factor in changes:
        stiffness[:, t >= at] *= factor
    groups = {"pi1": pi1, "eta": k * (1 - pi1) / pi1, "rho": pi5 / (pi1 * (1 - pi1))}
    U = _speed(rng, cars, t, kind) if events else np.repeat(rng.uniform(*SPEED[kind], cars)[:, None], n, 1)
    steer = _steer(rng, cars, t, kind)
    car = (U, L, stiffness, groups)
    sideways = _sideways(steer, *car)
    before = t < (changes[0][0] if changes else duration)
    if lateral is not None:
        steer *= (lateral / np.sqrt(np.mean(sideways[:, before] ** 2, axis=1)))[:, None]
    else:
        steer *= np.minimum(1.0, LINEAR / np.quantile(np.abs(sideways), 0.999, axis=1))[:, None]
    r = _yaw_rate(_acting(rng, steer, t, installation, events), *_kerbs(rng, cars, t, events), *car)
    r += NOISE * rng.standard_normal(r.shape) + installation.bias * rng.standard_normal((cars, 1))
    steer = steer + installation.offset * rng.standard_normal((cars, 1))
    return Fleet(t, np.round(steer / STEER_STEP) * STEER_STEP, r, stiffness, L, U, groups)


def _steer(rng, cars, t, kind):
    if kind != "mixed":
        return _band(rng, cars, len(t), kind)
    three = {name: _band(rng, cars, len(t), name) for name in BANDS}
    minute = (t // 60).astype(int)
    choice = rng.integers(0, 3, (cars, minute[-1] + 1))[:, minute]
    return np.choose(choice, [three["highway"], three["slalom"] * 0.5, three["straight"]])


def _band(rng, cars, n, kind):
    sos = butter(2, BANDS[kind], "bandpass", fs=RATE, output="sos")
    steer = sosfilt(sos, rng.standard_normal((cars, n + 2000)))[:, 2000:]
    return steer * rng.uniform(*STEER[kind], (cars, 1)) / steer.std(axis=1, keepdims=True)


def _speed(rng, cars, t, kind):
    """Cruising that wanders by a tenth, and once or twice a minute a stop for the lights ahead."""
    mean = rng.uniform(*SPEED[kind], (cars, 1))
    wander = sosfilt(butter(1, 0.02, fs=RATE, output="sos"), rng.standard_normal((cars, len(t))))
    U = mean * (1 + 0.1 * wander / wander.std(axis=1, keepdims=True))
    for i in range(cars):
        for at in rng.uniform(20, t[-1], rng.poisson(t[-1] / 60)):
            depth, brake, back = rng.uniform(0.1, 0.6), rng.uniform(1.5, 4.0), rng.uniform(5, 20)
            dip = np.interp(t, [at, at + brake, at + brake + back], [0, depth, 0])
            U[i] *= 1 - dip
    return np.maximum(U, 4.0)


def _acting(rng, steer, t, installation, events):
    """Steer as it acts, with everything that pushes like a steer."""
    cars, n = steer.shape
    late = round(installation.lag * RATE)
    acting = np.concatenate([np.zeros((cars, late)), steer[:, : n - late]], axis=1)
    acting = acting * (1 + installation.scale * rng.choice([-1, 1], (cars, 1)))
    slow = sosfilt(butter(1, 0.15, fs=RATE, output="sos"), rng.standard_normal((2, cars, n + 3000)))
    slow = slow[:, :, 3000:] / slow[:, :, 3000:].std(axis=2, keepdims=True)
    size = np.sqrt(sosfilt(butter(1, 0.3, fs=RATE, output="sos"), steer**2).clip(0))
    acting += installation.wander * slow[0] + installation.share * size * slow[1]
    if events:
        for i in range(cars):
            for at in rng.uniform(5, t[-1], rng.poisson(t[-1] / 30)):
                length = rng.uniform(0.8, 3.0)
                shape = np.clip((t - at) / length, 0, 1)
                acting[i] += (
                    rng.choice([-1, 1]) * np.exp(rng.uniform(*np.log([3e-4, 4e-3]))) * np.sin(np.pi * shape)
                )
    return acting


def _kerbs(rng, cars, t, events):
    """Lateral [m/s^2] and yaw [rad/s^2] acceleration of kerbs and potholes."""
    a, q = np.zeros((cars, len(t))), np.zeros((cars, len(t)))
    if events:
        for i in range(cars):
            for at in rng.uniform(5, t[-1], rng.poisson(t[-1] / 20)):
                length, side = rng.uniform(0.03, 0.15), rng.choice([-1, 1])
                here = (t >= at) & (t < at + length)
                jump = side * np.exp(rng.uniform(*np.log([0.2, 2.0])))
                q[i, here] += np.deg2rad(jump) / length
                a[i, here] += side * rng.uniform(0, 0.2) / length
    return a, q


def _sideways(steer, U, L, stiffness, groups):
    zero = np.zeros_like(steer)
    return U * _yaw_rate(steer, zero, zero, U, L, stiffness, groups)


def _yaw_rate(steer, a, q, U, L, stiffness, groups):
    """Yaw rate (cars, n) by the classical Runge-Kutta step; a, q are held over a sample."""
    p1, eta, rho = groups["pi1"], groups["eta"], groups["rho"]
    A, B, gyration = p1 * L, (1 - p1) * L, rho * p1 * (1 - p1) * L * L
    x = np.zeros((2, steer.shape[0]))
    r = np.zeros_like(steer)
    h = 1 / RATE
    columns = [np.ascontiguousarray(z.T) for z in (steer, a, q, U, stiffness)]
    ratio = eta * p1 / (1 - p1)

    def rate(x, d, a, q, U, front):
        f = front * (d - (x[0] + A * x[1]) / U)
        g = front * ratio * (B * x[1] - x[0]) / U
        return np.array([f + g - U * x[1] + a, (A * f - B * g) / gyration + q])

    for i in range(steer.shape[1] - 1):
        d0, a0, q0, U0, K0 = (c[i] for c in columns)
        d1, U1 = columns[0][i + 1], columns[3][i + 1]
        front = K0 / L
        dm, Um = (d0 + d1) / 2, (U0 + U1) / 2
        k1 = rate(x, d0, a0, q0, U0, front)
        k2 = rate(x + h / 2 * k1, dm, a0, q0, Um, front)
        k3 = rate(x + h / 2 * k2, dm, a0, q0, Um, front)
        k4 = rate(x + h * k3, d1, a0, q0, U1, front)
        x = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        r[:, i + 1] = x[1]
    return r
