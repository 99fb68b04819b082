"""A time in minutes or hours that claims seconds: a driver and a car that move sixty times too fast.

Invariant: no value is changed. Judged only where steer and yaw rate are alike, so that neither is noise.

    tau half-time [s]: delay after which a signal is half like itself, 1/6 of a sine's period
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding
from similitude.log_columns import Column

SLOWEST_ROWS = 250.0  # a second; four rows a second in minutes
LONGEST = 60_000  # rows; more tell no more
ALIKE = 0.5  # correlation of steer and yaw rate
SMOOTH = 0.5  # correlation of a signal with itself a row later; below, it is mostly noise
FASTEST = 0.04  # s; a half-time of 4 Hz: hands on a wheel and the mass of a car are slower
HURRIED = 0.1  # s; 1.7 Hz; with a yaw rate that is not late either
PROMPT = 0.006  # s; no yaw inertia lets a car answer so soon
USUAL = 0.06  # s; half-time of drivers, from which on a unit explains it
UNITS = (("s", 1.0), ("min", 60.0), ("h", 3600.0))

READ = 'docs/logs.md, "Faults of time"'


def check_time_scale(
    values: Mapping[str, np.ndarray], columns: Mapping[str, Column], *, file: str
) -> list[Finding]:
    """Compare the pace of steer and yaw rate with what people and cars can do.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI: "t" rising, "delta" and "r"
    columns : mapping of str to Column        where they come from
    file : str                                name of the file

    Returns
    -------
    list of Finding                           certain: both move faster than 4 Hz; likely: faster than
                                              1.7 Hz, and the car answers at once
    """
    step = float(np.median(np.diff(values["t"])))
    if step * SLOWEST_ROWS > 1:
        return []
    pace = _pace(values["delta"][:LONGEST], values["r"][:LONGEST])
    if pace is None:
        return []
    half, late = pace[0] * step, pace[1] * step
    certain = half < FASTEST
    if not certain and not (half < HURRIED and abs(late) < PROMPT):
        return []
    raw = half / columns["t"].unit.factor
    unit = next(
        (name for name, size in UNITS if size > columns["t"].unit.factor and raw * size >= USUAL), "h"
    )
    header = columns["t"].header
    return [Finding(
        "time_unit", certain,
        f"column {shown(header)} of {file} has {1 / step:.4g} rows a second, and steer and yaw rate are half "
        f"of what they were after {1000 * half:.3g} ms: no driver steers so fast",
        f"these values look like {unit}.", f"{header.split('[')[0].strip() or 't'} [{unit}]", READ,
        column=header, value=half,
    )]  # fmt: skip


def _pace(steer: np.ndarray, rate: np.ndarray) -> tuple[float, float] | None:
    """Half-time of the slower of the two, and by how much the yaw rate is later, in rows; None if unlike."""
    x, y = _centred(steer), _centred(rate)
    size = 2 ** int(np.ceil(np.log2(2 * x.size)))
    a, b = np.fft.rfft(x, size), np.fft.rfft(y, size)
    own = [np.fft.irfft(np.abs(one) ** 2, size)[: x.size] for one in (a, b)]
    if min(one[0] for one in own) <= 0 or any(one[1] < SMOOTH * one[0] for one in own):
        return None
    both = np.fft.irfft(np.conj(a) * b, size) / np.sqrt(own[0][0] * own[1][0])
    at = int(np.argmax(both))
    if both[at] < ALIKE:
        return None
    halves = [int(np.argmax(one < 0.5 * one[1])) for one in own]
    if 0 in halves:
        return None
    return float(max(halves)), float(at if at < size // 2 else at - size)


def _centred(x: np.ndarray) -> np.ndarray:
    known = np.isfinite(x)
    return np.where(known, x - x[known].mean(), 0.0) if known.any() else np.zeros(x.size)
