"""Steer lag: taken from the vehicle file, or found by a quick search over the whole log.

Invariant: a lag is only taken from the log when the log speaks for it; otherwise it is that of measured
steer angles as far as the log allows it, said to be assumed, and its uncertainty goes into that of K.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.filter_config import COMMANDED_STEER_SD
from similitude.filter_run import Setup, side_by_side
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

LONGEST = 0.25  # s
STEP = 0.01  # s
RATE = 50.0  # rows a second: a lag moves every row of a manoeuvre, so fewer tell as much
DEPENDENT = 0.3  # s: innovations of a wrong model stay alike this long
CONVINCING = 4.0  # log likelihood gained over no lag, in independent samples: odds of 50 to 1
MEASURED_LAG = Uncertain(
    0.010, 0.008, "s"
)  # buses and filters; the sd over the value is that of the logarithm
FINE = 0.001  # s: the lags of a measured steer, finer than the scan
COMMAND = 0.03  # s: a measured road wheel does not act this late; a command does


@dataclass(frozen=True, eq=False)
class LagScan:
    """Lags tried (k,) [s], their cost (k,) above the best [-], and the one chosen [s], with its sd."""

    lags: NDArray[np.float64]
    cost: NDArray[np.float64]
    chosen: float
    origin: str
    std: float = 0.0  # of the chosen lag [s]; zero where the vehicle file states it


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
    lags = np.arange(0.0, LONGEST + STEP / 2, STEP)
    setup = setup.at_rate(RATE)
    passes = side_by_side([lambda lag=lag: setup.with_lag(lag, COMMANDED_STEER_SD).run() for lag in lags])
    alone = max(1.0, DEPENDENT / setup.usual_step)
    # Where steer is missing, each lag has other rows to show: all are judged on the same ones.
    shared = np.logical_and.reduce([p.used for p in passes])
    cost = np.array([p.cost(shared) for p in passes]) / alone
    cost -= cost.min()
    best = int(np.argmin(cost))
    if cost[0] < CONVINCING:
        return LagScan(lags, cost, *_of_measured(lags, cost))
    chosen, std = _vertex(lags, cost, best)
    return LagScan(lags, cost, chosen, "scanned", std)


def _of_measured(lags: NDArray[np.float64], cost: NDArray[np.float64]) -> tuple[float, str, float]:
    """Mean and sd [s] of the lag of a measured steer angle, as far as the scan leaves it open."""
    lag = np.arange(FINE, COMMAND + STEP, FINE)
    log_sd = MEASURED_LAG.sd / MEASURED_LAG.value
    before = np.exp(-0.5 * (np.log(lag / MEASURED_LAG.value) / log_sd) ** 2) / lag
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


def looks_like_command(scan: LagScan) -> bool:
    """Whether the steer column acts so late that it must be a command rather than a measurement."""
    return scan.chosen >= COMMAND
