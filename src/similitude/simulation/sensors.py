"""From the truth to what a logger writes: delay, scale, bias, walk, noise, spikes, steps, gaps.

written = round((scale · truth(t − delay) + bias + walk + noise + spikes)/step) · step,
at the sensor's own rate, and nothing where a sample was lost.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.dimension import ACCELERATION, FREQUENCY, LENGTH, SPEED, TIME
from similitude.simulation.keys import ANGLE, NUMBER, choice, key, table

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Sensor:
    """One channel of the logger; every fault is off where it is not stated.

    Parameters are those of the table; amounts are in SI of the channel's quantity.
    """

    scale: float = key("1.02", NUMBER, "what it reads over what is", default=1.0)
    bias: float = 0.0
    walk: float = 0.0
    noise: float = 0.0
    spike: float = 0.0
    quantum: float = 0.0
    spikes_every: float = key('"20 s"', TIME, "mean time between spikes", default=20.0, least=1e-2)
    rate: float = key('"20 Hz"', FREQUENCY, "its own rate, that of the log when left out", default=0.0,
                      least=1e-3)  # fmt: skip
    between: str = choice("held", "empty", words="cells between its own samples", default="held")
    delay: float = key('"20 ms"', TIME, "how old its samples are", default=0.0, least=0, most=5)
    lost: float = key("0.02", NUMBER, "share of samples that are missing", default=0.0, least=0, most=0.9)
    lost_for: float = key('"0.2 s"', TIME, "mean length of a gap; one sample when left out", default=0.0,
                          least=1e-3)  # fmt: skip


def _amounts(kind: type, of: Any, unit: str) -> type:
    """Return the class with the keys whose values have the dimension of its quantity."""

    def amount(value: str, words: str, least: float = 0.0) -> Any:
        return key(f'"{value} {unit}"', of, words, default=0.0, least=least)

    kind.bias = amount("0.2", "what it reads too much", -math.inf)
    kind.walk = amount("0.01", "standard deviation of the bias after 1 s; it grows as √t")
    kind.noise = amount("0.1", "standard deviation of white noise")
    kind.spike = amount("5", "standard deviation of a spike")
    kind.quantum = amount("0.05", "step to which it rounds")
    kind.__annotations__ = dict.fromkeys(("bias", "walk", "noise", "spike", "quantum"), "float")
    return dataclass(frozen=True)(kind)


class SteerSensor(Sensor):
    """The steer, in radians at the road wheels or at the steering wheel, whichever is logged."""


class YawRateSensor(Sensor):
    """The yaw rate, in rad/s."""


class SpeedSensor(Sensor):
    """The speed, in m/s."""


class SideSensor(Sensor):
    """The lateral acceleration, in m/s^2."""


_amounts(SteerSensor, ANGLE, "mrad")
_amounts(YawRateSensor, FREQUENCY, "deg/s")
_amounts(SpeedSensor, SPEED, "m/s")
_amounts(SideSensor, ACCELERATION, "m/s^2")


@dataclass(frozen=True)
class Sensors:
    """What the logger writes, and from which sensors; all of them perfect where not stated.

    Parameters
    ----------
    steer_as : which steer it is: that of the road wheels' rack, of the steering wheel, the command
    log_ay, ay_behind : whether there is an accelerometer, and where [m]; NaN is the centre of gravity
    steer, r, U, ay : Sensor   of its channel
    """

    steer_as: str = choice("road_wheel", "steering_wheel", "command", words="steer that is logged",
                           default="road_wheel")  # fmt: skip
    log_ay: str = choice("yes", "no", words="whether there is an accelerometer", default="yes")
    ay_behind: float = key('"1.3 m"', LENGTH, "place of the accelerometer behind the front axle; the centre "
                           "of gravity when left out", default=math.nan, least=-3, most=15)  # fmt: skip
    steer: Sensor = table(SteerSensor, default=SteerSensor())
    r: Sensor = table(YawRateSensor, default=YawRateSensor())
    U: Sensor = table(SpeedSensor, default=SpeedSensor())
    ay: Sensor = table(SideSensor, default=SideSensor())


def errors_of(sensor: Sensor, t: Array, rng: np.random.Generator) -> Array:
    """Return bias, walk, noise and spikes of a sensor at the rows of a log.

    Parameters
    ----------
    sensor : Sensor
    t : (n,)          even time of the rows [s]
    rng : Generator

    Returns
    -------
    (n,) in the unit of the channel
    """
    n, dt = t.size, (t[1] - t[0] if t.size > 1 else 0.0)
    # Everything is drawn whether it is wanted or not, so that one fault does not change another.
    noise, walk, spike = rng.standard_normal((3, n))
    chance = rng.random(n)
    added = sensor.bias + sensor.noise * noise
    added += sensor.walk * np.sqrt(dt) * (np.cumsum(walk) - walk[0])
    return added + np.where(chance < dt / sensor.spikes_every, sensor.spike * spike, 0.0)


def reading(sensor: Sensor, truth: Any, error: Any) -> Any:
    """Return what a sensor reads of a truth, its error given; floats or arrays."""
    value = sensor.scale * truth + error
    return np.round(value / sensor.quantum) * sensor.quantum if sensor.quantum else value


def written(sensor: Sensor, t: Array, truth: Array, error: Array, rng: np.random.Generator) -> Array:
    """Return the column of a channel as it is logged: NaN where a cell is empty.

    Parameters
    ----------
    sensor : Sensor
    t : (n,)              even time of the rows [s]
    truth : (n,)          of the channel, as old as the sensor's delay
    error : (n,)          from `errors_of`
    rng : Generator       for what is lost

    Returns
    -------
    (n,)
    """
    column = reading(sensor, truth, error)
    lost = _lost(sensor, t, rng)
    if not sensor.rate:
        return np.where(lost, np.nan, column)
    turn = np.floor((t - t[0]) * sensor.rate * (1 + 1e-12) + 1e-9)
    fresh = np.concatenate([[True], np.diff(turn) > 0])
    if sensor.between == "empty":
        return np.where(fresh & ~lost, column, np.nan)
    last = np.maximum.accumulate(np.where(fresh, np.arange(t.size), 0))
    return np.where(lost[last], np.nan, column[last])


def _lost(sensor: Sensor, t: Array, rng: np.random.Generator) -> NDArray[np.bool_]:
    """Rows that are missing: the right share of them, in gaps of the right mean length."""
    chance = rng.random(t.size)
    if not sensor.lost:
        return np.zeros(t.size, dtype=bool)
    dt = t[1] - t[0] if t.size > 1 else 1.0
    rows = max(sensor.lost_for / dt, 1 / (1 - sensor.lost))  # mean length of a gap
    found_again = 1 / rows
    lost_now = found_again * sensor.lost / (1 - sensor.lost)
    gone = np.zeros(t.size, dtype=bool)
    is_gone = bool(chance[0] < sensor.lost)
    for k in range(t.size):
        if k:
            is_gone = chance[k] >= found_again if is_gone else chance[k] < lost_now
        gone[k] = is_gone
    return gone
