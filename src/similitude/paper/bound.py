"""The limit for any estimator of K on a drive: the posterior Cramér-Rao bound along the truth.

    J(t) = prior + Σ_{up to t} s sᵀ/σ²,   s = d r/d(ln K of each stretch, pi1, ln eta, ln rho, ln steer scale)

One unknown K for each stretch of constant stiffness, all with the population's prior; the bound knows when
the stiffness changes, though not to what, and no gusts: nobody can do better, and few as well.

References
----------
Tichavsky, Muravchik, Nehorai (1998), for a state that does not move; the prior of `vehicle_prior`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from similitude.filter_config import MEASURED_STEER_SD
from similitude.paper.drives import NOISE, Drive, prior_of
from similitude.simulate import bicycle_response

Array = NDArray[np.float64]
EVERY = 10  # rows that are taken together; a servo of 5 Hz moves little in 10 ms
STEP = 1e-4  # of a coordinate; central differences of an exact response


def bound(drive: Drive, changes: Sequence[float]) -> Array:
    """Least sd of ln K that an unbiased estimator can have, over the drive, (n,) [-].

    Parameters
    ----------
    drive : Drive
    changes : times at which the stiffness changes [s], increasing.
    """
    edges = [0.0, *changes, float(drive.t[-1]) + 1.0]
    t = drive.t[::EVERY]
    stretches = [(t >= a) & (t < b) for a, b in pairwise(edges)]
    s = _sensitivities(drive, stretches) / (NOISE / np.sqrt(EVERY))
    prior = prior_of(drive.scenario.name)
    p, q = len(stretches), len(prior.names) - 1
    J = np.zeros((p + q + 1, p + q + 1))
    J[:p, :p] = np.eye(p) / prior.covariance[0, 0]
    J[p : p + q, p : p + q] = np.linalg.inv(prior.covariance[1:, 1:])
    J[-1, -1] = 1 / MEASURED_STEER_SD**2
    sd, every = np.empty(t.size), 5  # rows between two inversions
    for first in range(0, t.size, every):
        rows = slice(first, first + every)
        J = J + s[rows].T @ s[rows]
        now = next(i for i, there in enumerate(stretches) if there[first])
        sd[rows] = np.sqrt(np.linalg.inv(J)[now, now])
    return np.repeat(sd, EVERY)[: drive.t.size]


def _sensitivities(drive: Drive, stretches: list[NDArray[np.bool_]]) -> Array:
    """d r/d(coordinate), (n/EVERY, coordinates) [rad/s], by differences about the true car."""
    groups = drive.scenario.vehicle.nominal().groups
    count = len(stretches) + 4
    cars = 2 * count
    thin = slice(None, None, EVERY)
    K = np.repeat(drive.K[None, thin], cars, axis=0)
    steer = np.repeat(drive.delta[None, thin], cars, axis=0)
    U = np.repeat(drive.U[None, thin], cars, axis=0)
    values = {name: np.full((cars, 1), groups[name]) for name in ("pi1", "eta", "rho")}
    for i in range(count):
        for row, sign in ((2 * i, 1), (2 * i + 1, -1)):
            factor = np.exp(sign * STEP)
            if i < len(stretches):
                K[row, stretches[i]] *= factor
            elif i == count - 1:
                steer[row] *= factor
            else:
                name = ("pi1", "eta", "rho")[i - len(stretches)]
                values[name][row] = (
                    values[name][row] + sign * STEP if name == "pi1" else values[name][row] * factor
                )
    r, _ = bicycle_response(drive.t[thin], steer, U, L=drive.L, K=K, **values)
    return ((r[0::2] - r[1::2]) / (2 * STEP)).T
