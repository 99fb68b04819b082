"""A Gaussian over a population's coordinates, fitted to rows that each know something.

    z_i ~ N(mean, S)      y_i = E_i ln p(z_i) + noise      E_i exponents of what row i knows

Expectation: z_i given y_i, the curved part of ln p linearised where z_i is (one Newton step an
iteration, so the fixed point is the row's most probable z). Maximisation: weighted moments of the
expectations, with the distance of a row beyond what 97.5 % of a normal population shows cut down
(Little & Smith 1987, Huber's function), and the covariance drawn towards its own diagonal as if d + 2 more
systems had been seen without any correlation.

Many wrong rows together hide one another from such a rule. So rows that lie impossibly far from the median
of one coordinate, by the median deviation of 20 rows or more, count nothing from the start.

Tables that were joined may hold systems of other sizes (vans of one country, pickups of another): the
means of the base are each table's own, those of the groups are shared. Else a b of one table and L of the
other would say something about a/L that is only their difference in size.

For the same reason a row that knows a b but neither a nor L teaches L and not a/L (near one half, where a b
hardly depends on it): what it would say about a/L rests on how L scatters among vehicles that state L.

A coordinate that no row teaches is held: a share at one half, anything else at one. What follows from
it is then as good as that guess (a b hardly depends on a/L), and `count` says that nobody taught it.

Invariant: no row is dropped.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.populations.coordinates import Coordinates
from similitude.populations.settle import settle
from similitude.populations.table import PopulationTable

ROUNDING = 1e-4  # relative sd of a value whose sd nobody stated: a table of four digits
TAIL = 0.975  # share of a normal population inside the distance at which rows begin to count less
SCREEN = (3.0, 4.5)  # robust sds of one coordinate between which a row loses all its weight
ROWS_TO_SCREEN = 20  # rows that must tell a coordinate before it can condemn one
PASSES = 300  # of expectation and maximisation, at most
FEWEST = 1.5  # systems that must teach a coordinate; else it is held where it began
ROWS_TO_DOUBT = 5  # rows for each coordinate, from which on far rows count less
HELD = 1e-6  # variance of a coordinate that is held


@dataclass(frozen=True, eq=False)
class Gaussian:
    """Distribution of the coordinates.

    Parameters
    ----------
    mean : (d,)     covariance : (d, d), of the population as it was seen
    means : (n, d)  mean of the table that each row is of
    count : (d,)    systems that taught each coordinate, a row that half knows it counting half [-]
    rows : (n, d)   coordinates of each row given what it knows; spread : (n, d, d) what it leaves open
    distance : (n,) squared distance of what a row knows from the mean, in sds; known : (n,) columns
    """

    mean: NDArray[np.float64]
    covariance: NDArray[np.float64]
    count: NDArray[np.float64]
    rows: NDArray[np.float64]
    spread: NDArray[np.float64]
    distance: NDArray[np.float64]
    known: NDArray[np.int64]
    means: NDArray[np.float64]

    @property
    def predictive(self) -> NDArray[np.float64]:
        """Covariance (d, d) of the next system: wider than the population's by what few rows leave open.

        With n rows, mean and variance estimated, a new value is t-distributed; the Gaussian of the
        same variance is handed out. Below five rows that variance is that of five.
        """
        n = np.maximum(self.count, 5.0)
        wider = np.sqrt((1 + 1 / n) * (n - 1) / (n - 3))
        return self.covariance * np.outer(wider, wider)


@dataclass(frozen=True, eq=False)
class _Pattern:
    """Rows that know the same columns."""

    index: NDArray[np.int64]
    exponents: NDArray[np.float64]  # (k, p)
    y: NDArray[np.float64]  # (rows, k)
    noise: NDArray[np.float64]  # (rows, k) variances
    blind: tuple[int, ...]  # shares that these columns do not determine


def fit_gaussian(
    table: PopulationTable, space: Coordinates, *, start: Gaussian | None = None, passes: int = PASSES
) -> Gaussian:
    """Fit mean and covariance.

    Parameters
    ----------
    table : n rows.    space : Coordinates of its model.
    start : where to begin, such as the fit of nearly the same rows.
    passes : at most so many.

    Returns
    -------
    Gaussian
    """
    patterns, n = _patterns(table, space), len(table)
    strata = np.zeros(n, dtype=np.int64) if table.stratum is None else table.stratum
    weight = table.weight * screened(patterns, space, table.weight)
    mean, S = _begin(patterns, space) if start is None else (start.mean, start.covariance)
    wide = np.diag(np.maximum(np.diag(S), 1e-4))
    held = _taught(patterns, space, weight, np.tile(mean, (n, 1)), wide) < FEWEST
    means = np.tile(mean, (n, 1)) if start is None or len(start.means) != n else start.means
    means, S = np.where(held, 0.0, means), _hold(S, held)
    rows = means

    def improve(means: NDArray, S: NDArray, rows: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        rows, spread, distance = _expect(patterns, space, means, S, rows)
        new, new_S = _maximise(patterns, weight, strata, space, means, S, (rows, spread, distance))
        return np.where(held, means, new), _hold(new_S, held), rows

    means, S, rows = settle(improve, means, S, rows, passes)
    rows, spread, distance = _expect(patterns, space, means, S, rows)
    count = np.where(held, 0.0, _taught(patterns, space, weight, means, np.diag(np.diag(S))))
    mean = weight @ means / weight.sum()
    known = np.isfinite(table.value).sum(axis=1)
    return Gaussian(
        mean, S + _between(means, mean, table.weight), count, rows, spread, distance, known, means
    )


def _between(means: NDArray, mean: NDArray, weight: NDArray) -> NDArray:
    """What the tables' different sizes add to the covariance of all."""
    away = means - mean
    return np.einsum("n,nd,ne->de", weight, away, away) / weight.sum()


def _taught(patterns: Sequence[_Pattern], space: Coordinates, weight: NDArray, means: NDArray, S: NDArray):
    """Systems that teach each coordinate (d,) by what they know themselves: S without correlations."""
    _, spread, _ = _expect(patterns, space, means, S, means)
    return (1 - np.einsum("njj->nj", spread) / np.diag(S)).T @ weight


def _hold(S: NDArray, held: NDArray) -> NDArray:
    """The covariance with held coordinates all but known and independent."""
    free = np.outer(~held, ~held)
    return np.where(free, S, 0.0) + HELD * np.diag(held.astype(float))


def _patterns(table: PopulationTable, space: Coordinates) -> list[_Pattern]:
    exponents, fixed = space.exponents(table.products)
    known = np.isfinite(table.value)
    with np.errstate(invalid="ignore"):
        relative = np.where(np.isfinite(table.sd), table.sd / table.value, 0.0)
        y, noise = np.log(table.value) - fixed, np.maximum(relative, ROUNDING) ** 2
    found = []
    for pattern in np.unique(known, axis=0):
        index = np.flatnonzero((known == pattern).all(axis=1))
        if pattern.any():
            block = np.ix_(index, pattern)
            blind = _blind(space, exponents[pattern])
            found.append(_Pattern(index, exponents[pattern], y[block], noise[block], blind))
    return found


def _blind(space: Coordinates, exponents: NDArray) -> tuple[int, ...]:
    """Shares that cannot be worked out from products with these exponents."""
    slopes = exponents @ space.slopes(np.full(len(space.names), 0.3))  # any point will do
    told = np.linalg.pinv(slopes) @ slopes
    return tuple(k for k in space.shares if told[k, k] < 1 - 1e-6)


def _begin(patterns: Sequence[_Pattern], space: Coordinates) -> tuple[NDArray, NDArray]:
    """Median and robust variance of what rows themselves tell of each coordinate."""
    mean, spread = np.zeros(len(space.names)), np.ones(len(space.names))
    for _ in range(4):  # the median moves where ln p is linearised
        for k, told in enumerate(_told(patterns, space, mean)):
            if told:
                x = np.concatenate([z for _, z, _ in told])
                mean[k] = np.median(x)
                spread[k] = _robust_sd(x) if len(x) >= ROWS_TO_SCREEN else x.std()
    return mean, np.diag(np.maximum(spread, 1e-2) ** 2)


def _told(
    patterns: Sequence[_Pattern], space: Coordinates, mean: NDArray
) -> list[list[tuple[NDArray, NDArray, NDArray]]]:
    """For each coordinate, rows that tell it by themselves, what they say, and its sd."""
    found: list[list[tuple[NDArray, NDArray, NDArray]]] = [[] for _ in mean]
    for p in patterns:
        H = p.exponents @ space.slopes(mean)
        H[:, p.blind] = 0.0
        back = np.linalg.pinv(H)
        z = mean + (p.y - p.exponents @ space.logs(mean)) @ back.T
        noise = np.sqrt(p.noise @ back.T**2)
        for k in np.flatnonzero(np.abs(np.diag(back @ H) - 1) < 1e-6):
            found[k].append((p.index, z[:, k], noise[:, k]))
    return found


def screened(patterns: Sequence[_Pattern], space: Coordinates, counts: NDArray) -> NDArray:
    """Weights (n,) of rows: 0 where one of many rows lies impossibly far out, 1 elsewhere.

    ``counts`` (n,): what each row counts; copies prove nobody else wrong.
    """
    weight = np.ones(len(counts))
    mean, _ = _begin(patterns, space)
    for told in _told(patterns, space, mean):
        if sum(counts[index].sum() for index, *_ in told) >= ROWS_TO_SCREEN:
            index, z, noise = (np.concatenate(parts) for parts in zip(*told, strict=True))
            centre = _weighted_median(z, counts[index])
            spread = 1.4826 * _weighted_median(np.abs(z - centre), counts[index])
            far = np.abs(z - centre) / np.hypot(max(spread, 1e-2), noise)
            low, high = SCREEN
            weight[index] *= (1 - np.clip((far - low) / (high - low), 0, 1) ** 2) ** 2
    return weight


def _weighted_median(x: NDArray, weight: NDArray) -> float:
    order = np.argsort(x)
    passed = np.cumsum(weight[order])
    return float(x[order][np.searchsorted(passed, 0.5 * passed[-1])])


def _robust_sd(x: NDArray) -> float:
    return float(1.4826 * np.median(np.abs(x - np.median(x))))


def _expect(
    patterns: Sequence[_Pattern], space: Coordinates, means: NDArray, S: NDArray, rows: NDArray
) -> tuple[NDArray, NDArray, NDArray]:
    """Coordinates of each row given what it knows, their covariances, and squared distances."""
    n = len(rows)
    z, spread, distance = means.copy(), np.tile(S, (n, 1, 1)), np.zeros(n)
    for p in patterns:
        at, mean = rows[p.index], means[p.index]
        H = p.exponents @ space.slopes(at)  # (rows, k, d)
        H[:, :, p.blind] = 0.0
        away = p.y - space.logs(at) @ p.exponents.T - np.einsum("nkd,nd->nk", H, mean - at)
        HS = H @ S
        inner = HS @ H.transpose(0, 2, 1) + p.noise[:, :, None] * np.eye(p.y.shape[1])
        solved = np.linalg.solve(inner, np.concatenate([HS, away[:, :, None]], axis=2))
        gain = solved[:, :, :-1].transpose(0, 2, 1)
        z[p.index] = mean + np.einsum("ndk,nk->nd", gain, away)
        spread[p.index] = S - gain @ HS
        distance[p.index] = np.einsum("nk,nk->n", away, solved[:, :, -1])
    return z, spread, distance


def _maximise(
    patterns: Sequence[_Pattern], weight: NDArray, strata: NDArray, space: Coordinates, means: NDArray,
    S: NDArray, expected: tuple[NDArray, NDArray, NDArray],
) -> tuple[NDArray, NDArray]:  # fmt: skip
    """Weighted moments of the expectations; far rows count less, consistently for normal ones."""
    rows, spread, distance = expected
    pull, square = np.ones(len(weight)), np.ones(len(weight))
    if len(weight) >= ROWS_TO_DOUBT * rows.shape[1]:
        for p in patterns:
            limit, kept = _huber(p.y.shape[1])
            far = np.maximum(distance[p.index], 1e-12)
            pull[p.index] = np.minimum(1.0, np.sqrt(limit / far))
            square[p.index] = np.minimum(1.0, limit / far) / kept
    new_means = _means(weight * pull, strata, space, means, S, rows)
    away, total = rows - new_means, weight.sum()
    inside = np.einsum("n,nd,ne->de", weight * square, away, away)
    S = (inside + np.einsum("n,nde->de", weight, spread)) / total
    shrink = rows.shape[1] + 2.0
    S = (total * S + shrink * np.diag(np.diag(S))) / (total + shrink)
    return new_means, 0.5 * (S + S.T)


def _means(
    weight: NDArray, strata: NDArray, space: Coordinates, means: NDArray, S: NDArray, rows: NDArray
) -> NDArray:
    """Most probable means (n, d): of groups over all rows, of sizes over those of each table."""
    away = weight @ (rows - means) / weight.sum()
    sizes = list(space.sizes)
    if not sizes or strata.max() == 0:
        return means + away
    groups = [k for k in range(rows.shape[1]) if k not in sizes]
    by_group = np.linalg.solve(S[np.ix_(groups, groups)], S[np.ix_(groups, sizes)])
    result = means.copy()
    result[:, groups] += away[groups]
    for s in np.unique(strata):
        mine = strata == s
        if weight[mine].sum() <= 0:
            continue
        w = weight[mine] / weight[mine].sum()
        own = w @ (rows[mine] - result[mine])
        result[np.ix_(mine, sizes)] += own[sizes] - own[groups] @ by_group
    return result


_HUBER: dict[int, tuple[float, float]] = {}


def _huber(k: int) -> tuple[float, float]:
    """Squared distance at which rows of k columns count less, and the variance that is then left [-]."""
    if k not in _HUBER:
        from scipy.stats import chi2

        limit = float(chi2.ppf(TAIL, k))
        kept = chi2.cdf(limit, k + 2) + limit / k * (1 - TAIL)
        _HUBER[k] = limit, float(kept)
    return _HUBER[k]
