"""Rows at equal distances instead of equal times: dimensionless time t U/L is then uniform at any speed.

Invariant: a row holds the means of speed and yaw rate over the same stretch, half before and half behind
it, and the straight lines between its steers those of the steer (`lines_of_means`), so what relates them is
unchanged; what was mostly not measured is missing.

    s distance travelled [m];  ds spacing of the rows [m];  L wheelbase [m];  U speed [m/s]

Brennan & Alleyne 2004, section 4: L/U is the time in which a vehicle travels its own length, so a
wheel-pulse counter is a clock that ticks in dimensionless time.
"""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
from numpy.typing import NDArray

from similitude.coarse_log import lines_of_means
from similitude.errors import LogError, UsageError
from similitude.log import Log
from similitude.log_time import FEWEST_ROWS
from similitude.run import Run, Trace, held

LARGEST_SHARE = 0.3  # of the wheelbase; at walking pace a longer stretch hides quick steering
KNOWN_SHARE = 0.5  # of a stretch, below which its mean is missing
READ = 'docs/filter.md, "Sampling by distance"'


def by_distance(log: Log, spacing: float, *, wheelbase: float) -> Log:
    """The same drive with one row every ``spacing`` of road.

    Standing and reversing take no rows. The distance is the integral of the speed; where the speed is
    missing it is held.

    Parameters
    ----------
    log : Log            one row a sample, (n,).
    spacing : float      ds [m], at most 0.3 of the wheelbase.
    wheelbase : float    L [m].

    Returns
    -------
    Log                  (k,) rows; its times are those at which each stretch ended [s].

    Raises
    ------
    UsageError           the spacing is not positive, above 0.3 of the wheelbase, or finer than the log.
    LogError             the drive is shorter than twenty rows at this spacing.
    """
    step = _distance_steps(log)
    moving = step[step > 0]
    usual = float(np.median(moving)) if moving.size else 0.0
    _check_spacing(spacing, usual, wheelbase)
    s = np.concatenate([[0.0], np.cumsum(step)])
    edges = np.arange(int(s[-1] / spacing) + 1) * spacing
    if edges.size <= FEWEST_ROWS:
        raise LogError(
            f"{log.name} moves forward by {s[-1]:.3g} m: {max(edges.size - 1, 0)} rows every {spacing:g} m, "
            f"{FEWEST_ROWS} are the least",
            usually="the car hardly moved, or the spacing is that of a longer vehicle.",
            paste="similitude identify ... (without --spacing)",
            read=READ,
        )
    around = np.clip(np.append(edges - 0.5 * spacing, s[-1]), 0.0, s[-1])
    columns = {name: _mean_over(s, getattr(log, name), around) for name in ("delta", "r", "U")}
    columns["delta"][2:-2] = lines_of_means(columns["delta"])[2:-2]  # the outer stretches are cut short
    ay = None if log.ay is None else _mean_over(s, log.ay, around)
    return replace(log, t=_when(s, log.t, edges), ay=ay, **columns)


def at_rows_of(run: Run, log: Log) -> Run:
    """A run over a distance-sampled log, told at the rows of the log it came from.

    Every row gets the estimate of the last stretch that had ended by then (the first rows: the first).
    """
    trace = run.trace
    at = np.maximum(np.searchsorted(trace.t, log.t, side="right") - 1, 0)
    told = {field.name: getattr(trace, field.name)[at] for field in fields(Trace)}
    fresh = np.concatenate([[True], np.diff(at) > 0])
    told["innovation"] = np.where(fresh, told["innovation"], np.nan)
    told |= {"t": log.t, "r_measured": log.r, "U": held(log.U)}
    return replace(run, log=log, trace=Trace(**told))


def _distance_steps(log: Log) -> NDArray[np.float64]:
    """Forward distance of each time step, (n - 1,) [m]."""
    speed = np.maximum(held(log.U), 0.0)
    return 0.5 * (speed[1:] + speed[:-1]) * np.diff(log.t)


def _check_spacing(spacing: float, usual: float, wheelbase: float) -> None:
    if not 0 < spacing <= LARGEST_SHARE * wheelbase:
        raise UsageError(
            f"a row every {spacing:g} m does not suit a wheelbase of {wheelbase:g} m",
            usually="a tenth to a fifth of the wheelbase is meant; a longer one hides the yaw motion.",
            paste=f'--spacing "{wheelbase / 6:.2g} m"',
            read=READ,
        )
    if spacing < 0.5 * usual:
        raise UsageError(
            f"a row every {spacing:g} m is finer than the log, which has one every {usual:.3g} m",
            usually="interpolated rows carry no news, and their noise is counted several times.",
            paste=f'--spacing "{max(usual, 0.01):.2g} m"',
            read=READ,
        )


def _when(s: NDArray[np.float64], t: NDArray[np.float64], edges: NDArray[np.float64]) -> NDArray[np.float64]:
    """Time at which each edge was reached; the later end of a standstill, (k,) [s]."""
    after = np.minimum(np.searchsorted(s, edges, side="left"), len(s) - 1)
    before = np.maximum(after - 1, 0)
    way = s[after] - s[before]
    share = np.divide(edges - s[before], way, out=np.ones_like(way), where=way > 0)
    return t[before] + share * (t[after] - t[before])


def _mean_over(
    s: NDArray[np.float64], values: NDArray[np.float64], edges: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Mean of a signal over each stretch between two edges, NaN where it was mostly missing, (k,)."""
    here = np.union1d(s, edges)  # so that no trapezoid reaches over an edge
    there = np.interp(here, s, values)
    middle = 0.5 * (there[1:] + there[:-1])
    known = np.isfinite(middle)
    way = np.diff(here)
    at = np.searchsorted(here, edges)
    whole = np.diff(np.concatenate([[0.0], np.cumsum(np.where(known, middle, 0.0) * way)])[at])
    measured = np.diff(np.concatenate([[0.0], np.cumsum(known * way)])[at])
    enough = measured >= KNOWN_SHARE * np.diff(edges)
    return np.where(enough, np.divide(whole, measured, out=np.zeros_like(whole), where=enough), np.nan)
