"""A log with fewer rows: means over equal times, for searches that go over it many times.

Invariant: steer, yaw rate and speed are averaged over the same time, so what relates them is unchanged;
what was mostly not measured is missing, and a pause stays a pause.
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
    return replace(log, ay=None if log.ay is None else means(log.ay), **columns)
