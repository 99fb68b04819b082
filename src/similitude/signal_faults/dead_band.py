"""A yaw rate whose small values were set to zero: a hole round one number that stands again and again.

Invariant: values are never changed here.

    x any signal (n,);  c the number that stands again and again;  d half the width of the hole
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

LEAST_SHARE = 0.02  # of the rows that hold one and the same number
NEAREST = 0.01  # quantile of the distances from it: what lies nearer may be a glitch, or filled in
EMPTY = 5.0  # times as many values in the next width as in the hole
FEWEST = 40  # values in the next width, so that the hole is none of chance
WIDEST = 0.6  # of the hole, between two values beside it
FILLED = 0.3  # of what the next width holds, at least, stands at the number instead


@dataclass(frozen=True)
class DeadBand:
    """The number that stands for all small ones, half the width of the hole, and the share of the rows."""

    value: float
    width: float
    share: float


def dead_band(x: np.ndarray) -> DeadBand | None:
    """The hole of a signal (n,), NaN where missing; None where small values are as frequent as others."""
    x = x[np.isfinite(x)]
    if x.size < 10 * FEWEST:
        return None
    numbers, counts = np.unique(x, return_counts=True)
    most = int(np.argmax(counts))
    piled = int(counts[most])
    if piled < LEAST_SHARE * x.size:
        return None
    value = float(numbers[most])
    away = np.abs(x - value)
    away = np.sort(away[away > 0])
    if away.size < 2 * FEWEST:
        return None
    width = float(away[int(NEAREST * away.size)]) * (1 - 1e-9)
    inside, twice = np.searchsorted(away, [width, 2 * width])
    beside = int(twice - inside)
    if beside < max(FEWEST, EMPTY * inside) or piled < FILLED * beside:
        return None
    if float(np.diff(np.r_[width, away[inside:twice], 2 * width]).max()) > WIDEST * width:
        return None  # the readings lie on a grid that is as wide as the hole
    return DeadBand(value, width, piled / x.size)


def dead_rows(x: np.ndarray) -> np.ndarray:
    """Rows (n,) that hold the number which stands for all small ones."""
    found = dead_band(x)
    return np.zeros(x.size, dtype=bool) if found is None else x == found.value
