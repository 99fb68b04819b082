"""How fast the car goes: constant, a ramp (which is braking, too), a sinusoid, or as in a log."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.dimension import SPEED, TIME
from similitude.simulation.keys import key

_FASTEST = 150.0  # m/s


@dataclass(frozen=True, kw_only=True)
class Constant:
    """Always the same speed."""

    value: float = key('"80 km/h"', SPEED, "speed", least=0.1, most=_FASTEST)

    def at(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the speed at times t (n,) [m/s]."""
        return np.full(t.size, self.value)


@dataclass(frozen=True, kw_only=True)
class Ramp:
    """From one speed to another, evenly; held before and after."""

    first: float = key('"100 km/h"', SPEED, "speed before", least=0.1, most=_FASTEST)
    last: float = key('"50 km/h"', SPEED, "speed after", least=0.1, most=_FASTEST)
    begin: float = key('"10 s"', TIME, "when it begins", least=0)
    duration: float = key('"3 s"', TIME, "how long it takes", least=1e-3)

    def at(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the speed at times t (n,) [m/s]."""
        return np.interp(t, [self.begin, self.begin + self.duration], [self.first, self.last])


@dataclass(frozen=True, kw_only=True)
class Sinusoid:
    """Swaying about a mean."""

    mean: float = key('"90 km/h"', SPEED, "mean speed", least=0.1, most=_FASTEST)
    amplitude: float = key('"20 km/h"', SPEED, "amplitude", least=0)
    period: float = key('"30 s"', TIME, "period", least=0.1)

    def at(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the speed at times t (n,) [m/s]."""
        return self.mean + self.amplitude * np.sin(2 * math.pi * t / self.period)


@dataclass(frozen=True, kw_only=True)
class Logged:
    """As in the log that gives the steer, whose rows are filled in when it is read.

    Parameters
    ----------
    at_least : float       where the log is slower, this is driven [m/s]
    times, speeds : (n,)   [s], [m/s]
    """

    at_least: float = key('"3 m/s"', SPEED, "driven where the log is slower", least=0.1, most=_FASTEST)
    times: NDArray[np.float64] | None = None
    speeds: NDArray[np.float64] | None = None

    def at(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the speed at times t (n,) [m/s]; before and after the log its ends."""
        return np.maximum(np.interp(t, self.times, self.speeds), self.at_least)


SPEEDS = {"constant": Constant, "ramp": Ramp, "sinusoid": Sinusoid, "log": Logged}
