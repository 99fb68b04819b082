"""Equations 29 to 32: the regulator."""

from __future__ import annotations

import numpy as np

from similitude.paper import printed
from similitude.paper.claims_controller import car_and_driver
from similitude.simulation.lqr import STATES, Follower, lqr_gain, path_matrices


def _loop() -> tuple[np.ndarray, np.ndarray]:
    """A (5, 5) and B (5,) with the integral of y added (eq 30), at 3 m/s."""
    car, driver = car_and_driver()
    A, B = path_matrices(car, driver.design_speed)
    whole = np.zeros((STATES, STATES))
    whole[0, 1], whole[1:, 1:] = 1.0, A
    return whole, np.append(0.0, B)


def _least_cost() -> float:
    """Eq 29: no gain near the shipped one costs less (the slope of the cost is zero there)."""
    A, B = _loop()
    car, driver = car_and_driver()
    k = lqr_gain(car, driver)

    def cost(gain: np.ndarray) -> float:
        from scipy.linalg import solve_continuous_lyapunov

        closed = A - np.outer(B, gain)
        weight = np.diag(driver.weights) + driver.effort * np.outer(gain, gain)
        return float(np.trace(solve_continuous_lyapunov(closed.T, -weight)))

    steps = np.diag(1e-4 * k)
    slope = [abs(cost(k + d) - cost(k - d)) / (2e-4 * cost(k)) for d in steps]
    return max(slope)


def _integral() -> float:
    """Eq 30: the driver's first state is the integral of his offset."""
    car, driver = car_and_driver()
    step, offset, n = 0.001, 0.01, 100
    follower = Follower(driver, car, np.arange(n + 1) * step)
    wanted = follower.wanted(0)
    steers = [follower.command(i, wanted + offset, 0.0, 0.0, 0.0) for i in range(n + 1)]
    k = lqr_gain(car, driver)
    return abs((steers[0] - steers[-1]) / (k[0] * offset * n * step) - 1)


def _weights() -> float:
    """Eq 31: those of the shipped scenario."""
    _, driver = car_and_driver()
    return max(abs(np.array(driver.weights) - printed.WEIGHTS).max(), abs(driver.effort - 1))


def _gain() -> float:
    """Eq 32: to every printed digit."""
    return float(np.abs(np.round(lqr_gain(*car_and_driver()), 4) - printed.GAIN).max())


_LQR = "similitude.simulation.lqr."
TABLE = (
    (29, "∫ xᵀQx + uᵀRu dt, least", _LQR + "lqr_gain", _least_cost, 1e-5),
    (30, "x = [∫y dt, y, ẏ, ψ, ψ̇]", _LQR + "Follower", _integral, 1e-6),
    (31, "Q = diag(0.03, 5, 0.02, 0.1, 0.001), R = 1", _LQR + "Lqr", _weights),
    (32, "the gain", _LQR + "lqr_gain", _gain),
)
