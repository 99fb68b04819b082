"""One column by itself: what is missing, its range, how often it is new, its noise, its grid.

Invariant: every number is in the column's own unit, so a column whose unit nobody knows is
described like any other; a number that the values do not give is None, never NaN.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

MAD_TO_STD = 1.4826
SECOND, FOURTH = np.sqrt(6.0), np.sqrt(70.0)  # white noise grows by this in a 2nd and 4th difference
ALIKE = 0.85  # both differences tell the same noise; below, the signal itself is in the larger
FEWEST = 8  # values; fewer have no statistics
FEWEST_STEPS = 20  # changes, before a grid is believed
HELD = 0.5  # of the rows new: with fewer, most differences are zero and tell no noise
SMALLEST = (0.0, 1e-3, 1e-2)  # share of the changes below the one that may be a step: rounding spoils a few
LARGEST_STEP = 20  # grid steps: larger changes say little about the grid
ON_GRID = 0.95  # share of the changes that are whole steps, to 0.1 of a step; chance gives 0.2
LIMIT_SHARE = 0.01  # of the rows at the very extreme ...
PEAKED = 1.6  # times the rows at an extreme lie within three steps of it: a peak, no limit; a sine has 2
LIMIT_VISITS = 3  # ... on separate occasions: a signal cut off there


@dataclass(frozen=True)
class Channel:
    """A column of a file.

    Parameters
    ----------
    header : str              as written
    unit : str or None        as written; None where the header has none
    taken_for : str or None   quantity of a log, such as ``"r"``; None where the column is not used
    missing : float           share of the rows without a number [-]
    low, high, mean : float or None   of the numbers there are [unit]
    noise : float or None     sd of the white part of a reading [unit]
    noise_is_bound : bool     the signal moves too fast to tell: `noise` is the most it can be
    fresh : float             share of the rows that differ from the row before [-]
    hold : int                rows from one change to the next, usually
    resolution : float or None   step of the grid the readings lie on [unit]; None without a grid
    cut_low, cut_high : float  share of the rows held at the extreme as if cut off there [-]
    straight : float          share of the rows filled in on straight lines, for a used column [-]
    """

    header: str
    unit: str | None
    taken_for: str | None
    missing: float
    low: float | None = None
    high: float | None = None
    mean: float | None = None
    noise: float | None = None
    noise_is_bound: bool = False
    fresh: float = 0.0
    hold: int = 1
    resolution: float | None = None
    cut_low: float = 0.0
    cut_high: float = 0.0
    straight: float = 0.0

    @property
    def is_constant(self) -> bool:
        """Whether every number of the column is the same."""
        return self.low is not None and self.low == self.high


@np.errstate(over="ignore", invalid="ignore")
def channel(
    values: NDArray[np.float64], *, header: str, unit: str | None = None, taken_for: str | None = None
) -> Channel:
    """Describe one column.

    Parameters
    ----------
    values : (n,) float64     in the file's own unit; what is not finite is missing
    header, unit, taken_for   see `Channel`
    """
    finite = values[np.isfinite(values)]
    named = {"header": header, "unit": unit, "taken_for": taken_for}
    if not finite.size:
        return Channel(**named, missing=1.0)
    changed = np.diff(finite) != 0
    hold = usual_hold(changed)
    resolution = grid_step(finite)
    noise, bound = _noise(finite, changed, hold, resolution)
    low, high = float(finite.min()), float(finite.max())
    return Channel(
        **named,
        missing=1.0 - finite.size / values.size,
        low=low,
        high=high,
        mean=float(np.clip(_mean(finite), low, high)),
        noise=noise,
        noise_is_bound=bound,
        fresh=float(np.mean(changed)) if changed.size else 0.0,
        hold=hold,
        resolution=resolution,
        cut_low=_cut(finite, low, resolution),
        cut_high=_cut(finite, high, resolution),
    )


def _mean(finite: NDArray[np.float64]) -> float:
    """Mean of values that may be as large as a float can hold."""
    scale = float(np.abs(finite).max()) or 1.0
    return float(np.mean(finite / scale)) * scale


def usual_hold(changed: NDArray[np.bool_]) -> int:
    """Rows from one change to the next: the median hold, which a parked car does not lengthen."""
    at = np.flatnonzero(changed)
    return max(1, int(np.median(np.diff(at)))) if at.size > 2 else 1


def grid_step(finite: NDArray[np.float64]) -> float | None:
    """Step of the grid that readings lie on; None where they lie on none that shows.

    Small changes are divided by the smallest usual one: on a grid the quotients are whole.
    """
    steps = np.abs(np.diff(finite))
    steps = steps[(steps > 0) & np.isfinite(steps)]
    if steps.size < FEWEST_STEPS:
        return None
    for share in SMALLEST:
        step = _common_step(steps, float(np.quantile(steps, share)))
        if step is not None:
            return step
    return None


def _common_step(steps: NDArray[np.float64], first: float) -> float | None:
    """The step near ``first`` of which the small steps are multiples; None where they are not."""
    near = steps[steps < LARGEST_STEP * first]
    if near.size < FEWEST_STEPS:
        return None
    whole = np.maximum(np.round(near / first), 1.0)
    step = float((near @ whole) / (whole @ whole))
    if not 0 < step < np.inf:
        return None
    off = np.abs(near / step - np.round(near / step))
    return step if np.mean(off < 0.1) >= ON_GRID else None


def _noise(
    finite: NDArray[np.float64], changed: NDArray[np.bool_], hold: int, resolution: float | None
) -> tuple[float | None, bool]:
    """White noise of a reading, and whether that is only a bound.

    Second and fourth differences tell the same noise where the signal is smooth; where they do
    not, the smaller one is the better bound.
    """
    if finite.size < FEWEST:
        return None, False
    held = hold > 1 or np.mean(changed) < HELD
    readings = finite[1:][changed] if held else finite
    if readings.size < FEWEST:
        return None, False
    second = _spread(np.diff(readings, 2)) / SECOND
    fourth = _spread(np.diff(readings, 4)) / FOURTH
    least = (resolution or 0.0) / np.sqrt(12.0)
    noise = float(max(min(second, fourth), least))
    if not np.isfinite(noise):
        return None, False
    return noise, bool(fourth < ALIKE * second)


def _spread(differences: NDArray[np.float64]) -> float:
    return MAD_TO_STD * float(np.median(np.abs(differences)))


def _cut(finite: NDArray[np.float64], extreme: float, resolution: float | None) -> float:
    """Share of the rows at an extreme, where it is held often enough to be a limit; else 0.

    A rounded sine comes back to its peak, too, but spends as long in the three steps below it.
    """
    if extreme == 0:  # standing still, straight ahead
        return 0.0
    there = finite == extreme
    near = np.count_nonzero(np.abs(finite - extreme) < 3.5 * (resolution or 0.0))
    if near > PEAKED * np.count_nonzero(there):
        return 0.0
    visits = int(np.count_nonzero(np.diff(there.astype(np.int8)) == 1)) + int(there[0])
    share = float(np.mean(there))
    return share if LIMIT_SHARE <= share <= 0.5 and visits >= LIMIT_VISITS else 0.0
