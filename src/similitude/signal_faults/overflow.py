"""A sensor whose number of bits is too small: beyond an end of its range it goes on at the other end.

Invariant: no value is changed but by `unwrapped`, which adds whole ranges.

    x any signal (n,);  R range, what is lost at a jump: x is logged as x - R k with k whole
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding
from similitude.log_columns import Column

FAR = 0.6  # of the whole range from one row to the next: no car turns so fast
FEWEST_JUMPS, MOST_JUMPS = 2, 0.2  # there and back, and of the rows: more is how the signal is
BETWEEN = 0.3  # of the range; hardly a step lies between this and a jump
UNUSUAL = 5.0  # sds of the usual steps, which a jump is beyond: noise throws none of them
ROOM = 8.0  # of these sds, by which jumps may differ in size
CONSTANT = 0.25  # of the range, within which they agree at all
CLOSE = 0.1  # of the range: an overflow leaves no part of it unused
BULGE = 0.02  # of the range, by which the signal goes on beyond its end; below, it is a spike
BITS = range(7, 25)
TINY = 1e-8  # of the range: the last digits of a float
POWER = 0.01  # of the range, within which it is a power of two of the reading's step

READ = 'docs/logs.md, "Faults of sensors"'


@dataclass(frozen=True, eq=False)
class Overflow:
    """Where a signal went round, (n,) whole ranges to add to each row, and the range."""

    turns: np.ndarray
    span: float
    is_binary: bool  # the range is a power of two of the step of the readings


def check_overflow(
    values: Mapping[str, np.ndarray], columns: Mapping[str, Column], *, file: str
) -> dict[str, Finding]:
    """Find signals that go on at the other end of their range.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI; "delta" or "steering_wheel", and "r"
    columns : mapping of str to Column        where they come from
    file : str                                name of the file

    Returns
    -------
    dict of str to Finding                    quantity -> a certain fault
    """
    names = [name for name in ("delta", "steering_wheel", "r") if name in values and name in columns]
    met = {name: overflow(values[name]) for name in names}
    return {name: _said(found, columns[name], file) for name, found in met.items() if found is not None}


def overflow(x: np.ndarray) -> Overflow | None:
    """How a signal (n,), NaN where missing, went round; None where it did not."""
    known = np.flatnonzero(np.isfinite(x))
    if known.size < 20:
        return None
    step = np.diff(x[known])
    whole = float(np.ptp(x[known]))
    far = np.abs(step) > FAR * whole
    jumps = np.flatnonzero(far)
    usual = 1.4826 * float(np.median(np.abs(step)))
    if not FEWEST_JUMPS <= jumps.size <= MOST_JUMPS * step.size or FAR * whole < UNUSUAL * usual:
        return None
    if np.count_nonzero(np.abs(step) > BETWEEN * whole) > 1 + 1.25 * jumps.size:
        return None
    calm = np.where(far, 0.0, step)
    sizes = np.abs(step[jumps] - 0.5 * (np.r_[0.0, calm][jumps] + np.r_[calm, 0.0][jumps + 1]))
    jump = float(np.median(sizes))
    span = max(jump, whole)
    room = min(ROOM * usual, CONSTANT * span)
    if np.mean(np.abs(sizes - span) <= room) < 0.9 or span - whole > CLOSE * span + room:
        return None
    span, is_binary = _whole(span, x[known])
    turns = np.zeros(x.size)
    turns[known[1:]] = np.cumsum(np.where(far, -np.sign(step), 0.0))
    turns[known] -= np.round(np.median(turns[known]))
    return Overflow(turns, span, is_binary) if _bulges(x[known], turns[known], jump, usual) else None


def unwrapped(x: np.ndarray) -> np.ndarray:
    """The signal (n,) as it would have been read in a wider number; itself where it did not go round."""
    found = overflow(x)
    return x if found is None else x + found.turns * found.span


def _bulges(x: np.ndarray, turns: np.ndarray, span: float, usual: float) -> bool:
    """Whether the signal goes on beyond the ends in a bow: not flat as a switch, nor a single spike."""
    beyond = turns != 0
    if not beyond.any() or np.mean(beyond) > 0.5:
        return False
    edges = np.flatnonzero(np.diff(np.r_[False, beyond, False].astype(np.int8)))
    parts = list(zip(edges[::2], edges[1::2], strict=True))
    if len(parts) < 2 and parts[0][1] - parts[0][0] < 2:
        return False
    true = x + turns * span
    inside = x[~beyond]
    low, high = float(inside.min()), float(inside.max())
    heights = [max(float(true[a:b].max()) - high, low - float(true[a:b].min())) for a, b in parts]
    return max(heights) > BULGE * span + 1.5 * usual


def _whole(span: float, x: np.ndarray) -> tuple[float, bool]:
    """The range as a power of two of the step of the readings, and whether it is one.

    Of thousands of readings some lie one step apart, though none of them may follow one another.
    """
    apart = np.diff(np.sort(x))
    least = float(np.min(apart, where=apart > TINY * span, initial=span))
    for bits in BITS:
        if abs(least * 2**bits / span - 1) < POWER:
            return least * 2**bits, True
    return span, False


def _said(found: Overflow, column: Column, file: str) -> Finding:
    rows = np.flatnonzero(found.turns)
    size = f"{found.span / column.unit.factor:.6g} {column.unit.text}"
    size += " (a power of two of its readings' steps)" if found.is_binary else ""
    return Finding(
        "overflow", True,
        f"column {shown(column.header)} of {file} jumps by {size} from one end of its range to the other, "
        f"first in data row {rows[0] + 1}; {rows.size} rows are beyond it",
        "the sensor's number has too few bits and starts anew at the other end; this counts on.",
        "--fix unwrap_overflow", READ, column=column.header, value=found.span,
        rows=(int(rows[0]) + 1, int(rows[-1]) + 1), fix="unwrap_overflow",
    )  # fmt: skip
