"""Whether two sums of logarithms belong together more than a shared base makes them.

Groups that share m, L and U correlate although nothing ties their own parameters. The null is that the
raw parameters are independent given the base: each sum is taken of the groups' own parameters, what
the base explains of it is taken out, and the rest is permuted over rows. A permutation has the
distribution of normal scores' correlation, which for 20 rows and more is that of Student to within what
matters; below it is drawn.

Invariant: under independent raw parameters a probability is uniform, whatever the base.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

FEWEST = 4  # rows below which there is nothing to permute
ROWS_PER_BASE = 4  # rows that each parameter of the base costs before it is taken out
DRAWN = 4000  # permutations where there are fewer than 20 rows


def probability(one: NDArray, other: NDArray, base: NDArray, *, opposite: bool = False) -> tuple[float, bool]:
    """Probability of such a correlation if independent given the base.

    Parameters
    ----------
    one, other : (n,) sums of logarithms of own parameters.    base : (n, k) logarithms.
    opposite : count only a negative correlation.

    Returns
    -------
    probability : 1 below four rows.    whether the base was taken out.
    """
    n, k = base.shape
    if n < FEWEST or np.ptp(one) < 1e-12 or np.ptp(other) < 1e-12:
        return 1.0, False
    given_base = n >= ROWS_PER_BASE * (k + 1)
    if given_base:
        one, other = _without(one, base), _without(other, base)
    if n < 20:
        return _by_permutation(one, other, opposite), given_base
    from scipy.stats import norm, rankdata, t

    a, b = (norm.ppf((rankdata(v) - 0.5) / n) for v in (one, other))
    r = float(a @ b / np.sqrt(a @ a * (b @ b)))
    df = n - 2 - (k if given_base else 0)
    x = r * np.sqrt(df / max(1 - r * r, 1e-300))
    return float(t.cdf(x, df) if opposite else 2 * t.sf(abs(x), df)), given_base


def discoveries(p: NDArray, level: float) -> NDArray:
    """Adjusted probabilities (Benjamini & Hochberg): those at most `level` are discoveries.

    Parameters
    ----------
    p : (tests,) probabilities.    level : share of false ones among discoveries that is accepted.
    """
    if not len(p):
        return p
    order = np.argsort(p)
    scaled = p[order] * len(p) / np.arange(1, len(p) + 1)
    adjusted = np.empty(len(p))
    adjusted[order] = np.minimum(np.minimum.accumulate(scaled[::-1])[::-1], 1.0)
    return adjusted


def _without(y: NDArray, base: NDArray) -> NDArray:
    """What the base does not explain, by least squares in which far rows hardly count (bisquare)."""
    X = np.column_stack([np.ones(len(y)), base])
    weight = np.ones(len(y))
    for _ in range(10):
        rooted = np.sqrt(weight)
        coefficients = np.linalg.lstsq(X * rooted[:, None], y * rooted, rcond=None)[0]
        away = y - X @ coefficients
        scale = 4.685 * max(1.4826 * float(np.median(np.abs(away))), 1e-12)
        weight = np.clip(1 - (away / scale) ** 2, 1e-6, None) ** 2
    return away


def _by_permutation(one: NDArray, other: NDArray, opposite: bool) -> float:
    n = len(one)
    if n <= 7:
        orders = np.array(list(itertools.permutations(range(n))))
    else:
        orders = np.random.default_rng(0).permuted(np.tile(np.arange(n), (DRAWN, 1)), axis=1)
    a, b = one - one.mean(), other - other.mean()
    seen = float(a @ b)
    drawn = a @ b[orders].T
    tol = 1e-12 * float(np.sqrt(a @ a * (b @ b)))
    extreme = drawn <= seen + tol if opposite else np.abs(drawn) >= abs(seen) - tol
    return float((extreme.sum() + (0 if n <= 7 else 1)) / (len(orders) + (0 if n <= 7 else 1)))
