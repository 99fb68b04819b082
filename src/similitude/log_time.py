"""Can this be the time of a driving log? Disorder, steps of the clock, wrapped counters, gaps.

Invariant: values are never changed here. A data row is counted from 1 for the first row below the
header.

    t [s];  dt step of time [s]
"""

from __future__ import annotations

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding

FEWEST_ROWS = 20
SHORTEST_LOG = 2.0  # s; shorter than the slowest thing that is to be seen
LONG_GAP = 1.0  # s; a car's yaw motion has died out, so the dynamic state restarts
LARGEST_STEP = 3600.0  # s; no recording pauses for an hour
SHORTEST_JUMP = 60.0  # s; below, 1000 lost samples are a gap, above, the clock was set
LOST_SAMPLE = 1.8  # usual steps: one sample was lost; the jitter of a bus stays below
FEWEST_TIMES = 2  # different times between the first and the last, before rows are spread over them
EVEN, EVEN_SHARE = 0.25, 0.9  # rows of a rounded time differ so little in number, nine times in ten
COARSE_CLOCK = 0.05  # s
SLOWEST = 0.22  # s; below 5 rows a second the yaw motion of a car happens between two rows
SINCE_1970 = 1e8  # s; three years: nobody drives so long, so time counts from some epoch

# Counters that start anew: (their period [s], what they count)
COUNTERS = (
    (2**16 * 1e-3, "a 16-bit counter of ms"),
    (2**32 * 1e-6, "a 32-bit counter of us"),
    (2**32 * 1e-3, "a 32-bit counter of ms"),
    (2**32 * 1e-9, "a 32-bit counter of ns"),
    (60.0, "seconds of the minute"),
    (3600.0, "seconds of the hour"),
    (86400.0, "seconds of the day"),
    (604800.0, "seconds of the GPS week"),
)

# What a step of the clock may be counted in: (unit, size [s]), the frequent ones first
UNITS = (("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9), ("min", 60.0), ("h", 3600.0), ("d", 86400.0))

READ = 'docs/logs.md, "Faults of time"'


def check_time(t: np.ndarray, *, header: str, factor: float, file: str) -> list[Finding]:
    """Check the time column.

    Parameters
    ----------
    t : (n,) float64   time [s], NaN where missing
    header : str       the column as written in the file
    factor : float     SI value of the column's unit [s]; values are shown in that unit
    file : str         name of the file

    Returns
    -------
    list of Finding    certain: few rows, missing, repeated, falling or jumping times, another unit,
                       too short; likely: gaps, a count from an epoch
    """
    column = f"column {shown(header)} of {file}"
    if t.size < FEWEST_ROWS:
        return [_refused(
            "too_short", header, f"{file} has {t.size} rows; {FEWEST_ROWS} are the least",
            "the recording was stopped early, or the file was cut off.",
            "similitude identify LONGER_LOG.csv",
        )]  # fmt: skip
    missing = np.flatnonzero(~np.isfinite(t))
    if missing.size:
        return [_no_time(missing, t.size, header, column)]
    dt = np.diff(t)
    disorder = _disorder(t, dt, header, column, factor)
    if disorder:
        return disorder
    usual = float(np.median(dt))
    found = [*_pace(usual, header, column, factor), *_clock_steps(t, dt, usual, header, column, factor)]
    if t[-1] - t[0] < SHORTEST_LOG:
        found.append(_refused(
            "too_short", header, f"{file} lasts {t[-1] - t[0]:.3g} s; {SHORTEST_LOG:g} s are the least",
            f"the recording was stopped early, or the unit of {shown(header)} is another.",
            "t [s]" if factor < 1 else "similitude identify LONGER_LOG.csv",
        ))  # fmt: skip
    return found or [*_epoch(t, header, column), *_gaps(t, dt, usual, header)]


def restarts(t: np.ndarray) -> np.ndarray:
    """Rows, counted from 0, whose time is missing, falls, or follows a set clock: a part begins."""
    dt = np.diff(t)
    usual = np.nanmedian(np.abs(dt)) if np.isfinite(dt).any() else np.inf
    return np.flatnonzero(~(dt > 0) & ~(dt == 0) | (dt > _jump(usual))) + 1


def runs_of_times(t: np.ndarray) -> np.ndarray | None:
    """First rows of each time, (k,), where rounded times repeat about equally often; None elsewhere.

    What is left out of it are rows that were written twice, and clocks that stood still for a while.
    """
    first = np.r_[0, np.flatnonzero(np.diff(t) != 0) + 1]
    counts = np.diff(np.r_[first, t.size])
    inner, steps = counts[1:-1], np.diff(t[first])
    if inner.size < FEWEST_TIMES or np.median(inner) < 2:
        return None
    even = np.abs(inner - np.median(inner)) <= np.maximum(1, EVEN * np.median(inner))
    equal = np.abs(steps - np.median(steps)) <= 0.5 * np.median(steps)
    return first if min(np.mean(even), np.mean(equal)) >= EVEN_SHARE else None


def counter_period(fall: float, usual: float) -> float | None:
    """Return the period [s] of the counter whose start explains a fall of time [s], or None."""
    for period, _ in COUNTERS:
        # The step across must look like a step, give or take a few lost samples; a looser rule takes
        # two recordings of just such a length for a counter.
        if 0 < period - fall <= 5 * usual and period > 50 * usual:
            return period
    return None


def _jump(usual: float) -> float:
    return min(max(1000 * usual, SHORTEST_JUMP), LARGEST_STEP)


def _no_time(missing: np.ndarray, rows: int, header: str, column: str) -> Finding:
    everywhere = missing.size == rows
    return _refused(
        "time_missing", header,
        f"{column} has no value in data row {missing[0] + 1}, and in {missing.size} of {rows} rows",
        "time stands in another column." if everywhere else "empty rows were written; this drops them.",
        '--map "t=COLUMN"' if everywhere else "",
        fix=None if everywhere else "drop_untimed_rows",
        rows=(int(missing[0]) + 1, int(missing[-1]) + 1),
    )  # fmt: skip


def _disorder(t: np.ndarray, dt: np.ndarray, header: str, column: str, factor: float) -> list[Finding]:
    wrong = np.flatnonzero(dt <= 0)
    if not wrong.size:
        return []
    repeated = int(np.count_nonzero(dt == 0))
    fallen = wrong[dt[wrong] < 0]
    first = int(fallen[0]) if fallen.size else int(wrong[0])
    rows = (first + 2, int(wrong[-1]) + 2)
    pair = f"{t[first] / factor:.9g} is followed by {t[first + 1] / factor:.9g}"
    if repeated == dt.size:
        rough = float(np.spacing(np.float32(abs(t[0]) / factor))) * factor > COARSE_CLOCK
        return [_refused(
            "time_stands", header, f"{column} is {t[0] / factor:.9g} in all {t.size} rows",
            "the time was stored in single precision, which holds seven digits: log it from zero on."
            if rough
            else "the clock of the logger stood still, or another column holds the time.",
            '--map "t=COLUMN"', rows=rows,
        )]  # fmt: skip
    where = f"in data row {rows[0]}: {pair}"
    if not fallen.size and runs_of_times(t) is not None:
        share = t.size / (dt.size - repeated + 1)
        return [_refused(
            "time_coarse", header,
            f"{column} has too few digits: {share:.3g} rows have one time, first {where}",
            "the rows are evenly apart and their time was rounded; this spreads them between the times.",
            fix="spread_times", value=share, rows=rows,
        )]  # fmt: skip
    if not fallen.size:
        return [_refused(
            "time_repeats", header,
            f"{column} repeats {where}; steps that do not rise: {wrong.size}",
            "rows were written twice, or time has too few digits; this keeps the first row of a time.",
            fix="drop_repeated_rows", rows=rows,
        )]  # fmt: skip
    counts = f"steps that do not rise: {wrong.size}, of them repeated: {repeated}"
    rising = dt[dt > 0]
    usual = float(np.median(rising)) if rising.size else float(np.median(np.abs(dt)))
    periods = {counter_period(-dt[at], usual) for at in fallen}
    if len(periods) == 1 and None not in periods:
        period = periods.pop()
        return [_refused(
            "time_wraps", header, f"{column} falls back {where}; {counts}",
            f"{dict(COUNTERS)[period]} starts anew every {period:.9g} s; this counts on.",
            fix="unwrap_time", value=period, rows=rows,
        )]  # fmt: skip
    # A few falls part the file into long pieces; many mean that rows stand in no order.
    if fallen.size <= max(1, t.size // 500):
        return [_refused(
            "time_restarts", header, f"{column} runs backward {where}; {counts}",
            "two recordings were joined, or the clock was set; this keeps the longest part.",
            fix="keep_longest_part", value=float(dt[first]), rows=rows,
        )]  # fmt: skip
    return [_refused(
        "time_unsorted", header, f"{column} runs backward {where}; {counts}",
        "rows were written in another order; this sorts them by time.",
        fix="sort_time", value=float(dt[first]), rows=rows,
    )]  # fmt: skip


def _pace(usual: float, header: str, column: str, factor: float) -> list[Finding]:
    raw = usual / factor
    if usual >= 1.0 or usual < 2e-5 or (usual > SLOWEST and factor != 1):
        near = [unit for unit, size in UNITS if not np.isclose(size, factor) and 1e-3 <= raw * size <= 0.5]
        slow = [unit for unit, size in UNITS if size < factor and 1e-4 <= raw * size <= 0.5]
        unit = (near + slow + [""])[0]
    else:
        unit = ""
    if not unit and 2e-5 <= usual <= SLOWEST:
        return []
    name = header.split("[")[0].strip() or "t"
    words = f"these values look like {unit}" if unit else (
        "the log was thinned out; 20 rows a second are enough" if usual > SLOWEST else "the unit is another"
    )  # fmt: skip
    return [_refused(
        "time_unit", header,
        f"{column}: the usual step is {usual:.6g} s, too {'slow' if usual > SLOWEST else 'fast'} for a "
        "driving log", f"{words}.",
        f"{name} [{unit}]" if unit else "similitude identify LOG_WITH_MORE_ROWS.csv", value=usual,
    )]  # fmt: skip


def _clock_steps(
    t: np.ndarray, dt: np.ndarray, usual: float, header: str, column: str, factor: float
) -> list[Finding]:
    jumps = np.flatnonzero(dt > _jump(usual))
    if not jumps.size:
        return []
    first = int(jumps[0])
    times = "once" if jumps.size == 1 else f"{jumps.size} times"
    return [_refused(
        "clock_step", header,
        f"{column} jumps by {dt[first]:.6g} s in data row {first + 2} ({t[first] / factor:.9g} "
        f"is followed by {t[first + 1] / factor:.9g}), {times} in all",
        "the clock was set while recording, or two recordings were joined; this keeps the longest part.",
        fix="keep_longest_part", value=float(dt[first]), rows=(first + 2, int(jumps[-1]) + 2),
    )]  # fmt: skip


def _epoch(t: np.ndarray, header: str, column: str) -> list[Finding]:
    if abs(t[0]) < SINCE_1970:
        return []
    digits = float(np.spacing(np.abs(t).max()))
    return [_said(
        "time_since_epoch", header,
        f"{column} begins at {t[0]:.9g} s, {t[0] / 31556952:.3g} years after its zero; steps below "
        f"{digits:.2g} s are lost",
        "time is counted from 1970 or another date; only differences matter.",
        f"{header.split('[')[0].strip() or 't'} [s]", value=float(t[0]),
    )]  # fmt: skip


def _gaps(t: np.ndarray, dt: np.ndarray, usual: float, header: str) -> list[Finding]:
    long = np.flatnonzero(dt > max(LONG_GAP, 3 * usual))
    lost = "samples were lost on the way to the recorder."
    found = [
        _said(
            "gap", header,
            f"gap of {dt[at]:.3g} s after t = {t[at]:.6g} s (data row {at + 2}): the dynamic "
            "state restarts there", lost, "similitude identify COMPLETE_LOG.csv",
            value=float(dt[at]), rows=(int(at) + 1, int(at) + 2),
        )
        for at in long[:5]
    ]  # fmt: skip
    if long.size > 5:
        found.append(_said(
            "gap", header, f"{long.size - 5} more gaps over {LONG_GAP:g} s: restarts there, too",
            lost, "similitude identify COMPLETE_LOG.csv", value=float(long.size - 5),
        ))  # fmt: skip
    short = int(np.count_nonzero(dt > LOST_SAMPLE * usual)) - long.size
    if short > 0:
        found.append(_said(
            "short_gaps", header,
            f"{short} short gap{'s' if short > 1 else ''} (steps over {LOST_SAMPLE:g} times the usual "
            f"{usual:.3g} s): no measurement there",
            lost, "similitude identify COMPLETE_LOG.csv", value=float(short),
        ))  # fmt: skip
    return found


def _refused(
    fault: str, header: str, what: str, usually: str, paste: str = "", *, fix: str | None = None,
    value: float | None = None, rows: tuple[int, int] | None = None,
) -> Finding:  # fmt: skip
    return Finding(
        fault, True, what, usually, paste if fix is None else f"--fix {fix}", READ,
        column=header, value=value, rows=rows, fix=fix,
    )  # fmt: skip


def _said(
    fault: str, header: str, what: str, usually: str, paste: str, *,
    value: float | None = None, rows: tuple[int, int] | None = None,
) -> Finding:  # fmt: skip
    return Finding(fault, False, what, usually, paste, READ, column=header, value=value, rows=rows)
