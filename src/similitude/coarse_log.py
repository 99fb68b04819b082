"""A log with fewer rows: means over equal times, for searches that go over it many times.

Invariant: steer, yaw rate and speed are averaged over the same time, so what relates them is unchanged;
what was mostly not measured is missing, and a pause stays a pause. An estimator draws straight lines from
steer to steer, which flatten its waves: the means are raised by as much.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from similitude.log import Log


def coarse_log(log: Log, rate: float) -> Log:
    """The log at a given number of rows a second [Hz]; itself where it has less than twice as many.

    White noise loses as much as there are fewer rows. A time none of whose rows was logged has no row.
    """
    if log.rate < 2 * rate * 0.999:
        return log
    cell = np.floor((log.t - log.t[0]) * rate + 1e-6)
    first = np.flatnonzero(np.diff(cell, prepend=-1.0) > 0)
    count = np.diff(np.append(first, log.samples))

    def means(values: NDArray[np.float64]) -> NDArray[np.float64]:
        known = np.isfinite(values)
        measured = np.add.reduceat(known.astype(float), first)
        total = np.add.reduceat(np.where(known, values, 0.0), first)
        return np.where(2 * measured >= count, total / np.maximum(measured, 1), np.nan)

    columns = {name: means(getattr(log, name)) for name in ("t", "delta", "r", "U")}
    pause = np.diff(columns["t"]) > 1.5 / rate  # beyond it lies another stretch of road
    alone = np.append(pause, False) | np.insert(pause, 0, False)
    columns["delta"] = np.where(alone, columns["delta"], lines_of_means(columns["delta"]))
    return replace(log, ay=None if log.ay is None else means(log.ay), **columns)


def lines_of_means(means: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values whose straight lines from row to row follow the signal that was averaged, (n,).

    Lines through the means take (w h)^2/12 off a wave of w a unit of length, sampled every h: a twelfth of
    the second difference, which is added. What is left is of the fourth power.

    Parameters
    ----------
    means : (n,) float64   means over equal stretches, NaN where missing
    """
    lost = np.zeros_like(means)
    lost[1:-1] = (means[2:] - 2.0 * means[1:-1] + means[:-2]) / 12.0
    return means - np.where(np.isfinite(lost), lost, 0.0)
