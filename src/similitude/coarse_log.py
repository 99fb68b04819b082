"""A log with fewer rows: means over equal times, for searches that go over it many times.

Invariant: steer, yaw rate and speed are averaged over the same time, so what relates them is unchanged;
what was mostly not measured is missing, and a pause stays a pause. An estimator draws straight lines from
steer to steer, which flatten its waves: the means are raised by as much.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from similitude.log import Log


@dataclass(frozen=True, eq=False)
class CoarseLog:
    """A log at a given number of rows a second [Hz], and the whole one behind it.

    White noise loses as much as there are fewer rows. A time none of whose rows was logged has no row.
    """

    whole: Log
    rate: float

    @cached_property
    def _first(self) -> NDArray[np.intp]:
        """The first of the rows that make each coarse one, (m,)."""
        t = self.whole.t
        cell = np.floor((t - t[0]) * self.rate + 1e-6)
        return np.flatnonzero(np.diff(cell, prepend=-1.0) > 0)

    @cached_property
    def _alone(self) -> NDArray[np.bool_]:
        """Coarse rows next to a pause, beyond which lies another stretch of road, (m,)."""
        pause = np.diff(self._means(self.whole.t)) > 1.5 / self.rate
        return np.append(pause, False) | np.insert(pause, 0, False)

    @cached_property
    def _count(self) -> NDArray[np.intp]:
        return np.diff(np.append(self._first, self.whole.samples))

    def _means(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        known, count = np.isfinite(values), self._count
        if known.all():
            return np.add.reduceat(values, self._first) / count
        measured = np.add.reduceat(known.astype(float), self._first)
        total = np.add.reduceat(np.where(known, values, 0.0), self._first)
        return np.where(2 * measured >= count, total / np.maximum(measured, 1), np.nan)

    def steer(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Coarse steer (m,) of one for every row of the whole log, (n,) [rad]."""
        means = self._means(values)
        return np.where(self._alone, means, lines_of_means(means))

    @cached_property
    def log(self) -> Log:
        """The means."""
        columns = {name: self._means(getattr(self.whole, name)) for name in ("t", "r", "U")}
        columns["delta"] = self.steer(self.whole.delta)
        ay = None if self.whole.ay is None else self._means(self.whole.ay)
        return replace(self.whole, ay=ay, **columns)


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
