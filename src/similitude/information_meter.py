"""Information in the driver's terms: how wide the interval is, and what it would take to halve it.

While ln K drifts with q [1/s] and a drive says I [1/s], its variance follows V' = q - I V^2 and stops at
sqrt(q/I); halving the interval takes the time in which V falls to a quarter, or more steer where it does
not. Information grows with the square of the steer.

Invariant: what is said of the future is what the last minute said, nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.filter_config import DESIGN

RECENT = 60.0  # s
MORE = (1.5, 2.0, 3.0, 4.0, 6.0, 8.0)  # times as much steer
LONGEST = 600.0  # s: longer than that is not worth promising
LEAST_RATE = 1e-6  # 1/s


@dataclass(frozen=True)
class Information:
    """Of ln K at the end of a log.

    ``interval`` half the width of the 95 % interval [%];  ``rate`` information a second over the last
    minute [1/s];  ``seconds`` of driving like that minute that halve it, None where they would not;
    ``steer`` times as much steer with which a minute does, None where not even that;  ``text`` in words.
    """

    interval: float
    rate: float
    seconds: float | None
    steer: float | None
    text: str


def information(t: NDArray[np.float64], gained: NDArray[np.float64], ln_K_std: float) -> Information:
    """Weigh what the last minute said.

    Parameters
    ----------
    t, gained : (n,)   time [s] and information about ln K gained so far [-].
    ln_K_std : float   sd of ln K at the end.
    """
    start = int(np.searchsorted(t, t[-1] - RECENT))
    span = float(t[-1] - t[start])
    rate = float(gained[-1] - gained[start]) / span if span > 0 else 0.0
    seconds = _time_to_quarter(ln_K_std**2, rate)
    times = (more for more in MORE if _within(_time_to_quarter(ln_K_std**2, rate * more**2), RECENT))
    steer = next(times, None)
    interval = 100 * float(np.expm1(1.96 * min(ln_K_std, 5.0)))
    now = f"K is known to +{interval:.0f} % (95 %)"
    if seconds is not None:
        text = f"{now}; {seconds:.0f} s more of driving like the last {span:.0f} s would halve that"
    elif rate <= LEAST_RATE:
        text = f"{now}; the last {span:.0f} s said nothing about it"
    else:
        text = f"{now}; driving like the last {span:.0f} s will not halve that"
    if seconds is None or seconds > RECENT:
        text += f", {steer:g} times the steer would in a minute" if steer else ""
    return Information(interval, rate, seconds, steer, text)


def _within(seconds: float | None, limit: float) -> bool:
    return seconds is not None and seconds <= limit


def _time_to_quarter(variance: float, rate: float) -> float | None:
    """Time in which the variance falls to a quarter [s], None where it would not in `LONGEST`."""
    if rate <= LEAST_RATE or variance <= 0:
        return None
    drift = DESIGN["drift"]
    rest, pace = np.sqrt(drift / rate), 2 * np.sqrt(drift * rate)
    low = variance / 4
    if low <= rest:
        return None
    seconds = float(np.log((low + rest) / (low - rest) * (variance - rest) / (variance + rest)) / pace)
    return seconds if seconds <= LONGEST else None
