"""A yaw rate whose small values were set to zero: one number that stands again and again, and nearly alone.

    set to zero:   0 where |x| < d, else x               a hole round the number
    subtracted:    sign(x) max(|x| - d, 0)               no hole, and what is larger is short by d

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
ALONE = 10.0  # times the rows of the next frequent number: no noisy sensor has a favourite
VISITS = 10  # comings back to the number; a stuck sensor comes once
LONGEST = 0.5  # of its rows in one stretch


@dataclass(frozen=True)
class DeadBand:
    """The number that stands for all small ones, half the width of the hole, and the share of the rows.

    Without a hole (width 0) the band was subtracted from what is larger.
    """

    value: float
    width: float
    share: float


def dead_band(x: np.ndarray) -> DeadBand | None:
    """The dead band of a signal (n,), NaN where missing; None where no number stands out."""
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
    width = _hole(away, piled)
    if not width and not _is_favourite(x, value, np.delete(counts, most)):
        return None
    return DeadBand(value, width, piled / x.size)


def _hole(away: np.ndarray, piled: int) -> float:
    """Half the width of the hole round a number, from the sorted distances (m,) of others; 0 without one."""
    width = float(away[int(NEAREST * away.size)]) * (1 - 1e-9)
    inside, twice = np.searchsorted(away, [width, 2 * width])
    beside = int(twice - inside)
    if beside < max(FEWEST, EMPTY * inside) or piled < FILLED * beside:
        return 0.0
    if float(np.diff(np.r_[width, away[inside:twice], 2 * width]).max()) > WIDEST * width:
        return 0.0  # the readings lie on a grid that is as wide as the hole
    return width


def _is_favourite(x: np.ndarray, value: float, others: np.ndarray) -> bool:
    """Whether a signal comes back to one number again and again, and to no other."""
    there = x == value
    if not x.min() < value < x.max() or np.count_nonzero(there) < ALONE * others.max():
        return False
    edges = np.flatnonzero(np.diff(np.r_[False, there, False].astype(np.int8)))
    lengths = edges[1::2] - edges[::2]
    return lengths.size >= VISITS and lengths.max() <= LONGEST * lengths.sum()


def dead_rows(x: np.ndarray) -> np.ndarray:
    """Rows (n,) that hold the number which stands for all small ones; none where it was subtracted."""
    found = dead_band(x)
    return np.zeros(x.size, dtype=bool) if found is None or not found.width else x == found.value
