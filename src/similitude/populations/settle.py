"""Repeats a slow improvement of means and covariance until it settles, with leaps.

Where five rows of four hundred know an unknown, expectation and maximisation move its mean by an
eightieth of the way a pass. Two passes show where the moves lead; the leap goes there (Varadhan & Roland
2008, scheme S3), for the covariance along exp and log of matrices, so that it stays positive.

Invariant: what is handed out has come out of the improvement itself, never out of a leap.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

CLOSE = 1e-4  # change of means and sds in one pass, in sds, at which it has settled
LONGEST = 64.0  # passes that one leap may stand for

Improvement = Callable[[NDArray, NDArray, NDArray], tuple[NDArray, NDArray, NDArray]]


def settle(
    improve: Improvement, means: NDArray, S: NDArray, rows: NDArray, passes: int
) -> tuple[NDArray, NDArray, NDArray]:
    """Improve until settled.

    Parameters
    ----------
    improve : (means, S, rows) -> the same, better.
    means : (n, d).    S : (d, d).    rows : whatever `improve` carries along.
    passes : calls of `improve` at most.

    Returns
    -------
    means, S, rows
    """
    longest, last, done = 4.0, np.inf, 0
    while done < passes:
        one, S1, rows = improve(means, S, rows)
        two, S2, rows = improve(one, S1, rows)
        done += 2
        root, back = _roots(S)
        first, second = _log(back @ S1 @ back), _log(back @ S2 @ back)
        scale = np.sqrt(np.diag(S))
        moves = [(one - means) / scale, (two - one) / scale]
        size = max(np.abs(moves[1]).max(), np.abs(np.diag(second - first)).max() / 2)
        if size < CLOSE:
            return two, S2, rows
        bend = np.sqrt(((moves[1] - moves[0]) ** 2).max(axis=0).sum() + ((second - 2 * first) ** 2).sum())
        straight = np.sqrt((moves[0] ** 2).max(axis=0).sum() + (first**2).sum())
        longest = min(2 * longest, LONGEST) if size < last else 4.0
        leap = float(np.clip(straight / max(bend, 1e-12), 1.0, longest))
        last = size
        means = means + scale * (2 * leap * moves[0] + leap**2 * (moves[1] - moves[0]))
        S = root @ _exp(2 * leap * first + leap**2 * (second - 2 * first)) @ root
        S = 0.5 * (S + S.T)
        means, S, rows = improve(means, S, rows)
        done += 1
    return means, S, rows


def _roots(S: NDArray) -> tuple[NDArray, NDArray]:
    """Symmetric square root, and its inverse."""
    values, vectors = np.linalg.eigh(S)
    values = np.sqrt(np.maximum(values, 1e-16 * values.max()))
    return (vectors * values) @ vectors.T, (vectors / values) @ vectors.T


def _log(S: NDArray) -> NDArray:
    values, vectors = np.linalg.eigh(0.5 * (S + S.T))
    return (vectors * np.log(np.maximum(values, 1e-12))) @ vectors.T


def _exp(S: NDArray) -> NDArray:
    values, vectors = np.linalg.eigh(0.5 * (S + S.T))
    return (vectors * np.exp(np.clip(values, -6, 6))) @ vectors.T
