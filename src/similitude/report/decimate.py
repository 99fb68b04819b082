"""Long signals for a picture: every extreme stays, at most 4000 points are drawn.

Invariant: the smallest and the largest finite value of the signal, and its first and last sample's
buckets, are among the points kept; a line is broken where the signal has a gap.
"""

from __future__ import annotations

import numpy as np

BUCKETS = 1000  # two points and at worst two line breaks each: 4000 points


def decimate(t: np.ndarray, y: np.ndarray, buckets: int = BUCKETS) -> tuple[np.ndarray, np.ndarray]:
    """Reduce a line to its extremes.

    Parameters
    ----------
    t : (n,) time [s], increasing.
    y : (n,) signal, any unit; NaN where it was not measured.
    buckets : parts of equal sample count; of each the smallest and largest value stay.

    Returns
    -------
    (t, y)                   at most 4 * buckets points, NaN in y where the line is to be broken.
    """
    finite = np.isfinite(y)
    t, y = t[finite], y[finite]
    if t.size <= 2 * buckets:
        kept = np.arange(t.size)
    else:
        starts = np.linspace(0, t.size, buckets + 1).astype(np.intp)
        kept = _extremes(y, starts)
    if kept.size < 2:
        return t[kept], y[kept]
    breaks = _breaks(t, kept)
    return np.insert(t[kept], breaks, t[kept][breaks]), np.insert(y[kept], breaks, np.nan)


def envelope(
    t: np.ndarray, lower: np.ndarray, upper: np.ndarray, buckets: int = BUCKETS
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Reduce a band to the widest it is in each bucket: never narrower than the truth.

    Parameters
    ----------
    t : (n,) time [s].
    lower, upper : (n,) finite edges of the band, any unit.
    buckets : number of points kept.

    Returns
    -------
    (t, lower, upper)        at most 2 * buckets points each, NaN in the edges at a gap.
    """
    starts = np.arange(t.size)
    if t.size > buckets:
        starts = np.linspace(0, t.size, buckets + 1).astype(np.intp)[:-1]
        lower, upper = np.minimum.reduceat(lower, starts), np.maximum.reduceat(upper, starts)
        starts[-1] = t.size - 1
    breaks = _breaks(t, starts)
    edges = (np.insert(edge, breaks, np.nan) for edge in (lower, upper))
    return np.insert(t[starts], breaks, t[starts][breaks]), *edges


def shares(t: np.ndarray, mask: np.ndarray, buckets: int = BUCKETS) -> np.ndarray:
    """Say which share of the samples in each equal stretch of time is marked.

    Parameters
    ----------
    t : (n,) time [s], increasing.
    mask : (n,) bool.
    buckets : stretches of time, fewer when there are fewer than two samples for each.

    Returns
    -------
    (min(buckets, n // 2),)  shares in 0..1 [-]; 0 where there is no sample.
    """
    count = max(1, min(buckets, t.size // 2))
    span = max(float(t[-1] - t[0]), np.finfo(float).tiny)
    stretch = np.minimum(((t - t[0]) / span * count).astype(np.intp), count - 1)
    samples = np.bincount(stretch, minlength=count)
    marked = np.bincount(stretch, weights=mask, minlength=count)
    return marked / np.maximum(samples, 1)


def _extremes(y: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """Indices of the smallest and largest value between consecutive starts, in order of time."""
    width = int(np.diff(starts).max())
    rows = starts[:-1, None] + np.arange(width)
    outside = rows >= starts[1:, None]
    values = y[np.minimum(rows, y.size - 1)]
    low = starts[:-1] + np.where(outside, np.inf, values).argmin(axis=1)
    high = starts[:-1] + np.where(outside, -np.inf, values).argmax(axis=1)
    return np.unique(np.concatenate((low, high)))


def _breaks(t: np.ndarray, kept: np.ndarray) -> np.ndarray:
    """Positions among the kept samples before which time has a gap: > 0.25 s and > 8 steps."""
    if t.size < 2:
        return np.zeros(0, np.intp)
    step = np.diff(t)
    gap = step > max(0.25, 8.0 * float(np.median(step)))
    gaps_before = np.concatenate(([0], np.cumsum(gap)))[kept]
    return np.flatnonzero(np.diff(gaps_before)) + 1
