"""What a user would take otherwise: padasip's RLS and filterpy's extended Kalman filter.

The Kalman filter has the states of the population filter (sideslip, yaw rate, disturbance, ln K,
pi1, ln eta, ln rho, steer scale, steer offset, yaw bias) and its measurement; its transition is
one midpoint step in numpy, its Jacobian forward differences of all ten states in one call.
It adapts no noise and guards against nothing: what is timed is the filter alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bench.kernels import FORGETTING, P_START

STATES = 10
LN_K = 3
PRIOR = np.array([0, 0, 0, np.log(145.68), 0.4431, np.log(1.42), np.log(1.017), 0, 0, 0])
PRIOR_SD = np.array([1.0, 0.1, 1e-3, 0.5, 0.03, 0.13, 0.09, 0.02, 0.02, 0.005])
DIFFUSION = np.array([0, 0, 2e-6, 1e-4, 0, 0, 0, 0, 0, 1e-10])  # of the states, per second
DISTURBANCE_RATE = 1 / 0.7  # 1/s
STEP = 1e-6  # of the differences
YAW_RATE = np.array([[0, 1.0, 0, 0, 0, 0, 0, 0, 0, 1.0]])  # the measurement's row


def padasip_rls(phi: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    """Run padasip's RLS sample by sample, with the start and forgetting of reference.c; theta (n,)."""
    from padasip.filters import FilterRLS

    rls = FilterRLS(n=1, mu=FORGETTING, eps=1 / P_START, w="zeros")
    theta = np.empty(len(phi))
    for i, row in enumerate(phi[:, None]):
        rls.adapt(y[i], row)
        theta[i] = rls.w[0]
    return theta


class Ekf:
    """filterpy's extended Kalman filter of a car with wheelbase ``L`` [m] and gyro noise [rad/s]."""

    def __init__(self, L: float, noise_std: float) -> None:
        from filterpy.kalman import ExtendedKalmanFilter

        self.L = L
        self.filter = ExtendedKalmanFilter(dim_x=STATES, dim_z=1)
        self.filter.x = PRIOR[:, None].copy()
        self.filter.P = np.diag(PRIOR_SD**2)
        self.filter.R = np.array([[noise_std**2]])
        self.filter.predict_x = self._predict_x

    def step(self, dt: float, steer: float, U: float, measured: float) -> None:
        """One sample: prediction with this sample's steer [rad] and speed [m/s], then update."""
        self.filter.Q = np.diag(DIFFUSION * dt)
        self.filter.predict((dt, steer, U))
        self.filter.update(measured, HJacobian=lambda x: YAW_RATE, Hx=lambda x: YAW_RATE @ x)

    def run(self, samples: NDArray[np.float64]) -> NDArray[np.float64]:
        """Run over rows dt, steer, U, yaw rate; ln K after each sample, (n,)."""
        ln_K = np.empty(len(samples))
        for i, row in enumerate(samples.tolist()):
            self.step(*row)
            ln_K[i] = self.filter.x[LN_K, 0]
        return ln_K

    def _predict_x(self, u: tuple[float, float, float]) -> None:
        """Next state and its Jacobian from one call on the state and its ten neighbours."""
        around = self.filter.x + np.hstack([np.zeros((STATES, 1)), STEP * np.eye(STATES)])
        after = transition(around, *u, L=self.L)
        self.filter.F = (after[:, 1:] - after[:, :1]) / STEP
        self.filter.x = after[:, :1]


def transition(x: NDArray[np.float64], dt: float, steer: float, U: float, *, L: float):
    """States one sample later, (10, k): one midpoint step for sideslip, yaw rate and disturbance."""
    half = x[:3] + 0.5 * dt * _rates(x[:3], x, steer, U, L)
    later = x.copy()
    later[:3] = x[:3] + dt * _rates(half, x, steer, U, L)
    return later


def _rates(fast, x, steer, U, L):
    """Rates of lateral speed [m/s^2], yaw rate [rad/s^2] and disturbance [rad/s]."""
    v, r, w = fast
    p1, p2 = x[4], 1 - x[4]
    front = np.exp(x[3]) / L
    rear = front * np.exp(x[5]) * p1 / p2
    a, b = p1 * L, p2 * L
    inertia = np.exp(x[6]) * a * b
    slip_front = (1 + x[7]) * steer + x[8] + w - (v + a * r) / U
    slip_rear = (b * r - v) / U
    return np.stack(
        [
            front * slip_front + rear * slip_rear - U * r,
            (a * front * slip_front - b * rear * slip_rear) / inertia,
            -DISTURBANCE_RATE * w,
        ]
    )
