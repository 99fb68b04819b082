"""From motion to the two tables of a drive: what the logger wrote, and the truth at the same rows.

log    t, delta or steering_wheel, r, U and, with an accelerometer, ay
truth  t and everything that was really so: K, pi3, sideslip, friction, position, forces
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.simulation.car import GRAVITY, Car, generator
from similitude.simulation.loop import Estimate, Motion, drive, yaw_rate_errors
from similitude.simulation.road import surface_under_axle
from similitude.simulation.running_filter import RunningFilter
from similitude.simulation.scenario import Scenario
from similitude.simulation.sections import Commonroad
from similitude.simulation.sensors import errors_of, written

Array = NDArray[np.float64]
SPUN = np.pi / 4  # rad of sideslip from which a car with a given speed forward means nothing


@dataclass(frozen=True)
class Recording:
    """One drive.

    Parameters
    ----------
    scenario : str              name
    seed : int
    log : dict of str to (n,)   columns as they are logged, under ``name [unit]``; NaN is an empty cell
    truth : dict of str to (n,) columns of the truth at the same rows, under ``name [unit]``
    vehicle_file : str          the vehicle file that belongs to the log
    warnings : tuple of str     what a reader of the truth must know
    """

    scenario: str
    seed: int
    log: dict[str, Array]
    truth: dict[str, Array]
    vehicle_file: str
    warnings: tuple[str, ...] = ()


def run_scenario(
    scenario: Scenario,
    seeds: Sequence[int],
    *,
    car: Car | None = None,
    estimate: Estimate | None = None,
) -> list[Recording]:
    """Drive a scenario once for each seed; many seeds together cost little more than one.

    Parameters
    ----------
    scenario : Scenario
    seeds : sequence of int   at least one, each at least 0; the same seed gives the same drive
    car : Car                 instead of the scenario's: floats for one seed, (seeds,) arrays for
                              more. The vehicle file still tells what the scenario states.
    estimate : function       (t [s], steer [rad], yaw rate [rad/s], speed [m/s]) -> π3 [-], called
                              at every step for a driver with ``schedule = "estimate"``; when left
                              out, the population filter runs beside each drive

    Returns
    -------
    list of Recording, in the order of the seeds

    Raises
    ------
    ScenarioError   the step is too long, the motion left all bounds, or the filter that is to run
                    beside the drive has a gyro without any noise
    UsageError      the plant's package is not installed
    """
    seeds = list(seeds)
    is_heard = getattr(scenario.driver, "schedule", "none") == "estimate" and estimate is None
    if len(seeds) > 1 and (is_heard or isinstance(scenario.plant, Commonroad)):  # they know floats only
        cars = [None if car is None else _car(car, i) for i in range(len(seeds))]
        return [
            run_scenario(scenario, [seed], car=one, estimate=estimate)[0]
            for seed, one in zip(seeds, cars, strict=True)
        ]
    if is_heard:
        estimate = RunningFilter(scenario)
    cars = scenario.vehicle.draw(seeds) if car is None else car
    motion = drive(scenario, cars, seeds, estimate)
    errors = yaw_rate_errors(scenario, motion.t[:: scenario.timing.rows_every], seeds)
    return [_record(scenario, cars, motion, i, seed, errors[i]) for i, seed in enumerate(seeds)]


def _record(scenario: Scenario, cars: Car, motion: Motion, i: int, seed: int, gyro: Array) -> Recording:
    def column(x: Any) -> Array:
        """This car's values at every tick, or at all of them where a value does not change."""
        x = np.asarray(x, dtype=float)
        x = x if x.ndim < 2 else x[:, i]
        return np.broadcast_to(x, motion.t.shape)

    car = _car(cars, i)
    fine = _fine_truth(scenario, motion, car, column)
    rows = slice(None, None, scenario.timing.rows_every)
    truth = {name: np.ascontiguousarray(values[rows]) for name, values in fine.items()}
    log = _log(scenario, motion, car, column, fine, seed, gyro)
    return Recording(
        scenario.name, seed, log, truth, scenario.vehicle.vehicle_file(), _warnings(scenario, truth)
    )


def _car(cars: Car, i: int) -> Car:
    """One of many, in floats."""
    return Car(**{name: _one(getattr(cars, name), i) for name in ("m", "Iz", "a", "b", "Caf", "Car")})


def _one(value: Any, i: int) -> float:
    return float(np.asarray(value).reshape(-1)[i if np.ndim(value) else 0])


def _fine_truth(scenario: Scenario, motion: Motion, car: Car, column: Any) -> dict[str, Array]:
    """Every column of the truth at every tick."""
    seen = motion.seen
    U, place = column(seen.U), (column(seen.x), column(seen.y), column(seen.psi))
    half_track = 0.5 * getattr(scenario.plant, "track", 0.0)
    stiffness, friction = surface_under_axle(
        scenario.road, motion.felt, motion.t, *place, ahead=car.a, half_track=half_track
    )
    truth = {
        "t [s]": motion.t,
        "K [m^2/s^2]": car.K * stiffness,
        "pi3 [-]": car.K * stiffness / U**2,
        "friction [-]": friction,
        "stiffness [-]": stiffness,
        "delta [rad]": column(seen.delta),
        "command [rad]": column(motion.command),
        "r [rad/s]": column(seen.r),
        "beta [rad]": np.arctan2(column(seen.v), U),
        "ay [m/s^2]": column(seen.ay),
        "U [m/s]": U,
        **dict(zip(("x [m]", "y [m]", "psi [rad]"), place, strict=True)),
        "force [N]": column(motion.felt.force),
        "bank [rad]": np.arcsin(column(motion.felt.pull) / GRAVITY),
    }
    if motion.wanted is not None:
        truth["wanted y [m]"] = motion.wanted
    groups: Mapping[str, float] = car.groups
    return truth | {f"{name} [-]": np.full(motion.t.shape, value) for name, value in groups.items()}


def _log(scenario, motion, car, column, fine, seed, gyro) -> dict[str, Array]:
    """The logger's columns."""
    sensors = scenario.sensors
    t = motion.t[:: scenario.timing.rows_every]
    steer = column(motion.command if sensors.steer_as == "command" else motion.rack)
    name = "delta [rad]"
    if sensors.steer_as == "steering_wheel":
        name, steer = "steering_wheel [rad]", steer * scenario.vehicle.steering_ratio
    # An accelerometer feels the forces: not the pull of the bank.
    side = fine["ay [m/s^2]"] - column(motion.felt.pull)
    if np.isfinite(sensors.ay_behind):
        side = side + (car.a - sensors.ay_behind) * np.gradient(fine["r [rad/s]"], motion.t)
    channels = {
        name: (sensors.steer, steer, "steer"),
        "r [rad/s]": (sensors.r, fine["r [rad/s]"], "r"),
        "U [m/s]": (sensors.U, fine["U [m/s]"], "U"),
    }
    if sensors.log_ay == "yes":
        channels["ay [m/s^2]"] = (sensors.ay, side, "ay")
    log = {"t [s]": t}
    for header, (sensor, values, what) in channels.items():
        error = gyro if what == "r" else errors_of(sensor, t, generator(seed, f"sensor {what}"))
        old = np.interp(t - sensor.delay, motion.t, values)
        log[header] = written(sensor, t, old, error, generator(seed, f"lost {what}"))
    return log


def _warnings(scenario: Scenario, truth: Mapping[str, Array]) -> tuple[str, ...]:
    found = []
    spun = np.flatnonzero(np.abs(truth["beta [rad]"]) > SPUN)
    if spun.size:
        found.append(
            f"the car spins from {truth['t [s]'][spun[0]]:.2f} s on (sideslip above 45 deg); its speed "
            "forward is given, so what follows is no motion of a real car"
        )
    return tuple(found)
