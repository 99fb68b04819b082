"""The car with four wheels: lateral load transfer, and a road that differs left and right.

    ΔF_z = m h q/track · share of the axle,   q' = (ay − q)/roll_time   (q: ay as the body has rolled)
    C_i  = C/2 · z (1 − s (z − 1)),   z = F_z/F_z at rest,   s load sensitivity of the stiffness

A wheel's slip angle is that of the velocity at its own place. Axles brake and drive by their loads, the two
wheels of one alike (one brake pressure, an open differential), each limited by its grip; where the limits
differ left and right, the car is pulled aside.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from similitude.simulation.arithmetic import Arithmetic
from similitude.simulation.car import GRAVITY, Car
from similitude.simulation.plant import Output, Push, runge_kutta
from similitude.simulation.road import surface_at
from similitude.simulation.single_track import MOST_BRAKING
from similitude.simulation.tyres import lateral_force

_LEAST_LOAD = 1e-3  # of the load at rest: a wheel that has lifted carries nothing [-]


@dataclass(frozen=True)
class Body:
    """What the two-track car has beyond the bicycle.

    Parameters
    ----------
    height : float            of the centre of gravity [m]
    track : float             distance of left and right wheels [m]
    front_roll_share : float  share of the lateral load transfer that the front axle takes [-]
    roll_time : float         time constant of the roll [s]
    load_sensitivity : float  relative loss of stiffness per relative load [-]
    """

    height: float
    track: float
    front_roll_share: float
    roll_time: float
    load_sensitivity: float


class TwoTrack:
    """A plant with six states x, y, psi, v, r and q, the lateral acceleration as rolled.

    Parameters
    ----------
    car : Car
    tyre : str        "linear", "cubic" or "brush"
    body : Body
    on : Arithmetic
    """

    def __init__(self, car: Car, *, tyre: str, body: Body, on: Arithmetic) -> None:
        self.car, self.tyre, self.body, self.on = car, tyre, body, on

    def start(self, push: Push, y: Any) -> list[Any]:
        """Return the state straight ahead at offset y [m]."""
        nothing = 0.0 * push.delta
        return [nothing, nothing + y, nothing, nothing, nothing, nothing]

    def rates(self, state: Sequence[Any], push: Push) -> list[Any]:
        """Return the derivative of each state, each a float or (cars,) per second."""
        car, on, body = self.car, self.on, self.body
        _, _, psi, v, r, q = state
        delta, U, force, moment, pull = push[:5]
        way = (on.sin(psi), on.cos(psi))
        shift, L = body.height * push.ax, car.L
        load_f = 0.5 * car.m * (GRAVITY * car.b - shift) / L
        load_r = 0.5 * car.m * (GRAVITY * car.a + shift) / L
        moved = car.m * body.height * q / body.track
        moved_f = moved * body.front_roll_share
        front, pull_f = self._axle(state, push, way, car.a, 0.5 * car.Caf, load_f, moved_f, delta)
        rear, pull_r = self._axle(state, push, way, -car.b, 0.5 * car.Car, load_r, moved - moved_f, 0.0)
        front = front * on.cos(delta)
        side = (front + rear + force) / car.m
        r_dot = (car.a * front - car.b * rear + moment + pull_f + pull_r) / car.Iz
        # what rolls the body is what the tyres carry, not the pull of the bank
        q_dot = (side - q) / body.roll_time
        sin, cos = way
        return [U * cos - v * sin, U * sin + v * cos, r, side + pull - U * r, r_dot, q_dot]

    def look(self, state: Sequence[Any], push: Push) -> Output:
        """Return what is seen of a state; `ay` is 0, it needs the forces."""
        return Output(*state[:5], push.U, push.delta, 0.0)

    def advance(
        self, state: Sequence[Any], before: Push, after: Push, step: float
    ) -> tuple[list[Any], Output]:
        """Return the state one step [s] later, and what was seen before it."""
        moved, rates = runge_kutta(self.rates, state, before, after, step)
        seen = Output(*state[:5], before.U, before.delta, rates[3] + before.U * state[4])
        return moved, seen

    def _axle(self, state, push, way, at, C, rest, moved, delta) -> tuple[Any, Any]:
        """Lateral force [N] of an axle `at` metres before the centre, and its braking moment [N m].

        C and rest are stiffness and load of one wheel; turning left, `moved` goes to the right one.
        """
        on, half, ax, patches = self.on, 0.5 * self.body.track, push.ax, push.patches
        x, y, _, v, r, _ = state
        sin, cos = way
        stiffness, friction = push.stiffness, push.friction
        sideways, least = v + at * r, _LEAST_LOAD * rest
        force, pulling = 0.0, 0.0
        for side, out in (("left", half), ("right", -half)):
            if patches:
                there = (x + at * cos - out * sin, y + at * sin + out * cos)
                stiffness, friction = surface_at(push, *there, side, on)
            load = on.maximum(rest - moved if out > 0 else rest + moved, least)
            z = load / rest
            slip = delta - on.atan(sideways / (push.U - out * r))
            C_i = C * stiffness * z * (1.0 - self.body.load_sensitivity * (z - 1.0))
            most = friction * load
            if ax != 0.0:
                used = on.minimum(rest * abs(ax) / (GRAVITY * most), MOST_BRAKING)
                pulling = pulling - out * on.sign(ax) * used * most
                most = most * on.sqrt(1.0 - used * used)
            force = force + lateral_force(self.tyre, C_i, slip, most, on)
        return force, pulling
