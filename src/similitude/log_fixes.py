"""Repairs of a log, each with a name, made only when that name was asked for.

Invariant: a repair changes what its words say and nothing else, and says how many cells it changed.
They are made in the order of `FIXES`, whatever the order in which they were asked for.

    t time [s];  delta road wheel angle [rad];  r yaw rate [rad/s];  U speed [m/s]
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from similitude.errors import UsageError, shown
from similitude.finding import Finding
from similitude.log_cells import slower_by
from similitude.log_columns import Column, column_of
from similitude.log_plausibility import fill_rows
from similitude.log_sensors import cut_rows, spike_rows, straight_rows, stuck_rows
from similitude.log_time import counter_period, restarts, runs_of_times
from similitude.signal_faults.dead_band import dead_rows
from similitude.signal_faults.overflow import overflow, unwrapped
from similitude.units import parse_unit

Values = dict[str, np.ndarray]
SENSORS = ("delta", "steering_wheel", "r", "U")


@dataclass(frozen=True)
class Fix:
    """A repair: its words, the quantity it works on, and what it makes of values and columns.

    `apply` is None where the reader makes the repair already.
    """

    words: str
    needs: str
    apply: Callable[[Values, Mapping[str, Column]], tuple[Values, str]] | None


def check_fixes(names: Sequence[str]) -> tuple[str, ...]:
    """Return the repairs asked for in the order in which they are made.

    Raises
    ------
    UsageError   there is no repair of that name
    """
    for name in names:
        if name not in FIXES:
            near = difflib.get_close_matches(name, FIXES, n=1, cutoff=0.0)[0]
            raise UsageError(
                f"--fix {shown(name)} is no repair; there are {', '.join(FIXES)}",
                usually="it is a matter of spelling.",
                paste=f"--fix {near}",
                read='docs/logs.md, "Repairs"',
            )
    return tuple(name for name in FIXES if name in names)


def apply_fixes(
    names: Sequence[str], values: Values, columns: Mapping[str, Column], findings: Sequence[Finding]
) -> tuple[Values, tuple[str, ...]]:
    """Make repairs.

    Parameters
    ----------
    names : sequence of str           as `check_fixes` returned them
    values : dict of str to array     SI values of the log; not changed
    columns : mapping                 quantity -> column
    findings : sequence of Finding    what reading met; it counts the texts left out

    Returns
    -------
    dict of str to array              the values, repaired
    tuple of str                      one line for each repair: its name and what it changed
    """
    said = []
    for name in names:
        fix = FIXES[name]
        if fix.apply is None:
            count = sum(int(one.value) for one in findings if one.fault == "text_left_out")
            what = f"{count} cells left empty"
        elif (_steer_of(values) if fix.needs == "delta" else fix.needs) in values:
            values, what = fix.apply(values, columns)
        else:
            what = "nothing changed, the column could not be read"
        said.append(f"{name}: {what}")
    return values, tuple(said)


def _kept(values: Values, keep: np.ndarray, why: str) -> tuple[Values, str]:
    left_out = int(np.count_nonzero(~keep))
    return {name: column[keep] for name, column in values.items()}, f"{left_out} rows {why}"


def _drop_untimed_rows(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    return _kept(values, np.isfinite(values["t"]), "without a time left out")


def _unwrap_time(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    t = values["t"]
    dt = np.diff(t)
    rising = dt[dt > 0]
    usual = float(np.median(rising)) if rising.size else 0.0
    added = np.zeros(t.size)
    turns = 0
    for at in np.flatnonzero(dt < 0):
        period = counter_period(-float(dt[at]), usual)
        if period is not None:
            added[at + 1 :] += period
            turns += 1
    return values | {"t": t + added}, f"{turns} starts of the counter counted on"


def _keep_longest_part(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    t = values["t"]
    edges = np.r_[0, restarts(t), t.size]
    longest = int(np.argmax(np.diff(edges)))
    keep = np.zeros(t.size, dtype=bool)
    keep[edges[longest] : edges[longest + 1]] = True
    values, what = _kept(values, keep & np.isfinite(t), f"left out, {edges.size - 1} parts found")
    return values, f"{what}; data rows {edges[longest] + 1} to {edges[longest + 1]} kept"


def _sort_time(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    order = np.argsort(values["t"], kind="stable")
    moved = int(np.count_nonzero(order != np.arange(order.size)))
    return {name: column[order] for name, column in values.items()}, f"{moved} rows moved"


def _drop_repeated_rows(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    return _kept(values, np.r_[True, np.diff(values["t"]) != 0], "of a time that was there left out")


def _spread_times(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    t = values["t"]
    first = runs_of_times(t)
    if first is None:
        return values, "times do not repeat evenly, nothing changed"
    counts = np.diff(np.r_[first, t.size])
    usual = float(np.median(np.diff(t[first]))) / float(np.median(counts[1:-1]))
    width = np.diff(np.r_[t[first], 0.0]) / counts
    width[[0, -1]] = usual  # of the first and the last time, some rows are not in the log
    place = np.arange(t.size) - np.repeat(first, counts)
    place[: counts[0]] += round(float(np.diff(t[first[:2]])[0]) / usual) - counts[0]
    return values | {
        "t": t + place * np.repeat(width, counts)
    }, f"{t.size} rows spread over {first.size} times"


def _hold_slow_columns(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    held, said = dict(values), []
    for name in [name for name in ("delta", "steering_wheel", "U") if name in values]:
        every = slower_by(values[name])
        if every is None:
            continue
        known = np.flatnonzero(~np.isnan(values[name]))
        last = np.searchsorted(known, np.arange(values[name].size), side="right") - 1
        # Held for two distances at most: a sensor that fell silent is not held.
        fresh = (last >= 0) & (np.arange(values[name].size) - known[last] < 2 * every + 1)
        held[name] = np.where(fresh, values[name][known[last]], np.nan)
        count = int(np.count_nonzero(np.isnan(values[name]) & fresh))
        said.append(f"{count} cells of {column_of(name, columns).header} held")
    return held, ", ".join(said) or "no column is regularly slower than the file"


def _emptied(find: Callable[[Values, str], np.ndarray], names: Sequence[str]):
    """The repair that leaves cells empty where a detector finds that nothing was measured."""

    def apply(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
        emptied, said = dict(values), []
        for name in [name for name in names if name in values]:
            rows = find(values, name)
            emptied[name] = np.where(rows, np.nan, values[name])
            if rows.any():
                said.append(f"{np.count_nonzero(rows)} cells of {column_of(name, columns).header} left empty")
        return emptied, ", ".join(said) or "no such cell found"

    return apply


def _unwrap_overflow(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
    whole, said = dict(values), []
    for name in [name for name in ("delta", "steering_wheel", "r") if name in values]:
        found = overflow(values[name])
        if found is not None:
            whole[name] = unwrapped(values[name])
            said.append(
                f"{np.count_nonzero(found.turns)} cells of {column_of(name, columns).header} counted on"
            )
    return whole, ", ".join(said) or "no column goes round"


def _reads(name: str, unit: str) -> Callable[[Values, Mapping[str, Column]], tuple[Values, str]]:
    """The repair that reads the numbers of a column in another unit than its header says."""

    def apply(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
        key = _steer_of(values) if name == "delta" else name
        column = column_of(key, columns)
        factor = parse_unit(unit).factor / column.unit.factor
        cells = int(np.count_nonzero(np.isfinite(values[key])))
        return values | {key: values[key] * factor}, f"{cells} cells of {column.header} read as {unit}"

    return apply


def _turned(name: str) -> Callable[[Values, Mapping[str, Column]], tuple[Values, str]]:
    def apply(values: Values, columns: Mapping[str, Column]) -> tuple[Values, str]:
        key = _steer_of(values) if name == "delta" else name
        cells = int(np.count_nonzero(np.isfinite(values[key])))
        return values | {key: -values[key]}, f"{cells} cells of {column_of(key, columns).header} turned round"

    return apply


def _steer_of(values: Values) -> str:
    return "delta" if "delta" in values else "steering_wheel"


FIXES = {
    "blank_text": Fix("leave cells that hold text empty", "", None),
    "unwrap_time": Fix("count on where a counter of time starts anew", "t", _unwrap_time),
    "keep_longest_part": Fix(
        "of recordings joined end to end, or parted by a set clock, keep the one with most rows",
        "t",
        _keep_longest_part,
    ),
    "drop_untimed_rows": Fix("leave out rows without a time", "t", _drop_untimed_rows),
    "sort_time": Fix("put the rows in the order of their time", "t", _sort_time),
    "drop_repeated_rows": Fix("keep the first row of each time", "t", _drop_repeated_rows),
    "spread_times": Fix("spread rows of one rounded time evenly up to the next", "t", _spread_times),
    "unwrap_overflow": Fix(
        "count on where a steer or yaw rate goes on at the other end of its range", "t", _unwrap_overflow
    ),
    "yaw_rate_is_deg_per_s": Fix("read the yaw rate in deg/s", "r", _reads("r", "deg/s")),
    "yaw_rate_is_rad_per_s": Fix("read the yaw rate in rad/s", "r", _reads("r", "rad/s")),
    "steer_is_deg": Fix("read the steer in deg", "delta", _reads("delta", "deg")),
    "steer_is_rad": Fix("read the steer in rad", "delta", _reads("delta", "rad")),
    "speed_is_kmh": Fix("read the speed in km/h", "U", _reads("U", "km/h")),
    "speed_is_m_per_s": Fix("read the speed in m/s", "U", _reads("U", "m/s")),
    "speed_is_mph": Fix("read the speed in mph", "U", _reads("U", "mph")),
    "speed_is_knots": Fix("read the speed in knots", "U", _reads("U", "kn")),
    "flip_steer_sign": Fix("turn the sign of the steer round", "delta", _turned("delta")),
    "flip_yaw_rate_sign": Fix("turn the sign of the yaw rate round", "r", _turned("r")),
    "flip_speed_sign": Fix("turn the sign of the speed round", "U", _turned("U")),
    "drop_fill_values": Fix(
        "leave cells empty that hold a number for a missing value, such as -9999",
        "t",
        _emptied(lambda values, name: fill_rows(values[name], name), (*SENSORS, "ay")),
    ),
    "drop_stuck": Fix("leave cells empty in which a sensor is stuck", "t", _emptied(stuck_rows, SENSORS)),
    "drop_interpolated": Fix(
        "leave cells of the yaw rate empty that were filled in by interpolation",
        "t",
        _emptied(lambda values, name: straight_rows(values["t"], values[name]), ("r",)),
    ),
    "drop_clipped": Fix(
        "leave cells empty in which a sensor is at the end of its range",
        "t",
        _emptied(cut_rows, ("delta", "steering_wheel", "r")),
    ),
    "drop_spikes": Fix(
        "leave single cells empty that stand out from both neighbours",
        "t",
        _emptied(lambda values, name: spike_rows(values[name]), SENSORS),
    ),
    "drop_dead_band": Fix(
        "leave cells of the yaw rate empty whose small value was set to zero",
        "r",
        _emptied(lambda values, name: dead_rows(values[name]), ("r",)),
    ),
    "hold_slow_columns": Fix(
        "hold steer and speed from one value to the next where they are slower than the file",
        "t",
        _hold_slow_columns,
    ),
}
