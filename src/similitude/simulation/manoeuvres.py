"""Steer that does not look at the road: slalom, sweep, lane changes, turns, noise, a log.

Every manoeuvre gives the commanded road-wheel angle over time; nothing about the car is known.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.dimension import FREQUENCY, TIME
from similitude.simulation.car import generator
from similitude.simulation.keys import ANGLE, key

Array = NDArray[np.float64]
_AMPLITUDE = {"least": 0, "most": 1.2}  # rad
_RAMP_IN = 0.5  # s in which a periodic steer grows to its amplitude


def _angle(example: str, words: str):
    return key(example, ANGLE, words, **_AMPLITUDE)


def _begin():
    return key('"2 s"', TIME, "straight ahead until then", default=0.0, least=0)


@dataclass(frozen=True, kw_only=True)
class Straight:
    """No steer at all."""

    def steer(self, t: Array, seed: int) -> Array:
        """Return the commanded road-wheel angle (n,) [rad]."""
        return np.zeros(t.size)


@dataclass(frozen=True, kw_only=True)
class Slalom:
    """A sine."""

    amplitude: float = _angle('"20 mrad"', "of the road wheels")
    frequency: float = key('"0.5 Hz"', FREQUENCY, "frequency", least=1e-3, most=20)
    begin: float = _begin()

    def steer(self, t: Array, seed: int) -> Array:
        """Return the commanded road-wheel angle (n,) [rad]."""
        late = np.maximum(t - self.begin, 0)
        return self.amplitude * np.minimum(late / _RAMP_IN, 1) * np.sin(2 * math.pi * self.frequency * late)


@dataclass(frozen=True, kw_only=True)
class Sweep:
    """A sine whose frequency grows by equal factors in equal times, over and over."""

    amplitude: float = _angle('"10 mrad"', "of the road wheels")
    slowest: float = key('"0.2 Hz"', FREQUENCY, "frequency at the start", least=1e-3, most=20)
    fastest: float = key('"4 Hz"', FREQUENCY, "frequency at the end", least=1e-3, most=20)
    duration: float = key('"30 s"', TIME, "length of one sweep", least=0.1)
    begin: float = _begin()

    def steer(self, t: Array, seed: int) -> Array:
        """Return the commanded road-wheel angle (n,) [rad]."""
        late = np.maximum(t - self.begin, 0)
        within = np.mod(late, self.duration)
        growth = math.log(self.fastest / self.slowest) / self.duration
        turns = self.slowest * (np.expm1(growth * within) / growth if growth else within)
        return self.amplitude * np.minimum(late / _RAMP_IN, 1) * np.sin(2 * math.pi * turns)


@dataclass(frozen=True, kw_only=True)
class DoubleLaneChange:
    """To the left lane and back: two sines of opposite sign with a pause between them, repeated."""

    amplitude: float = _angle('"25 mrad"', "of the road wheels")
    period: float = key('"2 s"', TIME, "length of one change", least=0.1)
    pause: float = key('"1 s"', TIME, "straight ahead between the two", default=0.0, least=0)
    every: float = key('"10 s"', TIME, "from one double change to the next", least=0.2)
    begin: float = _begin()

    def steer(self, t: Array, seed: int) -> Array:
        """Return the commanded road-wheel angle (n,) [rad]."""
        late = t - self.begin
        within = np.where(late >= 0, np.mod(late, self.every), -1)
        back = within - self.period - self.pause
        out, home = (within >= 0) & (within < self.period), (back >= 0) & (back < self.period)
        turn = 2 * math.pi / self.period
        return self.amplitude * (out * np.sin(turn * within) - home * np.sin(turn * back))


@dataclass(frozen=True, kw_only=True)
class Turns:
    """J-turns, left and right in turn: the steer rises, is held, goes back, rests."""

    amplitude: float = _angle('"30 mrad"', "of the road wheels")
    rise: float = key('"0.3 s"', TIME, "time to turn in, and to turn back", least=1e-3)
    hold: float = key('"4 s"', TIME, "time in the turn", least=0)
    rest: float = key('"3 s"', TIME, "time straight ahead afterwards", least=0)
    begin: float = _begin()

    def steer(self, t: Array, seed: int) -> Array:
        """Return the commanded road-wheel angle (n,) [rad]."""
        edges = np.cumsum([0, self.rise, self.hold, self.rise, self.rest])
        late = np.maximum(t - self.begin, 0)
        turn, within = np.divmod(late, edges[-1])
        shape = np.interp(within, edges, [0, 1, 1, 0, 0])
        return self.amplitude * np.where(turn % 2, -1, 1) * shape


@dataclass(frozen=True, kw_only=True)
class Highway:
    """Band-limited noise, as a driver corrects on a long road."""

    rms: float = _angle('"3 mrad"', "root mean square of the road wheels")
    slowest: float = key('"0.15 Hz"', FREQUENCY, "lower edge of the band", default=0.15, least=1e-3)
    fastest: float = key('"1 Hz"', FREQUENCY, "upper edge of the band", default=1.0, least=1e-2)

    def steer(self, t: Array, seed: int) -> Array:
        """Return the commanded road-wheel angle (n,) [rad]; its rms over the drive is `rms`."""
        from scipy.signal import butter, sosfilt

        rate = 1 / (t[1] - t[0])
        sos = butter(2, [self.slowest, self.fastest], "bandpass", fs=rate, output="sos")
        settle = int(3 / self.slowest * rate)  # three periods of the slowest part
        noise = generator(seed, "highway").standard_normal(t.size + settle)
        steer = sosfilt(sos, noise)[settle:]
        return steer * (self.rms / np.sqrt(np.mean(np.square(steer))))


@dataclass(frozen=True, kw_only=True)
class Square:
    """To one side and to the other, at once."""

    amplitude: float = _angle('"10 mrad"', "of the road wheels")
    period: float = key('"4 s"', TIME, "of left and right together", least=1e-2)
    begin: float = _begin()

    def steer(self, t: Array, seed: int) -> Array:
        """Return the commanded road-wheel angle (n,) [rad]."""
        late = t - self.begin
        left = np.mod(late, self.period) < self.period / 2
        return np.where(late < 0, 0.0, self.amplitude * np.where(left, 1.0, -1.0))


@dataclass(frozen=True, kw_only=True)
class FromLog:
    """The steer of a log; its speed too where ``speed.kind = "log"``.

    Parameters
    ----------
    times, angles : (n,)   filled in when the file has been read: [s], [rad]
    """

    file: str = key('"drive.csv"', "text", "the log, beside the scenario file or from here")
    times: Array | None = None
    angles: Array | None = None

    def steer(self, t: Array, seed: int) -> Array:
        """Return the logged road-wheel angle (n,) [rad], straight from row to row."""
        return np.interp(t, self.times, self.angles)


MANOEUVRES = {
    "straight": Straight, "slalom": Slalom, "sweep": Sweep, "double_lane_change": DoubleLaneChange,
    "turns": Turns, "highway": Highway, "square": Square, "log": FromLog,
}  # fmt: skip
