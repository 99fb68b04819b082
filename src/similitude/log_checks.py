"""Can this be a driving log? Time, missing cells and stuck sensors; units are judged beside this.

Invariant: values are never changed here. A log is either refused, with the column, the first row
and the value, or accepted together with warnings that say what is odd about it.

A data row is counted from 1 for the first row below the header. Units inside are SI:
    t [s];  dt step of time [s];  U speed [m/s]
"""

from __future__ import annotations

import numpy as np

from similitude.errors import LogError, shown

FEWEST_ROWS = 20
SHORTEST_LOG = 2.0  # s; shorter than the slowest thing that is to be seen
LONG_GAP = 1.0  # s; a car's yaw motion has died out, so the dynamic state restarts
LARGEST_STEP = 3600.0  # s; no recording pauses for an hour
SHORTEST_JUMP = 60.0  # s; below, 1000 lost samples are a gap, above, the clock was set
STUCK_ROWS = 50


def check_time(t: np.ndarray, *, header: str, factor: float, file: str) -> tuple[str, ...]:
    """Check the time column.

    Parameters
    ----------
    t : (n,) float64   time [s], NaN where missing
    header : str       the column as written in the file
    factor : float     SI value of the column's unit [s]; values are shown in that unit
    file : str         name of the file

    Returns
    -------
    tuple of str       warnings: gaps, with place and length

    Raises
    ------
    LogError           missing, repeated, falling or jumping times; too few rows; too short
    """
    column = f"column {shown(header)} of {file}"
    if t.size < FEWEST_ROWS:
        raise _refused(
            f"{file} has {t.size} rows; {FEWEST_ROWS} are the least",
            "the recording was stopped early, or the file was cut off.",
            "similitude identify LONGER_LOG.csv",
        )
    missing = np.flatnonzero(~np.isfinite(t))
    if missing.size:
        raise _refused(
            f"{column} has no value in data row {missing[0] + 1}, and in {missing.size} of {t.size} rows",
            "time stands in another column, or empty rows were written; drop them.",
            '--map "t=COLUMN"' if missing.size == t.size else f"{(t.size // 2) * 0.01:.2f}",
        )
    dt = np.diff(t)
    _refuse_disorder(t, dt, column, factor)
    usual = float(np.median(dt))
    _refuse_pace(usual, header, column)
    jumps = np.flatnonzero(dt > min(max(1000 * usual, SHORTEST_JUMP), LARGEST_STEP))
    if jumps.size:
        first = jumps[0]
        raise _refused(
            f"{column} jumps by {dt[first]:.6g} s in data row {first + 2} ({t[first] / factor:.9g} "
            f"is followed by {t[first + 1] / factor:.9g}), {_times(jumps.size)} in all",
            "the clock was set while recording, or two recordings were joined; part them there.",
            f"head -n {first + 2} {file} > first_part.csv",
        )
    if t[-1] - t[0] < SHORTEST_LOG:
        raise _refused(
            f"{file} lasts {t[-1] - t[0]:.3g} s; {SHORTEST_LOG:g} s are the least",
            f"the recording was stopped early, or the unit of {shown(header)} is another.",
            "t [s]" if factor < 1 else "similitude identify LONGER_LOG.csv",
        )
    return _gap_warnings(t, dt, usual)


def _refuse_disorder(t: np.ndarray, dt: np.ndarray, column: str, factor: float) -> None:
    wrong = np.flatnonzero(dt <= 0)
    if not wrong.size:
        return
    first, repeated = wrong[0], int(np.count_nonzero(dt == 0))
    before, after = t[first] / factor, t[first + 1] / factor
    if repeated == dt.size:
        what = f"is {before:.9g} in all {t.size} rows"
    else:
        verb = "repeats" if dt[first] == 0 else "runs backward"
        what = (
            f"{verb} in data row {first + 2}: {before:.9g} is followed by {after:.9g}; "
            f"steps that do not rise: {wrong.size}, of them repeated: {repeated}"
        )
    raise _refused(
        f"{column} {what}",
        "rows were written twice, two recordings were joined, or time has too few digits.",
        "log = log.drop_duplicates('t [s]').sort_values('t [s]')",
    )


def _refuse_pace(usual: float, header: str, column: str) -> None:
    name = header.split("[")[0].strip() or "t"
    for unit, scale in (("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)):
        if usual >= 1.0 and 1e-4 <= usual * scale <= 0.5:
            raise _refused(
                f"{column}: the usual step is {usual:.6g} s, too slow for a driving log",
                f"these values look like {unit}.",
                f"{name} [{unit}]",
            )
    if not 2e-5 <= usual <= 1.0:
        slow = usual > 1.0
        raise _refused(
            f"{column}: the usual step is {usual:.3g} s, too {'slow' if slow else 'fast'} for a driving log",
            "the log was thinned out; 20 rows a second are enough." if slow else "these values look like s.",
            f"{name} [s]",
        )


def _gap_warnings(t: np.ndarray, dt: np.ndarray, usual: float) -> tuple[str, ...]:
    warnings = []
    long = np.flatnonzero(dt > max(LONG_GAP, 3 * usual))
    for at in long[:5]:
        warnings.append(
            f"gap of {dt[at]:.3g} s after t = {t[at]:.6g} s (data row {at + 2}): the dynamic "
            "state restarts there"
        )
    if long.size > 5:
        warnings.append(f"{long.size - 5} more gaps over {LONG_GAP:g} s: restarts there, too")
    # A step of 1.8 usual ones has lost a sample; jitter of a bus stays below.
    short = int(np.count_nonzero(dt > 1.8 * usual)) - long.size
    if short > 0:
        warnings.append(
            f"{short} short gap{'s' if short > 1 else ''} (steps over 1.8 times the usual "
            f"{usual:.3g} s): no measurement there"
        )
    return tuple(warnings)


def check_column(values: np.ndarray, *, header: str, file: str, may_rest: bool) -> tuple[str, ...]:
    """Check one column for missing and stuck values.

    Parameters
    ----------
    values : (n,) float64   in any unit, NaN where missing
    header : str            the column as written in the file
    file : str              name of the file
    may_rest : bool         True where a constant is no fault (speed)

    Returns
    -------
    tuple of str            warnings: how many cells are missing, and the first

    Raises
    ------
    LogError                empty, more than half empty, or constant
    """
    column = f"column {shown(header)} of {file}"
    missing = np.isnan(values)
    count = int(np.count_nonzero(missing))
    if count > values.size / 2:
        row = int(np.argmax(missing)) + 1
        what = "is empty" if count == values.size else (
            f"has no number in {count} of {values.size} rows, first in data row {row}"
        )  # fmt: skip
        raise _refused(
            f"{column} {what}",
            "the sensor was not connected, or it is slower than the other columns; hold or "
            "interpolate its values first.",
            f'log["{header}"] = log["{header}"].interpolate()',
        )
    if not may_rest and values.size > STUCK_ROWS and np.nanmin(values) == np.nanmax(values):
        raise _refused(
            f"{column} is stuck: it is {np.nanmax(values):.6g} (SI) in all {values.size} rows",
            "the sensor was not connected, or the car was parked.",
            f'--map "{header.split("[")[0].strip() or "r"}=COLUMN"',
        )
    if not count:
        return ()
    return (
        f"column {shown(header)}: {count} of {values.size} cells are missing "
        f"({100 * count / values.size:.2g} %), first in data row {int(np.argmax(missing)) + 1}: "
        "no measurement there",
    )


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"


def _refused(what: str, usually: str, paste: str) -> LogError:
    return LogError(what, usually=usually, paste=paste, read='docs/logs.md, "What is refused"')
