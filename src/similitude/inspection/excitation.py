"""What happens when: windows of the drive with how much was steered, how hard, how fast.

Invariant: every window has one kind, the first of `KINDS` that applies to half of it or more (to a
tenth, for what is beyond the linear range); windows follow one another without overlap.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.inspection.signals import Signals

WINDOW = 2.0  # s: two periods of the slowest steering that shows tyres
LINEAR = 0.3 * 9.80665  # m/s^2
STANDSTILL = 0.5  # m/s
BEYOND = 0.1  # share of a window
HARDLY = 0.4e-3  # rad at the road wheel: the filter learns nothing from less
AT_WHEEL = 16.0  # a steering wheel turns this much more

KINDS = {
    "missing": "not measured",
    "standing": "standing",
    "reverse": "reverse",
    "beyond_linear": "beyond 0.3 g",
    "straight": "hardly steered",
    "steered": "steered, linear",
}


@dataclass(frozen=True)
class Window:
    """Two seconds of a drive: ``steer_rms`` about its own straight line [rad]; None where missing."""

    at: float  # s
    kind: str
    speed: float | None  # m/s
    steer_rms: float | None  # rad
    sideways: float | None  # largest |r U| [m/s^2]


def excitation(signals: Signals) -> tuple[Window, ...]:
    """Cut a drive into windows; empty without steer, yaw rate and speed, or for less than a window.

    The rms about a straight line keeps what is faster than about 0.3 Hz.
    """
    if signals.steer is None or signals.r is None or signals.U is None:
        return ()
    rows = max(2, round(WINDOW / signals.step))
    count = signals.t.size // rows
    steer, r, U = (x[: count * rows].reshape(count, rows) for x in (signals.steer, signals.r, signals.U))
    there = np.isfinite(steer) & np.isfinite(r) & np.isfinite(U)
    rms = _about_line(steer)
    least = HARDLY * (AT_WHEEL if signals.at_wheel else 1.0)
    sideways = np.abs(r * U)
    windows = []
    for i in range(count):
        ok = there[i]
        kind = _kind(ok, U[i], sideways[i], rms[i] < least)
        known = bool(ok.any())
        windows.append(
            Window(
                at=float(signals.t[i * rows]),
                kind=kind,
                speed=float(np.mean(U[i][ok])) if known else None,
                steer_rms=float(rms[i]) if np.isfinite(rms[i]) else None,
                sideways=float(np.max(sideways[i][ok])) if known else None,
            )
        )
    return tuple(windows)


def _kind(there, U, sideways, is_straight: bool) -> str:
    if there.mean() < 0.5:
        return "missing"
    U, sideways = U[there], sideways[there]
    if np.mean(np.abs(U) < STANDSTILL) >= 0.5:
        return "standing"
    if np.mean(U <= -STANDSTILL) >= 0.5:
        return "reverse"
    if np.mean(sideways > LINEAR) >= BEYOND:
        return "beyond_linear"
    return "straight" if is_straight else "steered"


def _about_line(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rms of each row (k, n) about its own straight line; NaN where a value is missing."""
    x = np.linspace(-1.0, 1.0, values.shape[1])
    flat = values - values.mean(axis=1, keepdims=True)
    slope = flat @ x / (x @ x)
    return np.sqrt(np.mean((flat - slope[:, None] * x) ** 2, axis=1))


def seconds_by_kind(windows: tuple[Window, ...]) -> dict[str, float]:
    """Time spent in each kind [s], every kind named."""
    return {kind: WINDOW * sum(one.kind == kind for one in windows) for kind in KINDS}
