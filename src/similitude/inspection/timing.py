"""The clock of a log: its usual step, how evenly it runs, where it pauses, jumps or turns back.

Invariant: nothing is sorted or dropped; a clock that runs backward is described as it runs.

    t time [s], as in the file
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

LOST = 1.8  # usual steps: a row is missing; jitter of a bus stays below
JUMP = 60.0  # s: longer than any pause of a recording; the clock was set


@dataclass(frozen=True)
class Pause:
    """A step of the clock that is out of the usual."""

    at: float  # time before it [s]
    length: float  # s; negative where the clock turned back
    row: int  # data row after it, counted from 1


@dataclass(frozen=True)
class Timing:
    """How the clock runs.

    Parameters
    ----------
    rows : int                     rows of the file
    missing : int                  rows without a time
    duration : float               last time less first [s]
    step, step_low, step_high      median, 1st and 99th percentile of the steps [s]
    gaps : tuple of Pause          steps over 1.8 usual ones, the longest first
    jumps : tuple of Pause         steps over a minute, and steps backward
    repeated : int                 steps of exactly zero
    lost : float                   share of the duration inside gaps [-]
    """

    rows: int
    missing: int
    duration: float
    step: float
    step_low: float
    step_high: float
    gaps: tuple[Pause, ...] = ()
    jumps: tuple[Pause, ...] = ()
    repeated: int = 0
    lost: float = 0.0

    @property
    def rate(self) -> float:
        """Rows a second, from the usual step [Hz]; 0 where the clock stands."""
        return 1.0 / self.step if self.step > 0 else 0.0

    @property
    def is_usable(self) -> bool:
        """Whether time rises from row to row, so that relations between columns mean something."""
        return self.step > 0 and not (self.missing or self.repeated or any(p.length <= 0 for p in self.jumps))


def timing(t: NDArray[np.float64]) -> Timing | None:
    """Describe a time column, (n,) [s]; None where fewer than two rows have a time."""
    known = np.flatnonzero(np.isfinite(t))
    if known.size < 2:
        return None
    at, steps = t[known][:-1], np.diff(t[known])
    forward = steps[steps > 0]
    step = float(np.median(forward)) if forward.size else 0.0
    low, high = np.quantile(steps, [0.01, 0.99])
    is_jump = (steps < 0) | (steps > max(JUMP, LOST * step))
    is_gap = (steps > LOST * step) & ~is_jump
    duration = float(t[known[-1]] - t[known[0]])
    lost = float((steps[is_gap] - step).sum()) / duration if duration > 0 else 0.0
    return Timing(
        rows=int(t.size),
        missing=int(t.size - known.size),
        duration=duration,
        step=step,
        step_low=float(low),
        step_high=float(high),
        gaps=_pauses(at, steps, known, is_gap),
        jumps=_pauses(at, steps, known, is_jump),
        repeated=int(np.count_nonzero(steps == 0)),
        lost=float(np.clip(lost, 0.0, 1.0)),
    )


def _pauses(at, steps, known, which) -> tuple[Pause, ...]:
    rows = np.flatnonzero(which)
    rows = rows[np.argsort(-np.abs(steps[rows]), kind="stable")]
    return tuple(Pause(float(at[i]), float(steps[i]), int(known[i + 1]) + 1) for i in rows)
