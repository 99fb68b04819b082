"""The linear bicycle as a plant: exact response to a steer angle that is straight between samples.

Invariant: no integration error. Over each sample the state moves by the matrix exponential of the
model with its parameters held; the steer moves linearly from one sample to the next.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

TOGETHER = 2048  # samples or stretches, few enough to stay near the processor
TERMS, SMALL = 16, 0.5  # of the series of exp, which of a matrix that small ends below rounding


def bicycle_response(
    t: ArrayLike,
    delta: ArrayLike,
    U: ArrayLike,
    *,
    L: ArrayLike,
    K: ArrayLike,
    pi1: ArrayLike,
    eta: ArrayLike,
    rho: ArrayLike,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Yaw rate and sideslip of one car or many, from rest.

    Parameters
    ----------
    t : (n,) time [s], increasing.
    delta : (n,) or (cars, n) road-wheel steer angle [rad].
    U, K : scalar, (n,) or (cars, n): speed [m/s] and Caf L/m [m^2/s^2]; held over each sample.
    L, pi1, eta, rho : scalar or (cars, 1): wheelbase [m] and groups [-].

    Returns
    -------
    r, beta : yaw rate [rad/s] and sideslip [rad], of the shape of `delta`.

    References
    ----------
    Brennan & Alleyne 2004, eqs 2-4 and 17.
    """
    t = np.asarray(t, dtype=float)
    steer = np.atleast_2d(np.asarray(delta, dtype=float))
    shape = steer.shape
    speed, stiffness = (np.broadcast_to(np.atleast_1d(x).astype(float), shape) for x in (U, K))
    shaped = [np.broadcast_to(np.asarray(x, dtype=float).reshape(-1), shape[0]) for x in (L, pi1, eta, rho)]
    dt = np.diff(t)
    v, r = np.zeros(shape), np.zeros(shape)
    changes = (np.diff(speed, axis=1) != 0).any(axis=0) | (np.diff(stiffness, axis=1) != 0).any(axis=0)
    changes[:-1] |= np.abs(np.diff(dt)) > 1e-9
    begins = np.flatnonzero(np.append(True, changes)[: dt.size])
    ends = np.append(begins[1:], dt.size)
    for i in range(0, begins.size, TOGETHER):
        some = begins[i : i + TOGETHER]
        A, B = _matrices(speed[:, some].T, stiffness[:, some].T, *shaped)
        holds = zip(*_first_order_hold(A, B, dt[some]), strict=True)
        for begin, end, hold in zip(some.tolist(), ends[i : i + TOGETHER].tolist(), holds, strict=True):
            _move(v, r, steer, begin, end, hold)
    beta = v / np.maximum(speed, 1e-9)
    return (r[0], beta[0]) if np.ndim(delta) == 1 else (r, beta)


def _move(v: NDArray, r: NDArray, steer: NDArray, begin: int, end: int, hold: tuple) -> None:
    """Fill in both states (cars, n) after each sample of a stretch whose matrices hold.

    After each pass a state holds what twice as many samples before it gave: log2 m passes over arrays
    in place of m steps.
    """
    Phi, G0, G1 = (np.moveaxis(x, 0, -1)[..., None] for x in hold)
    for k in range(begin, end, TOGETHER):
        after = slice(k + 1, min(k + TOGETHER, end) + 1)
        late_v, late_r = G0 * steer[:, k : after.stop - 1] + G1 * steer[:, after]
        late_v[:, :1] += Phi[0, 0] * v[:, k : k + 1] + Phi[0, 1] * r[:, k : k + 1]
        late_r[:, :1] += Phi[1, 0] * v[:, k : k + 1] + Phi[1, 1] * r[:, k : k + 1]
        power, reach = hold[0], 1
        while reach < late_v.shape[1]:
            (vv, vr), (rv, rr) = np.moveaxis(power, 0, -1)[..., None]
            early_v, early_r = late_v[:, :-reach], late_r[:, :-reach]
            to_v, to_r = vv * early_v + vr * early_r, rv * early_v + rr * early_r
            late_v[:, reach:] += to_v
            late_r[:, reach:] += to_r
            power, reach = power @ power, 2 * reach
        v[:, after], r[:, after] = late_v, late_r


def _matrices(U, K, L, p1, eta, rho):
    """State matrices of x = [v, r] in SI units, (stretches, cars, 2, 2) and (stretches, cars, 2)."""
    p2 = 1 - p1
    front = K / L  # Caf/m
    rear = front * eta * p1 / p2  # Car/m
    a, b, gyration = p1 * L, p2 * L, rho * p1 * p2 * L * L  # gyration = Iz/m
    turns = b * rear - a * front
    A = [
        [-(front + rear) / U, turns / U - U],
        [turns / (gyration * U), -(a * a * front + b * b * rear) / (gyration * U)],
    ]
    return np.moveaxis(A, (0, 1), (-2, -1)), np.stack([front, a * front / gyration], axis=-1)


def _first_order_hold(A: NDArray, B: NDArray, dt: NDArray) -> tuple[NDArray, NDArray, NDArray]:
    """Transition and the weights of the steer at both ends of each stretch's samples."""
    block = np.zeros((*B.shape[:2], 4, 4))
    block[..., :2, :2] = A * dt[:, None, None, None]
    block[..., :2, 2] = B * dt[:, None, None]
    block[..., 2, 3] = 1.0
    E = _exponential(block)
    return E[..., :2, :2], E[..., :2, 2] - E[..., :2, 3], E[..., :2, 3]


def _exponential(M: NDArray) -> NDArray:
    """exp of every matrix: the series of a part that is small, squared back."""
    size = float(np.abs(M).sum(axis=-1).max())
    halved = max(0, math.frexp(size / SMALL)[1])
    part = M / 2.0**halved
    E = term = np.broadcast_to(np.eye(M.shape[-1]), M.shape)
    for power in range(1, TERMS):
        term = term @ part / power
        E = E + term
    for _ in range(halved):
        E = E @ E
    return E
