"""A known car on an open-loop square wave for the tests of the paper's regression.

Written with scipy alone; nothing of the package's models, filters or regression is used.
"""

import functools

import numpy as np
from scipy import signal

from similitude.program.library import shipped

TS, U, L = 1e-3, 4.0, 0.3652
M, IZ, A_, B_ = 5.451, 0.1615, 0.1461, 0.2191
CAF, CAR = 65.0, 110.0
OWN = {"pi1": A_ / L, "pi4_slope": CAR / CAF, "pi5": IZ / (M * L * L)}
K = CAF * L / M


@functools.cache
def library():
    """The shipped estimator, compiled."""
    return shipped("bicycle_paper")


def servo_square(n: int, amplitude: float = 0.1) -> np.ndarray:
    """A 0.7 Hz square wave behind the paper's steering servo (5 Hz, damping 0.707), [rad]."""
    t = np.arange(n) * TS
    w = 2 * np.pi * 5
    over, under, _ = signal.cont2discrete(([w * w], [1, 2 * 0.707 * w, w * w]), TS)
    square = amplitude * np.where((0.7 * t) % 1 < 0.5, 1.0, -1.0)
    return signal.lfilter(over.ravel(), under, square)


def yaw_rate(delta: np.ndarray, scale: float = 1.0, speed: float = U) -> np.ndarray:
    """Exact yaw rate of the paper's car, both stiffnesses scaled, [rad/s]."""
    front, rear = CAF * scale, CAR * scale
    cross = B_ * rear - A_ * front
    A = np.array(
        [
            [-(front + rear) / (M * speed), cross / (M * speed) - speed],
            [cross / (IZ * speed), -(A_ * A_ * front + B_ * B_ * rear) / (IZ * speed)],
        ]
    )
    B = np.array([[front / M], [A_ * front / IZ]])
    plant = signal.cont2discrete((A, B, np.array([[0.0, 1.0]]), np.zeros((1, 1))), TS)
    over, under = signal.ss2tf(*plant[:4])
    return signal.lfilter(over[0], under, delta)


def samples(delta, r, speed=U, dt=TS) -> np.ndarray:
    """Rows dt, input, U, measured."""
    return np.stack(np.broadcast_arrays(float(dt), delta, speed, r), axis=1).astype(float)


def outputs(values: np.ndarray, name: str) -> np.ndarray:
    """One column of the estimator's output."""
    return values[:, library().index("output", name)]
