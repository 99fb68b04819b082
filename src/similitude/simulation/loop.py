"""The loop: driver, actuator, road and plant, one instant after the other.

Invariant: everything random was drawn before the loop, from numbers that belong to a seed and a
purpose alone; what a car does depends neither on the other cars of the call nor on the machine.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.errors import ScenarioError
from similitude.simulation.actuator import Chain, wheel_angle
from similitude.simulation.arithmetic import FLOATS, Arithmetic, arithmetic_for
from similitude.simulation.car import Car, generator
from similitude.simulation.foreign import SLOWEST, ForeignPlant
from similitude.simulation.lqr import Follower, Lqr
from similitude.simulation.plant import Output, Plant, Push
from similitude.simulation.road import Felt, feel, stiffness_under_axle, wander
from similitude.simulation.scenario import Scenario
from similitude.simulation.sections import Commonroad, Linear, TwoTrackKeys
from similitude.simulation.sensors import errors_of, reading
from similitude.simulation.single_track import SingleTrack
from similitude.simulation.two_track import Body, TwoTrack

Array = NDArray[np.float64]
# (time [s], steer [rad], yaw rate [rad/s], speed [m/s]) -> estimate of pi3 [-]
Estimate = Callable[[float, Any, Any, Any], Any]
READ = 'docs/simulate.md, "Scenario files"'
# A step of the method moves a mode of rate λ by exp(λ h) up to (λ h)^5/120: 0.06 % at this.
_MOST_PER_STEP = 0.6
_FASTEST_TURN = 1e3  # rad/s
_LOOK_EVERY = 200  # ticks


@dataclass(frozen=True)
class Motion:
    """What happened, at every instant: (n,) for one car or (n, cars).

    Parameters
    ----------
    t : (n,)                                    [s]
    seen : Output of arrays                     the car's motion, `delta` at the wheels
    command, rack : arrays                      commanded angle, angle of the rack [rad]
    wanted : (n,) or None                       offset that a driver with a path wanted [m]
    felt : Felt                                 the road
    """

    t: Array
    seen: Output
    command: Array
    rack: Array
    wanted: Array | None
    felt: Felt


def drive(scenario: Scenario, car: Car, seeds: Sequence[int], estimate: Estimate | None = None) -> Motion:
    """Drive the cars of a scenario, all at once.

    Parameters
    ----------
    scenario : Scenario
    car : Car                floats for one seed, (seeds,) arrays for more
    seeds : sequence of int  one a car
    estimate : function      of time, measured steer, yaw rate and speed: what a driver with
                             ``schedule = "estimate"`` believes π3 to be

    Returns
    -------
    Motion

    Raises
    ------
    ScenarioError   the step is too long for the slowest speed, or the motion left all bounds
    UsageError      the plant's package is not installed
    """
    timing = scenario.timing
    t = np.arange(timing.ticks) * timing.step
    U = scenario.speed.at(t)
    _check_step(scenario, car, U)
    felt = feel(scenario.road, t, front=car.a, seeds=seeds)
    pushes = _Pushes(felt, U, timing.step)
    on = FLOATS if len(seeds) == 1 else arithmetic_for(np.zeros(1))
    plant = make_plant(scenario, car, on)
    is_closed = isinstance(scenario.driver, Lqr)
    way = (
        _Following(scenario, car, t, seeds, pushes, estimate)
        if is_closed
        else _Open(np.stack([scenario.driver.steer(t, seed) for seed in seeds], axis=1))
    )
    motion = _run(scenario, plant, way, pushes, t, seeds, on)
    wanted = scenario.driver.path.at(t) if is_closed else None
    return Motion(t, *motion, wanted, felt)


def make_plant(scenario: Scenario, car: Car, on: Arithmetic) -> Plant:
    """Return the plant of a scenario for the cars."""
    kind = scenario.plant
    if isinstance(kind, Commonroad):
        return ForeignPlant(kind.model, kind.vehicle)
    if isinstance(kind, TwoTrackKeys):
        body = Body(kind.height, kind.track, kind.front_roll_share, kind.roll_time, kind.load_sensitivity)
        return TwoTrack(car, tyre=kind.tyre, body=body, on=on)
    if isinstance(kind, Linear):
        return SingleTrack(car, tyre="linear", height=0.0, on=on)
    return SingleTrack(car, tyre=kind.tyre, height=kind.height, on=on)


class _Pushes:
    """The road and the speed, instant by instant, in floats or arrays of cars."""

    def __init__(self, felt: Felt, U: Array, step: float) -> None:
        # tolist: an entry of an array is a NumPy scalar, ten times slower than a float
        self.U = U.tolist()
        self.ax = np.append(np.diff(U) / step, 0.0).tolist()
        self.force, self.moment = (x.tolist() if x.ndim == 1 else x for x in (felt.force, felt.moment))
        self.pull, self.stiffness, self.friction = (
            x.tolist() for x in (felt.pull, felt.stiffness, felt.friction)
        )
        self.patches = felt.patches

    def at(self, k: int, delta: Any) -> Push:
        """Return what acts at tick k with the wheels at delta [rad]."""
        return Push(
            delta, self.U[k], self.force[k], self.moment[k], self.pull[k], self.ax[k],
            self.stiffness[k], self.friction[k], self.patches[k],
        )  # fmt: skip


class _Open:
    """A driver whose commands were known before: (n, cars) [rad]."""

    def __init__(self, commands: Array) -> None:
        self._commands = commands[:, 0].tolist() if commands.shape[1] == 1 else commands
        self.first = self._commands[0]
        self._last = len(commands) - 1

    def command(self, k: int, *_: Any) -> tuple[Any, Any]:
        """Return the command at tick k, and the one at its end."""
        return self._commands[k], self._commands[min(k + 1, self._last)]


class _Following:
    """A driver with a path, who feels the car, perhaps through the logger's gyro."""

    def __init__(self, scenario, car, t, seeds, pushes, estimate) -> None:
        self._driver = scenario.driver
        self._follower = Follower(scenario.driver, scenario.vehicle.nominal(), t)
        self._t, self._pushes, self._front = t.tolist(), pushes, car.a
        self._half_track = 0.5 * getattr(scenario.plant, "track", 0.0)
        self._every = scenario.timing.rows_every
        self._sensor = scenario.sensors.r
        errors = yaw_rate_errors(scenario, t[:: self._every], seeds)
        self._errors = errors[0].tolist() if len(seeds) == 1 else errors.T
        self._felt_r: Any = 0.0
        self._estimate = estimate
        self._pi3 = scenario.vehicle.nominal().K  # times 1/U²
        self.first = 0.0 if len(seeds) == 1 else np.zeros(len(seeds))
        if self._driver.schedule == "estimate" and estimate is None:
            raise ScenarioError(
                "driver.schedule = 'estimate' needs an estimate, and none was given",
                usually="the loop was called by itself; `run_scenario` runs the population filter beside it.",
                paste="run_scenario(scenario, [0])",
                read='docs/simulate.md, "Drivers"',
            )

    def command(self, k: int, state: Output, rack: Any, on: Arithmetic) -> tuple[Any, Any]:
        """Return the command at tick k; it is held until the next."""
        r = state.r
        if k % self._every == 0:
            self._felt_r = reading(self._sensor, r, self._errors[k // self._every])
        if self._driver.feedback == "sensors":
            r = self._felt_r
        y_dot = state.U * on.sin(state.psi) + state.v * on.cos(state.psi)
        believed = None
        if self._driver.schedule == "truth":
            push = self._pushes.at(k, 0.0)
            believed = stiffness_under_axle(
                push, state, ahead=self._front, half_track=self._half_track, on=on
            )
        elif self._driver.schedule == "estimate":
            pi3 = self._estimate(self._t[k], rack, self._felt_r, state.U)
            believed = pi3 * state.U * state.U / self._pi3
        steer = self._follower.command(k, state.y, y_dot, state.psi, r, believed)
        return steer, steer


def yaw_rate_errors(scenario: Scenario, t: Array, seeds: Sequence[int]) -> Array:
    """Return what the gyro adds at the rows of the log, (seeds, rows) [rad/s]."""
    return np.stack([errors_of(scenario.sensors.r, t, generator(seed, "sensor r")) for seed in seeds])


def _run(scenario, plant, way, pushes, t, seeds, on) -> tuple[Output, Array, Array]:
    """Run the loop; the motion, the commands and the rack's angles."""
    actuator, step, n = scenario.actuator, scenario.timing.step, t.size
    z = _wander(scenario, t, seeds)
    chain = Chain(actuator, step=step, first=way.first, on=on)
    rack = way.first
    delta = wheel_angle(actuator, rack, z[0])
    push = pushes.at(0, delta)
    state = plant.start(push, 0.0)
    looked = plant.look(state, push)
    motion, commands, racks = [], [], []
    for k in range(n):
        if k % _LOOK_EVERY == 0 or k == n - 1:
            _check_bounds(scenario, looked.r, t[k], seeds, on)
        command, coming = way.command(k, looked, rack, on)
        commands.append(command)
        racks.append(rack)
        rack = chain.tick(coming)
        later = min(k + 1, n - 1)
        delta = wheel_angle(actuator, rack, z[later])
        after = pushes.at(later, delta)
        state, seen = plant.advance(state, push, after, step)
        motion.append(seen)
        push = after
        looked = plant.look(state, push)
    columns = [np.asarray([getattr(one, name) for one in motion], dtype=float) for name in Output._fields]
    shape = (n,) if len(seeds) == 1 else (n, len(seeds))
    columns = [np.broadcast_to(x if x.ndim == len(shape) else x[:, None], shape) for x in columns]
    return Output(*columns), np.asarray(commands, dtype=float), np.asarray(racks, dtype=float)


def _wander(scenario: Scenario, t: Array, seeds: Sequence[int]) -> Any:
    actuator = scenario.actuator
    if not (actuator.wander or actuator.wander_share):
        return [0.0] * t.size
    z = [wander(t, actuator.wander_time, generator(seed, "actuator wander")) for seed in seeds]
    return z[0].tolist() if len(seeds) == 1 else np.stack(z, axis=1)


def _check_step(scenario: Scenario, car: Car, U: Array) -> None:
    """Raise ScenarioError where the fastest motion is too fast for the step."""
    if isinstance(scenario.plant, Commonroad):  # has a bound of its own
        slowest, rate = float(np.min(U)) - SLOWEST, 0.0
    else:
        slowest = float(np.min(U))
        stiffest = max([1.0, *(patch.stiffness for patch in scenario.road.surface)])
        rate = car.fastest_rate(slowest) * stiffest if slowest > 0 else np.inf
    timing = scenario.timing
    if slowest > 0 and timing.step * rate <= _MOST_PER_STEP * (1 + 1e-9):
        return
    too_slow = not np.isfinite(rate) or rate == 0.0
    shorter = 1 / timing.log_rate / np.ceil(max(rate, 1.0) / (timing.log_rate * _MOST_PER_STEP))
    raise ScenarioError(
        f"{scenario.name}: at its slowest, {float(np.min(U)):.4g} m/s, the car's lateral motion is too fast "
        f"for steps of {1e3 * timing.step:.4g} ms" + ("" if too_slow else f" (rate {rate:.4g} 1/s)"),
        usually="the speed goes lower than was meant; the slower a car, the faster its lateral motion dies, "
        "and one that stands has none.",
        paste='at_least = "3 m/s"' if too_slow else f'step = "{1e3 * shorter:.10g} ms"',
        read=READ,
    )


def _check_bounds(scenario: Scenario, r: Any, t: float, seeds: Sequence[int], on: Arithmetic) -> None:
    """Raise ScenarioError where some car turns faster than any car can, or is no number any more."""
    wild = on.where(abs(r) <= _FASTEST_TURN, 0.0, 1.0)
    if on.any(wild):
        raise ScenarioError(
            f"{scenario.name}: with seed {seeds[int(np.argmax(wild))]} the car's motion left all bounds "
            f"before {t:.4g} s",
            usually="an oversteering car above its critical speed, or a loop that is unstable on this road.",
            paste='duration = "10 s"',
            read=READ,
        )
