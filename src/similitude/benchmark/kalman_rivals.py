"""Kalman filters that others run, written here from what they publish, on means over 50 ms.

`nine_state`   openpilot's learner of vehicle parameters: its states (stiffness, steering ratio, two angle
               offsets, speed forward and aside, yaw rate, wheel angle, roll), equations, process and
               observation noise. Nobody tells it this car's own model: it has the population's mean.
`dual_ekf`     two filters side by side: one of the motion with the last ln K, one of ln K with what the
               motion's one-step prediction misses.

References
----------
commaai/openpilot, selfdrive/locationd/models/car_kf.py and paramsd.py (MIT);
T. Wenzel, K. Burnham, M. Blundell, R. Williams, Dual extended Kalman filter for vehicle state and parameter
estimation, Vehicle System Dynamics 44 (2006).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from similitude.benchmark.drives import Drive
from similitude.benchmark.entrant import Answer
from similitude.benchmark.regression_rivals import MEAN_OVER, START_K, START_STD, thinned, told
from similitude.vehicle_prior import vehicle_prior

Array = NDArray[np.float64]
RATIO = 15.0  # steering wheel over road wheel
G = 9.81  # m/s^2, theirs
# stiffness, steering ratio [-], offsets slow and fast [rad], u, v [m/s], r [rad/s], wheel and roll [rad]
STIFFNESS, STEER_RATIO, SLOW, FAST, FORWARD, ASIDE, YAW, WHEEL, ROLL = range(9)
PROCESS = np.square([5e-4, 0.01, math.radians(0.02), math.radians(0.25), 0.1, 0.01, math.radians(0.1),
                     math.radians(0.1), math.radians(1.0)])  # fmt: skip
OBSERVED = [YAW, WHEEL, FORWARD, FAST, STEER_RATIO, STIFFNESS, ROLL]
OBSERVED_SD = [math.radians(0.05), 0.1, math.radians(10.0), 5.0, 0.5, math.radians(1.0)]  # all but YAW
WANDER = 1e-3  # 1/s, variance of ln K a second, as the reference experiment's q_κ
MOTION = 1e-4  # (rad/s)^2 a second of the motion that no model has


def nine_state(drive: Drive) -> Answer:
    """Run openpilot's nine-state filter."""
    from scipy.linalg.lapack import dgesv

    t, delta, r, U = thinned(drive)
    moved = _motion(*_mean_car(drive))
    x = np.array([1.0, RATIO, 0, 0, U[0], 0, 0, RATIO * delta[0], 0])
    P = np.diag(PROCESS)
    noise = np.diag(np.square([drive.noise / math.sqrt(MEAN_OVER), *OBSERVED_SD]))
    K, sd = np.empty(t.size), np.empty(t.size)
    dt = float(t[1] - t[0])
    process = np.diag(PROCESS) * dt
    columns = (r.tolist(), (RATIO * delta).tolist(), U.tolist())
    for i, (yaw, wheel, forward) in enumerate(zip(*columns, strict=True)):
        x, F = moved(x, dt)
        P = F @ P @ F.T + process
        # ratio and stiffness are observed as what they are taken for: nothing is missed
        missed = np.array([yaw - x[YAW], wheel - x[WHEEL], forward - x[FORWARD], -x[FAST], 0, 0, -x[ROLL]])
        cross = P[OBSERVED]
        gain = dgesv(cross[:, OBSERVED] + noise, cross)[2].T
        x = x + gain @ missed
        P = P - gain @ cross
        K[i], sd[i] = START_K * x[STIFFNESS], START_K * math.sqrt(max(P[STIFFNESS, STIFFNESS], 0.0))
    return told(drive, t, K, sd)


def dual_ekf(drive: Drive) -> Answer:
    """Run the dual extended Kalman filter."""
    t, delta, r, U = thinned(drive)
    L, pi1, eta, rho = _mean_car(drive)
    p2 = 1 - pi1
    a, b, inertia = pi1 * L, p2 * L, rho * pi1 * p2 * L * L
    ratio, dt = eta * pi1 / p2, float(t[1] - t[0])
    R = drive.noise**2 / MEAN_OVER
    v = yaw = 0.0
    Pvv, Pvr, Prr, Q = 1e-2, 0.0, 1e-2, MOTION * dt
    ln_K, P = math.log(START_K), START_STD**2
    K, sd = np.empty(t.size), np.empty(t.size)
    for i, (steer, seen, speed) in enumerate(zip(delta.tolist(), r.tolist(), U.tolist(), strict=True)):
        P += WANDER * dt
        front = math.exp(ln_K) / L
        rear = front * ratio
        # x' = A x + B δ in one implicit step: (1 − A dt) x = x_before + B δ dt
        m11, m12 = 1 + dt * (front + rear) / speed, dt * ((a * front - b * rear) / speed + speed)
        m21 = dt * (a * front - b * rear) / inertia / speed
        m22 = 1 + dt * (a * a * front + b * b * rear) / inertia / speed
        det = m11 * m22 - m12 * m21
        p11, p12, p21, p22 = m22 / det, -m12 / det, -m21 / det, m11 / det
        fv, fr = v + dt * front * steer, yaw + dt * a * front / inertia * steer
        v, yaw = p11 * fv + p12 * fr, p21 * fv + p22 * fr
        # what ln K does to this step: x = M⁻¹ f, dx = M⁻¹ (df − dM x); everything in K is proportional to it
        dv = dt * front * steer - (m11 - 1) * v - dt * (a * front - b * rear) / speed * yaw
        dr = dt * a * front / inertia * steer - m21 * v - (m22 - 1) * yaw
        slope = p21 * dv + p22 * dr
        Nvv = p11 * (p11 * Pvv + p12 * Pvr) + p12 * (p11 * Pvr + p12 * Prr) + Q
        Nvr = p21 * (p11 * Pvv + p12 * Pvr) + p22 * (p11 * Pvr + p12 * Prr)
        Nrr = p21 * (p21 * Pvv + p22 * Pvr) + p22 * (p21 * Pvr + p22 * Prr) + Q
        S = Nrr + R
        missed = seen - yaw
        gain = P * slope / (slope * slope * P + S)
        ln_K = min(max(ln_K + gain * missed, -2.0), 12.0)
        P -= gain * slope * P
        gv, gr = Nvr / S, Nrr / S
        v, yaw = v + gv * missed, yaw + gr * missed
        Pvv, Pvr, Prr = Nvv - gv * Nvr, Nvr * (1 - gr), Nrr * (1 - gr)
        K[i] = math.exp(ln_K)
        sd[i] = K[i] * math.sqrt(P)
    return told(drive, t, K, sd)


def _mean_car(drive: Drive) -> tuple[float, float, float, float]:
    """L of the drive [m], and pi1, eta, rho of the population's mean [-]."""
    mean = vehicle_prior(drive.vehicle).mean
    return drive.L, float(mean[1]), float(mean[2]), float(mean[3])


def _motion(L: float, pi1: float, eta: float, rho: float):
    """One step of the nine states and its slopes (9, 9): their equations, explicit and of first order."""
    p2 = 1 - pi1
    a, b, inertia = pi1 * L, p2 * L, rho * pi1 * p2 * L * L
    front, rear = START_K / L, START_K / L * eta * pi1 / p2
    F = np.eye(9)  # the entries that are not written below stay as they are
    both, lever, square = front + rear, a * front - b * rear, a * a * front + b * b * rear

    def step(x: Array, dt: float) -> tuple[Array, Array]:
        sf, ratio, slow, fast, u, v, r, wheel, roll = x.tolist()
        steer = (wheel - slow - fast) / ratio
        aside = (-both * v - lever * r) / u + front * steer  # of sf = 1, the two rates that stiffness makes
        turning = ((-lever * v - square * r) / u + a * front * steer) / inertia
        F[ASIDE, STIFFNESS], F[YAW, STIFFNESS] = dt * aside, dt * turning
        F[ASIDE, FORWARD] = dt * (sf * (both * v + lever * r) / u**2 - r)
        F[YAW, FORWARD] = dt * sf * (lever * v + square * r) / u**2 / inertia
        F[ASIDE, ASIDE], F[ASIDE, YAW] = 1 - dt * sf * both / u, -dt * (sf * lever / u + u)
        F[YAW, ASIDE], F[YAW, YAW] = -dt * sf * lever / u / inertia, 1 - dt * sf * square / u / inertia
        F[ASIDE, ROLL] = -dt * G
        for row, arm in ((ASIDE, front), (YAW, a * front / inertia)):
            by = dt * sf * arm / ratio
            F[row, STEER_RATIO], F[row, WHEEL] = -by * steer, by
            F[row, SLOW] = F[row, FAST] = -by
        later = x.copy()
        later[ASIDE] += dt * (sf * aside - u * r - G * roll)
        later[YAW] += dt * sf * turning
        return later, F

    return step
