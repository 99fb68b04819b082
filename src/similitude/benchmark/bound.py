"""The limit for any estimator of K on a linear drive: the posterior Cramér-Rao bound along the truth.

    J(t) = prior + Σ_{up to t} s sᵀ/σ²
    s    = d r/d(ln K before and after the change, pi1, ln eta, ln rho, ln steer scale)

The bound knows when the stiffness changes, though not to what, and that it changes once; it knows steer lag,
offset, bias and that there is no disturbance. An estimator that must be ready for any change at any time
cannot reach it: its distance is the price of that, and of everything else.

References
----------
Tichavsky, Muravchik, Nehorai (1998), for a state that does not move; the prior of `vehicle_prior`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.benchmark.cells import CHANGE_AT
from similitude.benchmark.drives import Drive, Truth
from similitude.benchmark.scoring import JUDGED, Score
from similitude.filter_config import MEASURED_STEER_SD
from similitude.simulate import bicycle_response
from similitude.vehicle_prior import vehicle_prior

Array = NDArray[np.float64]
EVERY = 4  # rows that are taken together: 25 Hz hold a sweep to 3 Hz
STEP = 1e-4  # of a coordinate; central differences of an exact response
GROUPS = ("pi1", "eta", "rho")


def bound_score(drive: Drive, truth: Truth) -> Score:
    """Return the bound's rms over the judged windows as a score that has nothing else."""
    t = drive.t
    sd = least_sd(drive, truth)
    judged = ((t >= CHANGE_AT - JUDGED) & (t < CHANGE_AT)) | (t > t[-1] - JUDGED)
    return Score("", rms=float(np.sqrt(np.mean(sd[judged] ** 2))), rows=0)


def least_sd(drive: Drive, truth: Truth) -> Array:
    """Return the least sd of ln K that an unbiased estimator can have at each row, (n,) [-].

    Parameters
    ----------
    drive, truth : of a linear plant whose stiffness changes once
    """
    prior = vehicle_prior(drive.vehicle)
    s = _sensitivities(drive, truth) / (drive.noise / np.sqrt(EVERY))
    J = np.zeros((6, 6))
    J[:2, :2] = np.eye(2) / prior.covariance[0, 0]
    J[2:5, 2:5] = np.linalg.inv(prior.covariance[1:, 1:])
    J[5, 5] = 1 / MEASURED_STEER_SD**2
    information = J + np.cumsum(s[:, :, None] * s[:, None, :], axis=0)
    variance = np.diagonal(np.linalg.inv(information), axis1=1, axis2=2)
    after = drive.t[::EVERY] >= CHANGE_AT
    sd = np.sqrt(np.where(after, variance[:, 1], variance[:, 0]))
    return np.repeat(sd, EVERY)[: drive.t.size]


def _sensitivities(drive: Drive, truth: Truth) -> Array:
    """d r/d(coordinate), (n/EVERY, 6) [rad/s], by differences about the true car."""
    t = drive.t[::EVERY]
    n = t.size
    K = np.repeat(truth.K[None, ::EVERY], 12, axis=0)
    steer = np.repeat(truth.delta[None, ::EVERY], 12, axis=0)
    values = {name: np.full((12, 1), truth.groups[name]) for name in GROUPS}
    for row in range(12):
        at, by = row // 2, STEP * (1 - 2 * (row % 2))
        if at < 2:
            K[row, (t >= CHANGE_AT) == bool(at)] *= np.exp(by)
        elif at == 5:
            steer[row] *= np.exp(by)
        elif at == 2:
            values["pi1"][row] += by
        else:
            values[GROUPS[at - 2]][row] *= np.exp(by)
    U = np.broadcast_to(np.median(drive.U[np.isfinite(drive.U)]), (12, n))
    r, _ = bicycle_response(t, steer, U, L=drive.L, K=K, **values)
    return ((r[0::2] - r[1::2]) / (2 * STEP)).T
