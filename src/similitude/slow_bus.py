"""Rows that hold no reading of their own: repeats of a slow bus, and lines drawn across a hole.

A logger at 100 Hz that reads a bus at 20 Hz writes each reading five times. Repeats are no measurements,
and a held steer angle is late by half a bus period on average while the reading itself is not.

Invariant: a new reading is never changed; only what stands between readings is: of the yaw rate it becomes
missing, of a held steer or speed it lies on the curve to the next reading.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from similitude.log import Log
from similitude.log_sensors import straight_rows

LONGEST = 0.25  # s: slower than this a column is not held, it is missing
FEWEST = 20  # changes, to speak of a period
EARLY = 0.02  # of the changes may come sooner: a bus and a logger have two clocks


def hold_period(values: NDArray[np.float64]) -> int:
    """Rows for which each reading is repeated; 1 where every row may be a new one.

    A coarse sensor stands still too, but changes again in the next row when its quantity moves; a bus
    never does. Of n changes at most a fiftieth may come more than a row early.

    Parameters
    ----------
    values : (n,) a column of a log, NaN where missing.
    """
    known = np.flatnonzero(np.isfinite(values))
    changes = known[1:][np.diff(values[known]) != 0]
    if changes.size < FEWEST:
        return 1
    apart = np.diff(changes)
    period = int(np.argmax(np.bincount(apart)))
    early = np.mean(apart < max(period - 1, 2))
    return period if period > 1 and early <= EARLY else 1


def new_readings(values: NDArray[np.float64], period: int) -> NDArray[np.bool_]:
    """Rows that hold a new reading, (n,): changes, and every ``period`` rows between them.

    A row next to a change is no reading of its own: the bus was a row early or late.
    """
    known = np.isfinite(values)
    at = np.flatnonzero(known)
    if period <= 1 or not at.size:
        return known
    rows = np.arange(values.size)
    changed = np.concatenate([[at[0]], at[1:][np.diff(values[at]) != 0]])
    before = np.searchsorted(changed, rows, "right") - 1
    since = rows - changed[np.maximum(before, 0)]
    until = np.append(changed, values.size + 2)[before + 1] - rows
    return known & (since % period == 0) & ((since == 0) | (until > 1))


def through(
    t: NDArray[np.float64], at: NDArray[np.float64], values: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Smooth curve through readings, (n,): cubic between them, slopes from the readings on either side.

    A straight line would take 5 % off a 1 Hz steer that is read every tenth of a second.
    """
    slope = np.gradient(values, at) if at.size > 2 else np.zeros(at.size)
    i = np.clip(np.searchsorted(at, t, "right") - 1, 0, at.size - 2)
    span = at[i + 1] - at[i]
    x = np.clip((t - at[i]) / span, 0.0, 1.0)
    rise = values[i + 1] - values[i]
    first, last = span * slope[i] - rise, rise - span * slope[i + 1]
    return values[i] + x * rise + x * (1 - x) * ((1 - x) * first + x * last)


def held_columns(log: Log) -> dict[str, int]:
    """Columns of a slow bus, and the rows for which it repeats each reading.

    Columns whose readings last longer than a quarter of a second are not among them.
    """
    periods = {name: hold_period(getattr(log, name)) for name in ("delta", "r", "U")}
    return {name: rows for name, rows in periods.items() if 1 < rows <= LONGEST * log.rate}


def without_repeats(log: Log, held: Mapping[str, int]) -> Log:
    """The log as the sensors gave it, row for row; ``held`` as of `held_columns`."""
    changed = {}
    for name, period in held.items():
        values = getattr(log, name)
        new = new_readings(values, period)
        rest = np.nan if name == "r" else through(log.t, log.t[new], values[new])
        changed[name] = np.where(new | ~np.isfinite(values), values, rest)
    return replace(log, **changed)


def without_lines(log: Log) -> Log:
    """The log without yaw rates that lie on straight lines, where holes were filled in; they become missing.

    A noisy sensor draws no line. Taken as measured, 26 s of one would speak of a car that does not answer.
    """
    lines = straight_rows(log.t, log.r)
    return replace(log, r=np.where(lines, np.nan, log.r)) if lines.any() else log


def bridged(log: Log) -> Log:
    """The log with a curve through the yaw rate's readings, where they are as close as a bus may have them.

    For means over rows, which are to be of the same time for every column.
    """
    at = np.flatnonzero(np.isfinite(log.r))
    if at.size < 2:
        return log
    after = np.clip(np.searchsorted(at, np.arange(log.samples)), 1, at.size - 1)
    short = log.t[at[after]] - log.t[at[after - 1]] <= LONGEST
    curve = np.where(short, through(log.t, log.t[at], log.r[at]), np.nan)
    return replace(log, r=np.where(np.isfinite(log.r), log.r, curve))
