"""The drives every measurement is taken on, simulated with a fixed seed.

Invariant: steer is rich enough that the estimators go their longest way on nearly every sample.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.simulate import bicycle_response

SEED = 20040
CAR = {"L": 2.7, "K": 145.0, "pi1": 0.45, "eta": 1.4, "rho": 1.0}  # a middle-sized car
NOISE = float(np.deg2rad(0.15))  # rad/s, white, of the yaw rate
SMALL_CAR = {"L": 0.3652, "K": 4.3547, "pi1": 0.4, "eta": 1.1282, "rho": 0.9256}  # the paper's


@dataclass(frozen=True, eq=False)
class Drive:
    """A simulated log: t [s], steer [rad], U [m/s], yaw rate [rad/s], (n,) each."""

    t: NDArray[np.float64]
    steer: NDArray[np.float64]
    U: NDArray[np.float64]
    yaw_rate: NDArray[np.float64]

    def samples(self) -> NDArray[np.float64]:
        """Rows for a step, (n, 4): dt, steer, speed, yaw rate."""
        dt = np.full(len(self.t), self.t[1] - self.t[0])
        return np.column_stack([dt, self.steer, self.U, self.yaw_rate])

    def write_csv(self, path: Path) -> None:
        """Write the log as `similitude identify` reads it."""
        with path.open("w", encoding="utf-8") as file:
            file.write("t [s],delta [rad],r [rad/s],U [m/s]\n")
            for row in zip(self.t, self.steer, self.yaw_rate, self.U, strict=True):
                file.write("{:.3f},{:.6f},{:.6f},{:.3f}\n".format(*row))


def road_drive(n: int) -> Drive:
    """A car on the road at 100 Hz, steered 0.15 to 1 Hz with 4 mrad rms at 18 to 26 m/s."""
    from scipy.signal import butter, sosfilt

    rng = np.random.default_rng(SEED)
    t = np.arange(n) / 100.0
    band = butter(2, [0.15, 1.0], "bandpass", fs=100.0, output="sos")
    steer = sosfilt(band, rng.standard_normal(n + 2000))[2000:]
    steer *= 4e-3 / steer.std()
    U = 22.0 + 4.0 * np.sin(2 * np.pi * np.floor(t) / 120.0)  # a new speed every second
    r, _ = bicycle_response(t, steer, U, **CAR)
    return Drive(t, steer, U, r + NOISE * rng.standard_normal(n))


def square_drive(n: int) -> Drive:
    """The paper's small car at 1 kHz and 3.6 to 4.4 m/s on a square wave; free of noise."""
    from scipy.signal import cont2discrete, lfilter

    t = np.arange(n) / 1000.0
    w = 2 * np.pi * 5.0  # rad/s, the steering servo, damping 0.707
    over, under, _ = cont2discrete(([w * w], [1.0, 1.414 * w, w * w]), 1e-3)
    steer = lfilter(over.ravel(), under, np.where((0.7 * t) % 1 < 0.5, 0.1, -0.1))
    U = 4.0 + 0.4 * np.sin(np.floor(10 * t))  # a new speed ten times a second
    r, _ = bicycle_response(t, steer, U, **SMALL_CAR)
    return Drive(t, steer, U, r)
