"""The signals of a drive side by side on one even clock, for what is read from two at once.

Invariant: only rows that were measured count; across a pause of more than `LONGEST_BRIDGE` nothing
is filled in, so no relation is read from values that nobody measured.

    t time [s];  steer angle of the road wheel or of the steering wheel [rad];  r yaw rate [rad/s];
    U speed [m/s];  ay lateral acceleration [m/s^2]
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.inspection.timing import Timing

LONGEST_BRIDGE = 0.1  # s: hands on a wheel do little in between
TORN = 10  # times more steps than rows: almost nothing would be there on an even clock
LARGEST = 1e6  # SI; what is larger is damage, and its square would drown everything
FINEST = 200.0  # Hz: yaw dynamics are slower by far


@dataclass(frozen=True, eq=False)
class Signals:
    """Signals on an even clock, (n,) each, NaN where nothing was measured; None where there is none.

    `at_wheel` says that `steer` is the angle of the steering wheel.
    """

    step: float
    t: NDArray[np.float64]
    steer: NDArray[np.float64] | None
    r: NDArray[np.float64] | None
    U: NDArray[np.float64] | None
    ay: NDArray[np.float64] | None
    at_wheel: bool = False


def even_signals(values: Mapping[str, NDArray[np.float64]], clock: Timing | None) -> Signals | None:
    """Put columns of a log on an even clock of the log's own rate, at most `FINEST`.

    Parameters
    ----------
    values : mapping    quantity -> (n,) SI values; those of `similitude.log_survey.Survey`
    clock : Timing      of the column "t"

    Returns
    -------
    Signals             None where the clock does not rise or is torn: nothing can be put in order.
    """
    if clock is None or not clock.is_usable:
        return None
    t = values["t"]
    step = max(clock.step, 1.0 / FINEST)
    if clock.duration / step > TORN * clock.rows:
        return None
    count = int(clock.duration / step) + 1
    even = t[0] + step * np.arange(count)
    at_wheel = "steering_wheel" in values and "delta" not in values
    steer = values.get("steering_wheel" if at_wheel else "delta")
    columns = (steer, values.get("r"), values.get("U"), values.get("ay"))
    placed = (None if column is None else _placed(t, column, even, clock.step) for column in columns)
    return Signals(step, even, *placed, at_wheel=at_wheel)


def _placed(t, column, even, usual: float) -> NDArray[np.float64] | None:
    """A column on the even clock; None where it has fewer than two numbers."""
    known = np.flatnonzero(np.abs(column) < LARGEST)
    if known.size < 2:
        return None
    there = t[known]
    on_clock = np.interp(even, there, column[known], left=np.nan, right=np.nan)
    after = np.clip(np.searchsorted(there, even), 1, known.size - 1)
    hole = there[after] - there[after - 1] > max(LONGEST_BRIDGE, 3 * usual)
    exact = np.isclose(even, there[after], rtol=0, atol=1e-9)
    return np.where(hole & ~exact, np.nan, on_clock)
