"""Steer lag: taken from the vehicle file, or found by a quick search over the whole log.

Invariant: a lag is only taken from the log when the log speaks for it; otherwise it is that of measured
steer angles as far as the log allows it, said to be assumed, and its uncertainty goes into that of K.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.filter_config import COMMANDED_STEER_SD
from similitude.filter_run import Setup, side_by_side
from similitude.servo import DIRECT, Servo
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

STEP = 0.01  # s
NEAR = STEP * np.arange(5)  # s: the lags of measured angles, all of them tried
FAR = np.array([0.07, 0.10, 0.13, 0.16, 0.19, 0.22, 0.25])  # s: a bowl of the cost is wider than their gaps
LONGEST = 0.25  # s
RATE = 50.0  # rows a second: a lag moves every row of a manoeuvre, so fewer tell as much
DEPENDENT = 0.3  # s: innovations of a wrong model stay alike this long
CONVINCING = 4.0  # log likelihood gained over no lag, in independent samples: odds of 50 to 1
MEASURED_LAG = Uncertain(0.010, 0.010, "s")  # buses, filters, and either may be logged late
EARLIEST = 0.010  # s: a steer that is logged late seems to act so much before it is there, at most
FINE = 0.001  # s: the lags of a measured steer, finer than the scan
EARLY = (0.03, 0.06, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5)  # s by which a yaw rate may come before its steer
COMMAND = 0.03  # s: a measured road wheel does not act this late; a command does


@dataclass(frozen=True)
class Otherwise:
    """Another servo that it may have been, how much ``later`` its lag is [s], and its weight."""

    servo: Servo
    later: float
    weight: float


@dataclass(frozen=True, eq=False)
class LagScan:
    """Lags tried (k,) [s], their cost (k,) above the best [-], and the one chosen [s], with its sd.

    Behind the lag a command passes a ``servo``; ``others`` are servos and lags that it may have been as well,
    their weights being of all, the chosen one included.

    ``early`` [s] is by how much the yaw rate comes before the steer that should cause it, which no car
    does and two clocks do; zero where the log does not speak for it.
    """

    lags: NDArray[np.float64]
    cost: NDArray[np.float64]
    chosen: float
    origin: str
    std: float = 0.0  # of the chosen lag [s]; zero where the vehicle file states it
    early: float = 0.0
    servo: Servo = DIRECT
    others: tuple[Otherwise, ...] = ()

    @property
    def total(self) -> float:
        """By how much the wheels are behind the steer of the log while it turns steadily [s]."""
        return self.chosen + self.servo.constant


def find_lag(setup: Setup, vehicle: Vehicle) -> LagScan:
    """Choose the steer lag for a log.

    Parameters
    ----------
    setup : Setup      of the log, without lag.
    vehicle : Vehicle  whose ``steer_lag``, where given, is used unseen.

    Returns
    -------
    LagScan            cost in units of independent samples; empty where nothing was scanned.
                       ``origin`` is "vehicle file", "scanned", or "assumed" (the log does not
                       speak against a lag of nothing: it is what measured angles have).
    """
    empty = np.empty(0)
    if vehicle.steer_lag is not None:
        return LagScan(empty, empty, vehicle.steer_lag.value, "vehicle file")
    both, all_costs = _scanned(setup.at_rate(RATE), EARLY)
    ahead, lags = all_costs[both < 0], both[both >= 0]
    cost = all_costs[both >= 0]
    best, first = int(np.argmin(cost)), int(np.argmin(ahead))
    early = -float(both[first]) if cost[best] - ahead[first] > CONVINCING else 0.0
    cost = cost - cost[best]
    if cost[0] < CONVINCING:
        return LagScan(lags, cost, *_of_measured(lags, cost), early=early)
    chosen, std = _vertex(lags, cost, best)
    return LagScan(lags, cost, chosen, "scanned", std, early)


def lag_behind(setup: Setup) -> LagScan:
    """The lag that the log of a command speaks for most, its servo being that of the setup."""
    lags, cost = _scanned(setup.at_rate(RATE), ())
    best = int(np.argmin(cost))
    cost = cost - cost[best]
    chosen, std = _vertex(lags, cost, best) if best else (0.0, STEP)
    return LagScan(lags, cost, chosen, "scanned", std, servo=setup.servo)


def _scanned(setup: Setup, early: tuple[float, ...]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lags tried, early ones below zero, in order, and their costs in units of independent samples.

    Far lags are first tried in wide steps; around the best of them each `STEP` is, as it is for near ones.
    """
    lags = np.concatenate([-np.array(early[::-1]), NEAR, FAR])
    tried = _losses(setup, lags)
    late = lags >= 0
    best = float(lags[late][np.argmin(costs(tried, setup)[late])])
    around = best + STEP * np.array([-2.0, -1.0, 1.0, 2.0])
    new = around[(around > NEAR[-1] + STEP / 2) & (around < LONGEST)] if best >= NEAR[-1] else around[:0]
    new = new[np.abs(new[:, None] - lags).min(axis=1, initial=LONGEST) > STEP / 2]
    order = np.argsort(np.concatenate([lags, new]))
    tried += _losses(setup, new)
    return np.concatenate([lags, new])[order], costs(tried, setup)[order]


def _losses(setup: Setup, lags: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    return losses([setup.with_lag(lag, COMMANDED_STEER_SD) for lag in lags])


def losses(setups: Sequence[Setup]) -> list[NDArray[np.float64]]:
    """Negative log likelihood of every row, (n,) for each setup."""
    return side_by_side([lambda one=one: one.run().loss for one in setups])


def costs(tried: Sequence[NDArray[np.float64]], setup: Setup) -> NDArray[np.float64]:
    """Sums of losses (n,) over the rows that all share, in units of independent samples.

    Where steer is missing, each lag has other rows to show.
    """
    shared = np.logical_and.reduce([np.isfinite(loss) for loss in tried])
    return np.array([loss[shared].sum() for loss in tried]) / max(1.0, DEPENDENT / setup.usual_step)


def _of_measured(lags: NDArray[np.float64], cost: NDArray[np.float64]) -> tuple[float, str, float]:
    """Mean and sd [s] of the lag of a measured steer angle, as far as the scan leaves it open."""
    lag = np.arange(FINE - EARLIEST, COMMAND + STEP, FINE)
    after, usual = lag + EARLIEST, MEASURED_LAG.value + EARLIEST
    before = np.exp(-0.5 * (np.log(after / usual) * usual / MEASURED_LAG.sd) ** 2) / after
    weight = before * np.exp(-np.interp(lag, lags, cost))
    mean = float(np.average(lag, weights=weight))
    return mean, "assumed", float(np.sqrt(np.average((lag - mean) ** 2, weights=weight)))


def _vertex(lags: NDArray[np.float64], cost: NDArray[np.float64], best: int) -> tuple[float, float]:
    """Lowest point of the parabola through the best lag and its neighbours, and its sd [s]."""
    if best == len(lags) - 1:
        return float(lags[best]), STEP
    before, here, after = cost[best - 1 : best + 2]
    curvature = before - 2 * here + after
    lag = float(lags[best] + 0.5 * STEP * (before - after) / curvature)
    return lag, STEP / float(np.sqrt(curvature))


def is_command(scan: LagScan, vehicle: Vehicle) -> bool:
    """Whether the steer column is a command: as the vehicle file says, or because it acts so late."""
    return scan.total >= COMMAND if vehicle.steer is None else vehicle.steer == "command"
