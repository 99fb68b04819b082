"""The linear bicycle as a plant: exact response to a steer angle that is straight between samples.

Invariant: no integration error. Over each sample the state moves by the matrix exponential of the
model with its parameters held; the steer moves linearly from one sample to the next.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray


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
    length, p1, ratio, inertia = (
        np.broadcast_to(np.asarray(x, dtype=float).reshape(-1, 1), (shape[0], 1)) for x in (L, pi1, eta, rho)
    )
    dt = np.diff(t)
    v, r = np.zeros(shape), np.zeros(shape)
    x = np.zeros((shape[0], 2))
    changes = (np.diff(speed, axis=1) != 0).any(axis=0) | (np.diff(stiffness, axis=1) != 0).any(axis=0)
    changes[:-1] |= np.abs(np.diff(dt)) > 1e-9
    for k in range(shape[1] - 1):
        if k == 0 or changes[k - 1]:
            A, B = _matrices(speed[:, k], stiffness[:, k], length, p1, ratio, inertia)
            Phi, G0, G1 = _first_order_hold(A, B, dt[k])
        x = (Phi @ x[:, :, None])[:, :, 0] + G0 * steer[:, k, None] + G1 * steer[:, k + 1, None]
        v[:, k + 1], r[:, k + 1] = x[:, 0], x[:, 1]
    beta = v / np.maximum(speed, 1e-9)
    return (r[0], beta[0]) if np.ndim(delta) == 1 else (r, beta)


def _matrices(U, K, L, p1, eta, rho):
    """State matrices of x = [v, r] in SI units, (cars, 2, 2) and (cars, 2)."""
    U, K = U[:, None], K[:, None]
    p2 = 1 - p1
    front = K / L  # Caf/m
    rear = front * eta * p1 / p2  # Car/m
    a, b, gyration = p1 * L, p2 * L, rho * p1 * p2 * L * L  # gyration = Iz/m
    A = np.zeros((len(U), 2, 2))
    A[:, 0, 0] = (-(front + rear) / U)[:, 0]
    A[:, 0, 1] = ((b * rear - a * front) / U - U)[:, 0]
    A[:, 1, 0] = ((b * rear - a * front) / (gyration * U))[:, 0]
    A[:, 1, 1] = (-(a * a * front + b * b * rear) / (gyration * U))[:, 0]
    return A, np.concatenate([front, a * front / gyration], axis=1)


def _first_order_hold(A: NDArray, B: NDArray, dt: float) -> tuple[NDArray, NDArray, NDArray]:
    """Transition and the weights of the steer at both ends of the sample."""
    from scipy.linalg import expm

    n = len(A)
    block = np.zeros((n, 4, 4))
    block[:, :2, :2] = A * dt
    block[:, :2, 2] = B * dt
    block[:, 2, 3] = 1.0
    E = expm(block)
    return E[:, :2, :2], E[:, :2, 2] - E[:, :2, 3], E[:, :2, 3]
