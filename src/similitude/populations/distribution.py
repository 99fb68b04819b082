"""How values are distributed: skewness and a test of normality, raw and in logarithms.

Invariant: the same rows in both spaces, so that only the space differs.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FEWEST = 8  # values below which neither skewness nor its test means anything


@dataclass(frozen=True)
class Distribution:
    """Moments of one quantity over n systems.

    Parameters
    ----------
    name : str            n : values
    mean_log, sd_log      of the natural logarithm; the median and the sd a robust reader wants too
    skew_raw, skew_log    third standardised moment [-], None below `FEWEST` values
    normal_raw, normal_log  probability of such skewness and tails if normal (D'Agostino & Pearson)
    below_zero            share of the raw values' normal fit that lies below zero [-]
    """

    name: str
    n: int
    mean_log: float
    sd_log: float
    median: float
    skew_raw: float | None = None
    skew_log: float | None = None
    normal_raw: float | None = None
    normal_log: float | None = None
    below_zero: float = 0.0


def describe(name: str, values: NDArray, weight: NDArray | None = None) -> Distribution | None:
    """Describe positive values; missing ones are NaN.

    Parameters
    ----------
    name : what they are.    values : (n,) positive or NaN.    weight : (n,), for mean and sd.

    Returns
    -------
    Distribution, or None where fewer than two values are known.
    """
    known = np.isfinite(values)
    x, n = values[known], int(known.sum())
    if n < 2:
        return None
    w = np.ones(n) if weight is None else weight[known]
    w = w / w.sum()
    logs = np.log(x)
    mean = float(w @ logs)
    sd = float(np.sqrt(w @ (logs - mean) ** 2 / max(1 - (w**2).sum(), 1e-9)))
    from scipy.stats import norm, normaltest, skew

    below = float(norm.cdf(0.0, x.mean(), max(x.std(ddof=1), 1e-300)))
    base = Distribution(name, n, mean, sd, float(np.median(x)), below_zero=below)
    if n < FEWEST or np.ptp(logs) < 1e-9:
        return base
    return Distribution(
        name, n, mean, sd, base.median, float(skew(x)), float(skew(logs)),
        float(normaltest(x).pvalue), float(normaltest(logs).pvalue), below,
    )  # fmt: skip
