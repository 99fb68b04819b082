"""The accelerometer of a log: whether its readings can be used, where it sits, how it errs.

Invariant: a column that does not go with U r is not used, whatever the vehicle file says of it, and why
is said.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.log import Log
from similitude.noise import white_noise
from similitude.vehicle_file import Vehicle

BEHIND_SD = 0.05  # m: a place that was read off a drawing
QUIETEST = 0.05  # m/s^2: engine and road
MOTION = 0.3  # m/s^2 rms of U r from which on a slope can be told
ALIKE = 1.0  # s: what a car does besides stays alike for so long
AWAY = 0.4  # of the slope of ay by U r, from one: sideslip, roll and bank
SURE = 3.0  # sd


@dataclass(frozen=True)
class Accelerometer:
    """Place behind the front axle [m] with its sd, and white noise a sample [m/s^2]."""

    behind: float
    behind_sd: float
    noise: float


def find_accelerometer(log: Log, vehicle: Vehicle) -> tuple[Accelerometer | None, str]:
    """What the filter may know of the lateral acceleration of a log.

    Parameters
    ----------
    log : Log          with or without ``ay`` [m/s^2].
    vehicle : Vehicle  its ``accelerometer`` is the place behind the front axle [m]; without it none is used.

    Returns
    -------
    accelerometer, why    None where it cannot be used; ``why`` says so where the file stated one.
    """
    place = vehicle.accelerometer
    if place is None:
        return None, ""
    if log.ay is None:
        return None, "the vehicle file places an accelerometer; the log has no column ay, so none is used"
    slope, sd = _slope(log)
    if np.isfinite(slope) and abs(slope - 1) > AWAY + SURE * sd:
        return None, (
            f"ay goes with {slope:.2f} ± {sd:.2f} of U r where an accelerometer across the car goes with "
            "about 1; it is not used (another axis, another sign, or another unit)"
        )
    noise = max(white_noise(log.ay), QUIETEST)
    return Accelerometer(place.value, BEHIND_SD if place.sd is None else place.sd, noise), ""


def _slope(log: Log) -> tuple[float, float]:
    """Slope of ay by U r and its sd [-]; NaN where the car hardly turned."""
    turn, ay = log.U * log.r, log.ay
    known = np.isfinite(turn) & np.isfinite(ay)
    if known.sum() < 3 or float(np.std(turn[known])) < MOTION:
        return np.nan, np.nan
    x, y = _centred(turn[known]), _centred(ay[known])
    slope = float(x @ y / (x @ x))
    independent = max(known.sum() / max(ALIKE * log.rate, 1.0), 3.0)
    return slope, float(np.std(y - slope * x) / np.std(x) / np.sqrt(independent))


def _centred(values: NDArray[np.float64]) -> NDArray[np.float64]:
    return values - values.mean()
