"""Noise of a sensor estimated from its own log, counting repeated samples of a slow bus once.

Invariant: the result is never below what quantisation alone would give, nor below a stated floor.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.units import Uncertain

FLOOR = np.deg2rad(0.05)  # rad/s; no automotive gyro with its mounting is quieter
SECOND_DIFFERENCE = np.sqrt(6.0)  # sd of white noise is multiplied by this
MAD_TO_STD = 1.4826
CHANCE = 0.5 / np.sqrt(np.pi)  # two white readings round alike: this times step over sd
CHANCE_ROOM = 1.3  # the law of CHANCE holds for steps below the sd, and is near enough above
HELD_SHARE = 0.5  # a bus at half the log's rate or less repeats at least this much


@dataclass(frozen=True)
class SensorNoise:
    """White noise of one sensor: sd per sample [rad/s], and what it rests on."""

    std: float
    fresh: float  # share of samples that are new readings [-]
    step: float  # smallest step between readings [rad/s]


def sensor_noise(values: NDArray[np.float64]) -> SensorNoise:
    """Estimate the white noise of a measured signal.

    The median absolute second difference of the fresh samples is insensitive to manoeuvres; the
    sd is divided by the root of the fresh share so that averaging repeats creates no information.
    Repeats that a coarse gyro gives by chance are readings of their own.

    Parameters
    ----------
    values : (n,) measured signal [rad/s], NaN where missing.
    """
    finite = values[np.isfinite(values)]
    if finite.size < 8:
        return SensorNoise(FLOOR, 1.0, 0.0)
    changed = np.diff(finite) != 0
    fresh = float(max(np.mean(changed), 1.0 / finite.size))
    steps = np.abs(np.diff(finite))[changed]
    step = float(np.quantile(steps, 0.01)) if steps.size else 0.0
    white = white_noise(values)
    if 1 - fresh < min(CHANCE_ROOM * CHANCE * step / max(white, FLOOR), HELD_SHARE):
        fresh = 1.0
    elif fresh < 0.95:
        white = white_noise(finite[1:][changed])
    quantisation = step / np.sqrt(12.0)
    return SensorNoise(float(max(white, quantisation, FLOOR) / np.sqrt(fresh)), fresh, step)


def white_noise(readings: NDArray[np.float64]) -> float:
    """Sd of the white part of a signal, (n,) in any unit, whose every sample is a new reading."""
    second = np.abs(np.diff(readings, 2))
    second = second[np.isfinite(second)]  # a difference across a hole is a manoeuvre
    return MAD_TO_STD * float(np.median(second)) / SECOND_DIFFERENCE if second.size else 0.0


def gyro_noise(values: NDArray[np.float64], stated: Uncertain | None) -> SensorNoise:
    """Noise of the yaw rate: as the vehicle file states it, else from the log itself."""
    return SensorNoise(stated.value, 1.0, 0.0) if stated else sensor_noise(values)
