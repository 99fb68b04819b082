"""Robust lines between two columns of logarithms: total least squares, proportion, straight line.

    power        ln y = c + p ln x    orthogonal residuals, both groups scatter
    proportion   y = k x              p = 1: k from the ratios alone
    line         y = k x + i          relative residuals

Each is fitted to rows within 3 robust sds of a first line through the densest half, so that a tenth
of wrong rows moves nothing; intervals are by bootstrap of rows.

Invariant: all functions take (n,) finite arrays and give the same answer for the same arrays.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

TRIES = 300  # pairs of rows tried as the first line
WIDTH = 3.0  # robust sds beyond which a row is left out of a line
FEWEST = 8  # rows below which only the proportion is fitted
CLEARLY = 0.9  # scatter of a form with one more coefficient, over that of the simpler, that makes it worth it
DRAWS = 400  # of the bootstrap
MAD = 1.4826  # sd of a normal distribution over its median absolute deviation


@dataclass(frozen=True, eq=False)
class Fit:
    """One fitted relation between two groups.

    Parameters
    ----------
    kind : str               "power" or "line"
    coefficients : dict      name -> value; the first is the slope
    intervals : dict         name -> (low, high), 95 %
    scatter : float          robust sd of ln y about it [-]
    kept : (n,) bool         rows it was fitted to
    """

    kind: str
    coefficients: dict[str, float]
    intervals: dict[str, tuple[float, float]]
    scatter: float
    kept: NDArray[np.bool_]

    def predict(self, x: NDArray) -> NDArray:
        """ln y of ln x."""
        c = self.coefficients
        if self.kind == "power":
            return np.log(c["factor"]) + c["exponent"] * x
        return np.log(np.maximum(c["slope"] * np.exp(x) + c["intercept"], 1e-300))


def robust_sd(values: NDArray) -> float:
    """Sd by the median absolute deviation."""
    return float(MAD * np.median(np.abs(values - np.median(values))))


def fit_pair(x: NDArray, y: NDArray, *, draws: int = DRAWS) -> Fit:
    """The simplest of proportion, power law and straight line that the rows do not contradict.

    Parameters
    ----------
    x, y : (n,) logarithms of two groups, n >= 3.

    Returns
    -------
    Fit      a proportion (kind "line", intercept 0) unless another form scatters clearly less.
    """
    kept = _near_a_line(x, y)
    best = proportion(x, y, draws=draws)
    if len(x) < FEWEST:
        return best
    for other in (_power(x, y, kept, draws), _line(x, y, kept, draws)):
        low, high = other.intervals.get("exponent", (np.inf, np.inf))
        holds_one = low <= 1.0 <= high
        if not holds_one and other.scatter < CLEARLY * best.scatter:
            best = other
    return best


def proportion(x: NDArray, y: NDArray, *, draws: int = DRAWS) -> Fit:
    """y = k x, from the ratios."""
    ratio = y - x
    spread = max(robust_sd(ratio), 1e-12)
    kept = np.abs(ratio - np.median(ratio)) <= WIDTH * spread
    drawn = _draw(int(kept.sum()), draws)
    means = ratio[kept][drawn].mean(axis=1)
    slope, ends = np.exp(ratio[kept].mean()), np.exp(_ends(means, ratio[kept].mean(), int(kept.sum())))
    return Fit("line", {"slope": float(slope), "intercept": 0.0}, {"slope": ends}, _sd(ratio[kept]), kept)


def total_least_squares(x: NDArray, y: NDArray) -> tuple[float, float]:
    """Slope and intercept of the line with least orthogonal distance; arrays (..., n) give (...,)."""
    mx, my = x.mean(axis=-1), y.mean(axis=-1)
    u, v = x - mx[..., None], y - my[..., None]
    xx, yy, xy = (u * u).sum(axis=-1), (v * v).sum(axis=-1), (u * v).sum(axis=-1)
    slope = np.tan(0.5 * np.arctan2(2 * xy, xx - yy))
    return slope, my - slope * mx


def out_of_sample(x: NDArray, y: NDArray, fit: Fit) -> float:
    """Robust sd of ln y predicted for rows that the line was not fitted to (ten parts) [-]."""
    n = len(x)
    parts = np.array_split(np.random.default_rng(1).permutation(n), min(n, 10))
    errors = np.full(n, np.nan)
    for part in parts:
        rest = np.setdiff1d(np.arange(n), part)
        if len(rest) < 3:
            return float("nan")
        again = _again(fit, x[rest], y[rest])
        errors[part] = y[part] - again.predict(x[part])
    return float(MAD * np.median(np.abs(errors)))


def _again(fit: Fit, x: NDArray, y: NDArray) -> Fit:
    if fit.kind == "line" and fit.coefficients["intercept"] == 0.0:
        return proportion(x, y, draws=2)
    kept = _near_a_line(x, y)
    return _power(x, y, kept, 2) if fit.kind == "power" else _line(x, y, kept, 2)


def _near_a_line(x: NDArray, y: NDArray) -> NDArray:
    """Rows near the line through two rows whose median orthogonal distance is least."""
    n, rng = len(x), np.random.default_rng(0)
    if n < 8:
        return np.ones(n, dtype=bool)
    i, j = rng.integers(0, n, (2, TRIES))
    angle = np.arctan2(y[j] - y[i], x[j] - x[i])
    angle = np.where(i == j, np.pi / 4, angle)
    sine, cosine = np.sin(angle)[:, None], np.cos(angle)[:, None]
    away = np.abs((y - y[i][:, None]) * cosine - (x - x[i][:, None]) * sine)
    best = int(np.argmin(np.median(away, axis=1)))
    kept = away[best] <= WIDTH * MAD * max(np.median(away[best]), 1e-12)
    for _ in range(5):
        slope, intercept = total_least_squares(x[kept], y[kept])
        distance = (y - slope * x - intercept) / np.hypot(1, slope)
        kept = np.abs(distance) <= WIDTH * max(MAD * np.median(np.abs(distance)), 1e-12)
    return kept


def _power(x: NDArray, y: NDArray, kept: NDArray, draws: int) -> Fit:
    drawn = _draw(int(kept.sum()), draws)
    slope, intercept = total_least_squares(x[kept], y[kept])
    slopes, intercepts = total_least_squares(x[kept][drawn], y[kept][drawn])
    n = int(kept.sum())
    coefficients = {"exponent": float(slope), "factor": float(np.exp(np.clip(intercept, -700, 700)))}
    ends = np.exp(np.clip(_ends(intercepts, intercept, n), -700, 700))  # a level line has any intercept
    intervals = {"exponent": _ends(slopes, slope, n), "factor": (float(ends[0]), float(ends[1]))}
    return Fit("power", coefficients, intervals, _sd(y[kept] - slope * x[kept] - intercept), kept)


def _line(x: NDArray, y: NDArray, kept: NDArray, draws: int) -> Fit:
    X, Y = np.exp(x[kept]), np.exp(y[kept])
    slope, intercept = _relative_line(X, Y)
    drawn = _draw(len(X), draws)
    slopes, intercepts = _relative_line(X[drawn], Y[drawn])
    with np.errstate(invalid="ignore", divide="ignore"):
        away = np.log(Y / (slope * X + intercept))
    away = np.where(np.isfinite(away), away, 10.0)
    n = len(X)
    return Fit(
        "line",
        {"slope": float(slope), "intercept": float(intercept)},
        {"slope": _ends(slopes, slope, n), "intercept": _ends(intercepts, intercept, n)},
        _sd(away),
        kept,
    )


def _relative_line(X: NDArray, Y: NDArray) -> tuple[NDArray, NDArray]:
    """Least squares of (k X + i)/Y = 1."""
    a, b = X / Y, 1 / Y
    aa, bb, ab = (a * a).sum(axis=-1), (b * b).sum(axis=-1), (a * b).sum(axis=-1)
    a1, b1 = a.sum(axis=-1), b.sum(axis=-1)
    det = np.maximum(aa * bb - ab * ab, 1e-300)
    return (a1 * bb - b1 * ab) / det, (b1 * aa - a1 * ab) / det


def _draw(n: int, draws: int) -> NDArray:
    return np.random.default_rng(2).integers(0, n, (draws, n))


def _ends(drawn: NDArray, value: float, n: int) -> tuple[float, float]:
    """95 % of the draws about the value, wider where few rows make a bootstrap too sure."""
    drawn = drawn[np.isfinite(drawn)]
    if len(drawn) < 2:
        return float("-inf"), float("inf")
    from scipy.stats import t

    wider = t.ppf(0.975, max(n - 1, 1)) / 1.959964 * np.sqrt(n / max(n - 1, 1))
    low, high = np.percentile(drawn, (2.5, 97.5))
    return float(value + wider * (low - value)), float(value + wider * (high - value))


def _sd(values: NDArray) -> float:
    return float(
        np.sqrt(
            (values**2).sum() / max(len(values) - 1, 1)
            - values.mean() ** 2 * len(values) / max(len(values) - 1, 1)
        )
    )
