"""A drive of the benchmark made without its simulator: the exact response of a linear car."""

import numpy as np

from similitude.benchmark.cells import CHANGE_AT
from similitude.benchmark.drives import BEHIND, BEHIND_SD, NOISE, Drive, Truth
from similitude.simulate import bicycle_response
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

L, K = 2.7, 150.0
GROUPS = {"pi1": 0.44, "eta": 1.4, "rho": 1.02}


def linear_drive(*, factor=0.5, noise=NOISE, amplitude=0.015, seed=0):
    """A slalom of 80 s at 100 Hz and 22 m/s; K times ``factor`` at 50 s."""
    t = np.arange(8000) / 100
    delta = amplitude * np.sin(np.pi * t) * np.minimum(t, 1)
    stiffness = np.where(t < CHANGE_AT, K, K * factor)
    r, beta = bicycle_response(t, delta, 22.0, L=L, K=stiffness, **GROUPS)
    ay = 22.0 * np.gradient(beta, t) + 22.0 * r + (GROUPS["pi1"] * L - BEHIND) * np.gradient(r, t)
    r = r + noise * np.random.default_rng(seed).standard_normal(t.size)
    ay = ay + 0.1 * np.random.default_rng(seed + 1).standard_normal(t.size)
    car = Vehicle(
        "test",
        L=Uncertain(L, None, "m"),
        yaw_rate_noise=Uncertain(NOISE, None, "rad/s"),
        accelerometer=Uncertain(BEHIND, BEHIND_SD, "m"),
    )
    return Drive(t, delta, r, np.full(t.size, 22.0), ay, car), Truth(stiffness, delta, GROUPS)
