"""Missing cells, columns slower than the file, and columns that never move.

Invariant: values are never changed here.
"""

from __future__ import annotations

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding

STUCK_ROWS = 50
FEWEST_CELLS = 20
# A slower column has its cells at one distance; jitter between two buses makes it plus or minus one
# row, so nine distances in ten lie within a row of the median.
REGULAR_SHARE = 0.9

READ = 'docs/logs.md, "Faults of cells"'


def check_column(values: np.ndarray, *, header: str, file: str, may_rest: bool, held: bool) -> list[Finding]:
    """Check one column for missing and stuck values.

    Parameters
    ----------
    values : (n,) float64   in any unit, NaN where missing
    header : str            the column as written in the file
    file : str              name of the file
    may_rest : bool         True where a constant is no fault (speed)
    held : bool             True where a value acts until the next one (steer, speed), so that a
                            slower column may be held

    Returns
    -------
    list of Finding         certain: empty, mostly empty without order, or constant; likely: slower
                            than the file, or some cells missing
    """
    column = f"column {shown(header)} of {file}"
    missing = np.isnan(values)
    count, row = int(np.count_nonzero(missing)), int(np.argmax(missing)) + 1
    if count == values.size:
        return [Finding(
            "column_empty", True, f"{column} is empty",
            "the sensor was not connected, or another column holds the signal.",
            f'--map "{_name(header)}=COLUMN"', READ, column=header, value=1.0,
        )]  # fmt: skip
    slower = slower_by(values)
    if count > values.size / 2 and slower is None:
        return [Finding(
            "column_mostly_empty", True,
            f"{column} has no number in {count} of {values.size} rows, first in data row {row}",
            "the sensor was not connected for most of the drive.",
            f'--map "{_name(header)}=COLUMN"', READ, column=header, value=count / values.size,
        )]  # fmt: skip
    if not may_rest and values.size > STUCK_ROWS and np.nanmin(values) == np.nanmax(values):
        return [Finding(
            "column_stuck", True,
            f"{column} is stuck: it is {np.nanmax(values):.6g} (SI) in all {values.size} rows",
            "the sensor was not connected, or the car was parked.",
            f'--map "{_name(header)}=COLUMN"', READ, column=header, value=float(np.nanmax(values)),
        )]  # fmt: skip
    if slower is not None:
        return [_slower(slower, count, values.size, header, held)]
    if not count:
        return []
    return [Finding(
        "cells_missing", False,
        f"column {shown(header)}: {count} of {values.size} cells are missing "
        f"({100 * count / values.size:.2g} %), first in data row {row}: no measurement there",
        "messages were lost on the bus.", "similitude identify COMPLETE_LOG.csv", READ,
        column=header, value=count / values.size, rows=(row, int(np.flatnonzero(missing)[-1]) + 1),
    )]  # fmt: skip


def slower_by(values: np.ndarray) -> float | None:
    """Rows from one value to the next where a column is regularly slower than the file, else None."""
    known = np.flatnonzero(~np.isnan(values))
    if known.size < FEWEST_CELLS:
        return None
    apart = np.diff(known)
    usual = float(np.median(apart))
    # Half the cells empty has a median of 2; one lost cell in ten has a median of 1.
    if usual < 2 or np.mean(np.abs(apart - usual) <= 1) < REGULAR_SHARE:
        return None
    return float(np.mean(apart[np.abs(apart - usual) <= 1]))


def _slower(every: float, count: int, rows: int, header: str, held: bool) -> Finding:
    what = (
        f"column {shown(header)} is {every:.3g} times slower than the file: {count} of {rows} cells are empty"
    )
    if not held:
        return Finding(
            "column_slower", False, what + "; it is measured that much less often",
            "the sensor has its own rate, and the recorder writes a row for each message.",
            "similitude identify LOG.csv", READ, column=header, value=every,
        )  # fmt: skip
    return Finding(
        "column_slower", False, what + ", and nothing is learnt in those rows",
        "the sensor has its own rate; this holds each value until the next one.",
        "--fix hold_slow_columns", READ, column=header, value=every, fix="hold_slow_columns",
    )  # fmt: skip


def _name(header: str) -> str:
    return header.split("[")[0].strip() or "r"
