"""From the commanded angle to the wheels: delay, play, rate limit, lag, servo; then what nobody sees.

Invariant: each stage is exact for a command that is straight between instants, and one tick of the
whole chain needs only the newest command. What the rack reaches is what an angle sensor can see;
compliance (scale, offset, wander) lies behind it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from similitude.dimension import FREQUENCY, TIME
from similitude.simulation.arithmetic import Arithmetic
from similitude.simulation.keys import ANGLE, NUMBER, key


@dataclass(frozen=True, kw_only=True)
class Actuator:
    """The steering system of a scenario; a stage that is left out passes everything on at once."""

    delay: float = key('"20 ms"', TIME, "pure delay", default=0.0, least=0, most=2)
    play: float = key('"1 mrad"', ANGLE, "width of the play at the wheels", default=0.0, least=0, most=0.2)
    rate_limit: float = key('"0.5 rad/s"', FREQUENCY, "fastest steer", default=math.inf, least=1e-3)
    lag: float = key('"30 ms"', TIME, "time constant of a first-order lag", default=0.0, least=0, most=5)
    servo: float = key('"5 Hz"', FREQUENCY, "natural frequency of a second-order servo", default=0.0,
                       least=0.05, most=200)  # fmt: skip
    damping: float = key("0.707", NUMBER, "its damping ratio", default=0.707, least=0.05, most=5)
    scale: float = key("1.03", NUMBER, "wheel angle over rack angle", default=1.0, least=0.1, most=10)
    offset: float = key('"2 mrad"', ANGLE, "wheel angle where the rack stands straight", default=0.0,
                        least=-0.5, most=0.5)  # fmt: skip
    wander: float = key('"0.7 mrad"', ANGLE, "standard deviation of a slow disturbance of the wheels",
                        default=0.0, least=0, most=0.2)  # fmt: skip
    wander_share: float = key("0.04", NUMBER, "the same in proportion to the angle", default=0.0,
                              least=0, most=1)  # fmt: skip
    wander_time: float = key('"2 s"', TIME, "its correlation time", default=2.0, least=1e-2)


class Chain:
    """The stages of an actuator over one drive; holds what they remember.

    Parameters
    ----------
    actuator : Actuator
    step : float         time between ticks [s]
    first : float or (cars,)   angle at which everything has come to rest [rad]
    on : Arithmetic
    """

    def __init__(self, actuator: Actuator, *, step: float, first: Any, on: Arithmetic) -> None:
        self._is, self._on, self._step = actuator, on, step
        whole, part = divmod(actuator.delay / step, 1.0)
        # A delay of n steps but for rounding is n steps.
        self._part = 0.0 if part > 1 - 1e-9 or part < 1e-9 else part
        self._queue = [first] * (int(whole) + (part > 1 - 1e-9) + 2)
        self._geared = self._limited = self._input = self._lagged = self._rack = first
        self._speed = 0.0 * first
        self._kept, self._lag_weights = _lag(actuator.lag / step)
        self._servo = _servo(actuator, step) if actuator.servo else None

    def tick(self, command: Any) -> Any:
        """Return the rack's angle [rad] one step on, where the newest command is `command` [rad]."""
        acting = self._delayed(command) if self._is.delay else command
        if self._is.play:
            half = 0.5 * self._is.play
            acting = self._geared = self._on.minimum(
                self._on.maximum(self._geared, acting - half), acting + half
            )
        if self._is.rate_limit < math.inf:
            most = self._is.rate_limit * self._step
            change = self._on.minimum(self._on.maximum(acting - self._limited, -most), most)
            acting = self._limited = self._limited + change
        before, self._input = self._input, acting
        if self._is.lag:
            old, new = self._lag_weights
            lagged = self._kept * self._lagged + old * before + new * acting
            before, self._lagged = self._lagged, lagged
            acting = lagged
        if self._servo is None:
            self._rack = acting
        else:
            (a, b, c, d), (e, f), (g, h) = self._servo
            angle, speed = self._rack, self._speed
            self._rack = a * angle + b * speed + e * before + g * acting
            self._speed = c * angle + d * speed + f * before + h * acting
        return self._rack

    def _delayed(self, command: Any) -> Any:
        queue = self._queue
        queue.append(command)
        queue.pop(0)
        return queue[1] * (1 - self._part) + queue[0] * self._part


def _lag(steps: float) -> tuple[float, tuple[float, float]]:
    """Decay over one tick and the weights of a straight input's two ends; time constant in ticks."""
    if not steps:
        return 0.0, (0.0, 1.0)
    kept = math.exp(-1 / steps)
    new = 1 - steps * (1 - kept)
    return kept, (1 - kept - new, new)


def _servo(actuator: Actuator, step: float) -> tuple:
    """Transition of (angle, speed) over one tick and the weights of a straight input's two ends."""
    from scipy.linalg import expm

    w = 2 * math.pi * actuator.servo
    block = np.zeros((4, 4))
    block[0, 1] = step
    block[1, :3] = np.array([-w * w, -2 * actuator.damping * w, w * w]) * step
    block[2, 3] = 1.0
    E = expm(block)
    new = E[:2, 3]
    return tuple(E[:2, :2].ravel().tolist()), tuple((E[:2, 2] - new).tolist()), tuple(new.tolist())


def wheel_angle(actuator: Actuator, rack: Any, wander: Any) -> Any:
    """Return the angle of the road wheels [rad].

    Math: s δ + δ0 + z (w0 + w1 |δ|).

    Parameters
    ----------
    rack : float or array      δ [rad]
    wander : float or array    z, the slow disturbance with variance 1 [-]
    """
    spread = actuator.wander + actuator.wander_share * abs(rack)
    return actuator.scale * rack + actuator.offset + wander * spread
