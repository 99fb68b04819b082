"""Batch fit: the most probable car, steer scale and steer lag for a whole log, and how sure that is.

Invariant: the data enter through innovations of the frozen filter alone, so the disturbance, the
steer offset and the yaw bias are integrated out exactly and not fitted.

First a damped Gauss-Newton climbs to the maximum of the posterior; the scales of noise and disturbance
are fitted between climbs and held during one, so that costs compare. A few Newton steps then solve

    sum_t  d_t e_t / S_t  +  prior's pull  =  0,      d_t = ∂e_t/∂x of a car that follows the steer alone

in place of the innovations' own slopes: gusts that are not as the filter takes them to be then teach
nothing, since the steer has no part in them. How the sum scatters between stretches of two seconds
says by how much the information is overstated.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.batch_pass import FrozenFilter
from similitude.batch_slopes import (
    SCALE_HIGH,
    SCALE_LOW,
    Whitened,
    fit_scales,
    slopes,
    steered_slopes,
    whiten,
)
from similitude.filter_config import LIMIT_SD, LIMIT_SD_TARGET, ROOM
from similitude.steer_lag import EARLIEST

RATE = 50.0  # rows a second, enough for the yaw mode of a car a tenth as long
LONG = 240.0  # s: a longer log has rows to spare ...
LONG_RATE = 25.0  # ... and a climb to its neighbourhood needs half as many
SCALE_STEPS = (3, 2)  # before the first climb and the second
ROUGH_RATE = 25.0  # rows a second of a climb that only chooses between fits
CLIMBS = 8  # Gauss-Newton steps, at most
POLISHES = 5
FLAT = 0.02  # of the log posterior: a fifth of an sd
SETTLED = 0.1  # sd
NEAR = 1.0  # sd: left to the finer rows of a long log, which settle it
LONGEST_STEP = 1.0  # of a coordinate: a factor e
BLOCK = 2.0  # s: innovations of a wrong model stay alike for less
NOTHING = 1e-12  # information too small to divide by


@dataclass(frozen=True)
class Halves:
    """ln K from either half of a log, the rest as fitted to the whole, and how far apart in sd."""

    first: float
    second: float
    apart: float


@dataclass(frozen=True, eq=False)
class BatchFit:
    """The car that explains a whole log best.

    ``x`` (6,) and ``covariance`` (6, 6) are of the coordinates of `batch_pass`;
    ``scales`` (2,) logarithms of the noise's and the disturbance's variance against nominal;
    ``zero`` steer offset [rad] and yaw bias [rad/s] with ``zero_std``; ``widened`` by how much the
    variance from the data was raised; ``settled`` whether the Newton steps came to rest;
    ``t`` and ``information`` (n,) rows of the fit [s] and what they told of ln K, cumulative.
    """

    frozen: FrozenFilter
    x: NDArray[np.float64]
    covariance: NDArray[np.float64]
    scales: NDArray[np.float64]
    zero: tuple[float, float]
    zero_std: tuple[float, float]
    widened: float
    settled: bool
    halves: Halves
    t: NDArray[np.float64]
    information: NDArray[np.float64]

    @property
    def std(self) -> NDArray[np.float64]:
        """Standard deviations of the coordinates, (6,)."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def values(self) -> dict[str, float]:
        """The unknowns by name [their units]."""
        return self.frozen.values(self.x)

    @property
    def lag_std(self) -> float:
        """Standard deviation of the steer lag [s]."""
        return (self.values["steer_lag"] + EARLIEST) * float(self.std[5])

    def correlation(self, name: str) -> float:
        """Of ln K with another coordinate [-]."""
        i = self.frozen.prior.names.index(name)
        return float(self.covariance[0, i] / (self.std[0] * self.std[i]))

    def slope(self, name: str) -> float:
        """Change of ln K per change of another coordinate, the rest being fitted anew [-]."""
        i = self.frozen.prior.names.index(name)
        return float(self.covariance[0, i] / self.covariance[i, i])

    def told(self, name: str) -> float:
        """Share of a coordinate's prior variance that the log itself has taken away, 0 to 1 [-]."""
        i = self.frozen.prior.names.index(name)
        return float(1 - self.covariance[i, i] / self.frozen.prior.covariance[i, i])

    def leans(self, name: str) -> float:
        """Change of ln K per error of what was stated of another coordinate before the log [-].

        That is its `slope` as far as the log does not tell the coordinate itself.
        """
        return self.slope(name) * (1 - self.told(name))


def fit_batch(frozen: FrozenFilter, start: NDArray[np.float64], scales: NDArray[np.float64]) -> BatchFit:
    """Fit a whole log.

    Parameters
    ----------
    frozen : FrozenFilter    with the log and the prior of the six coordinates.
    start : (6,)             coordinates to start from.
    scales : (2,)            logarithms of the scales of noise and disturbance to start from.

    References
    ----------
    docs/identify.md, "Batch fit".
    """
    long = frozen.setup.log.duration > LONG
    frozen = frozen.at_rate(LONG_RATE if long else RATE)
    low, high = coordinate_limits(frozen)
    x, s = np.clip(start, low, high), np.clip(scales, SCALE_LOW, SCALE_HIGH)
    rough = frozen.at_rate(LONG_RATE / 2) if long else frozen
    now = whiten(rough, x, s)
    for count in SCALE_STEPS:
        s, now = _fit_scales(rough, x, s, now, count)
        x, now = _climb(rough, x, s, now)
    at, widened, left = _polish(rough, x, s, now, NEAR if long else SETTLED)
    if long:
        s, now = _fit_scales(frozen, at.x, s, whiten(frozen, at.x, s), 1)
        at, widened, left = _polish(frozen, at.x, s, now, SETTLED)
    return _result(at, frozen, s, widened, settled=left < 1.0)


def climb_roughly(
    frozen: FrozenFilter, start: NDArray[np.float64], scales: NDArray[np.float64]
) -> tuple[NDArray[np.float64], float]:
    """The neighbourhood of the fit, in a tenth of its time: one climb over coarse rows, the scales held.

    Parameters
    ----------
    frozen, start, scales : as for `fit_batch`.

    Returns
    -------
    x : (6,)    where the climb ended.
    cost : float    of its innovations at `ROUGH_RATE` and of its distance from the prior [-].
    """
    frozen = frozen.at_rate(ROUGH_RATE)
    x, now = _climb(frozen, start, scales, whiten(frozen, start, scales))
    away = x - frozen.middle
    return x, now.cost + 0.5 * float(away @ _precision(frozen) @ away)


def _polish(
    frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], now: Whitened, enough: float
) -> tuple[_Point, float, float]:
    """Newton steps from x until less than enough sd are left: where, how overstated, and sd left."""
    low, high = coordinate_limits(frozen)
    at = _Point.of(frozen, x, s, now)
    for left_over in reversed(range(POLISHES)):
        step, widened = at.newton(frozen)
        left = float(np.sqrt(step @ (at.information(widened) + _precision(frozen)) @ step))
        if left < enough or not left_over:
            break
        at = _Point.of(frozen, np.clip(at.x + step, low, high), s, None)
    return at, widened, left


def _fit_scales(
    frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], now: Whitened, count: int
) -> tuple[NDArray[np.float64], Whitened]:
    for _ in range(count):
        s, now = fit_scales(frozen, x, s, now)
    return s, now


def coordinate_limits(frozen: FrozenFilter) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lowest and highest coordinates, those of the filter, (6,) each."""
    widths = LIMIT_SD * frozen.prior.std
    widths[0] = LIMIT_SD_TARGET * np.hypot(frozen.prior.std[0], ROOM)
    return frozen.middle - widths, frozen.middle + widths


def _precision(frozen: FrozenFilter) -> NDArray[np.float64]:
    return np.linalg.inv(frozen.prior.covariance)


def _climb(
    frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], now: Whitened
) -> tuple[NDArray[np.float64], Whitened]:
    """Damped Gauss-Newton on the posterior with the scales held."""
    middle, precision = frozen.middle, _precision(frozen)
    low, high = coordinate_limits(frozen)
    damping = 1e-3

    def cost(here: Whitened, at: NDArray[np.float64]) -> float:
        return here.cost + 0.5 * float((at - middle) @ precision @ (at - middle))

    for _ in range(CLIMBS):
        slope = slopes(frozen, x, s, now)
        pull = slope.T @ now.pull + precision @ (x - middle)
        curve = now.times(slope, slope) + precision
        gained = -1.0
        while gained < 0 and damping < 1e4:
            damped = curve + damping * np.diag(np.diag(curve))
            tried = x + bounded_step(damped, pull, low - x, high - x)
            then = whiten(frozen, tried, s)
            gained = cost(now, x) - cost(then, tried)
            damping *= 10
        if gained < 0:
            break
        x, now, damping = tried, then, max(damping / 100, 1e-7)
        if gained < FLAT:
            break
    return x, now


def bounded_step(
    curve: NDArray[np.float64],
    pull: NDArray[np.float64],
    low: NDArray[np.float64],
    high: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Solve curve step = -pull; a coordinate that would leave its limits stops there, the rest follow."""
    step, free = np.zeros(len(pull)), np.ones(len(pull), bool)
    for _ in pull:
        i, stopped = np.flatnonzero(free), np.flatnonzero(~free)
        if not i.size:
            break
        step[i] = -np.linalg.solve(curve[np.ix_(i, i)], pull[i] + curve[np.ix_(i, stopped)] @ step[stopped])
        out = free & ((step < low - NOTHING) | (step > high + NOTHING))
        if not out.any():
            break
        step[out] = np.clip(step, low, high)[out]
        free &= ~out
    return step * min(1.0, LONGEST_STEP / max(float(np.abs(step).max()), NOTHING))


@dataclass(frozen=True, eq=False)
class _Point:
    """Innovations at one car with their own slopes and those of the car that follows the steer alone."""

    x: NDArray[np.float64]
    now: Whitened
    own: NDArray[np.float64]  # (n, 6)
    steered: NDArray[np.float64]  # (n, 6)

    @classmethod
    def of(
        cls, frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], now: Whitened | None
    ) -> _Point:
        """Passes at x; ``now`` is the one over the log, where it was already made."""
        now = whiten(frozen, x, s) if now is None else now
        return cls(x, now, slopes(frozen, x, s, now), steered_slopes(frozen, x, s, now))

    def information(self, widened: float) -> NDArray[np.float64]:
        """Of the data about the coordinates, (6, 6)."""
        return self.now.times(self.steered, self.steered) / widened

    def newton(self, frozen: FrozenFilter) -> tuple[NDArray[np.float64], float]:
        """The next step (6,), and by how much the information is overstated once it is taken."""
        middle, precision = frozen.middle, _precision(frozen)
        low, high = coordinate_limits(frozen)
        curve = self.now.times(self.steered, self.own)
        pull = self.steered.T @ self.now.pull
        widened = 1.0
        for _ in range(2):  # the step and the weight of the data depend on each other
            step = bounded_step(
                curve / widened + precision,
                pull / widened + precision @ (self.x - middle),
                low - self.x,
                high - self.x,
            )
            widened = self._overstated(frozen, step)
        return step, widened

    def _overstated(self, frozen: FrozenFilter, step: NDArray[np.float64]) -> float:
        """Variance of ln K from the scatter of `BLOCK`s against that of independent rows; at least 1."""
        scores = self.steered * (self.now.weight * (self.now.e + self.own @ step) / self.now.S).reshape(-1, 1)
        block = np.floor((frozen.setup.log.t - frozen.setup.log.t[0]) / BLOCK)
        first = np.flatnonzero(np.diff(block, prepend=-1.0) > 0)
        sums = np.add.reduceat(scores, first, axis=0)
        independent = self.information(1.0)
        to_K = np.linalg.inv(independent + _precision(frozen))[0]
        expected = float(to_K @ independent @ to_K)
        return max(1.0, float(np.sum((sums @ to_K) ** 2)) / max(expected, NOTHING))


def _result(
    at: _Point, frozen: FrozenFilter, s: NDArray[np.float64], widened: float, *, settled: bool
) -> BatchFit:
    information = at.information(widened)
    covariance = np.linalg.inv(information + _precision(frozen))
    done = at.now.done
    std = np.sqrt(widened * np.diag(done.covariance(["input_offset", "output_bias"])))
    told = at.now.weight * at.steered[:, 0] ** 2 / at.now.S / widened
    return BatchFit(
        frozen=frozen,
        x=at.x,
        covariance=covariance,
        scales=s,
        zero=(done.value("input_offset"), done.value("output_bias")),
        zero_std=(float(std[0]), float(std[1])),
        widened=widened,
        settled=settled,
        halves=_halves(at, frozen, covariance),
        t=frozen.setup.log.t,
        information=np.cumsum(told),
    )


def _halves(at: _Point, frozen: FrozenFilter, covariance: NDArray[np.float64]) -> Halves:
    """One Newton step of ln K on either half; what the other coordinates are wrong by moves both."""
    t = frozen.setup.log.t
    late = t > 0.5 * (t[0] + t[-1])
    moves, variances, carried = [], [], []
    for part in (~late, late):
        d = np.where(part, at.steered[:, 0] * at.now.weight / at.now.S, 0.0)
        curve = d @ at.own
        if abs(curve[0]) < NOTHING:
            return Halves(float(at.x[0]), float(at.x[0]), 0.0)
        move = float(np.clip(-(d @ at.now.e) / curve[0], -LONGEST_STEP, LONGEST_STEP))
        left = np.where(part, at.now.e + move * at.own[:, 0], 0.0)
        moves.append(move)
        variances.append(_scatter(d * left, t) / curve[0] ** 2)
        carried.append(np.append(0.0, curve[1:] / curve[0]))
    tilt = carried[1] - carried[0]
    spread = np.sqrt(sum(variances) + float(tilt @ covariance @ tilt))
    return Halves(
        float(at.x[0] + moves[0]), float(at.x[0] + moves[1]), float(abs(moves[1] - moves[0]) / spread)
    )


def _scatter(scores: NDArray[np.float64], t: NDArray[np.float64]) -> float:
    """Variance of a sum of scores from its blocks, at least that of independent rows."""
    block = np.floor((t - t[0]) / BLOCK)
    first = np.flatnonzero(np.diff(block, prepend=-1.0) > 0)
    return float(max(np.sum(np.add.reduceat(scores, first) ** 2), np.sum(scores**2)))
