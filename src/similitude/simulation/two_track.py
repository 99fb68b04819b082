"""The car with four wheels: lateral load transfer, and a road that differs left and right.

    ΔF_z = m h q/track · share of the axle,   q' = (ay − q)/roll_time   (q: ay as the body has rolled)
    C_i  = C/2 · z (1 − s (z − 1)),   z = F_z/F_z at rest,   s load sensitivity of the stiffness

A wheel's slip angle is that of the velocity at its own place. Braking is shared by the loads and
limited by each wheel's grip; where the limits differ left and right, the car is pulled aside.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from similitude.simulation.arithmetic import Arithmetic
from similitude.simulation.car import GRAVITY, Car
from similitude.simulation.plant import Output, Push, runge_kutta
from similitude.simulation.road import surface_at
from similitude.simulation.single_track import MOST_BRAKING, axle_limit
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
        U = push.U
        moment = push.moment
        axles = []
        shift, L = body.height * push.ax, car.L
        for at, C, rest, delta, share in (
            (car.a, car.Caf, car.m * (GRAVITY * car.b - shift) / L, push.delta, body.front_roll_share),
            (-car.b, car.Car, car.m * (GRAVITY * car.a + shift) / L, 0.0, 1.0 - body.front_roll_share),
        ):
            transfer = car.m * body.height * q / body.track * share
            sideways, pulling = self._axle(state, push, at, 0.5 * C, 0.5 * rest, transfer, delta)
            axles.append(sideways * on.cos(delta))
            moment = moment + pulling
        v_dot = (axles[0] + axles[1] + push.force) / car.m + push.pull - U * r
        r_dot = (car.a * axles[0] - car.b * axles[1] + moment) / car.Iz
        sin, cos = on.sin(psi), on.cos(psi)
        # the road's bank rolls the body too: what rolls it is what the tyres must carry
        q_dot = (v_dot + U * r - push.pull - q) / body.roll_time
        return [U * cos - v * sin, U * sin + v * cos, r, v_dot, r_dot, q_dot]

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

    def _axle(self, state, push, at, C, rest, transfer, delta) -> tuple[Any, Any]:
        """Lateral force [N] of an axle `at` metres before the centre, and its braking moment [N m].

        C and rest are stiffness and load of one wheel; turning left, load moves to the right.
        """
        on, half = self.on, 0.5 * self.body.track
        x, y, psi, v, r, _ = state
        force, pulling = 0.0, 0.0
        for side, left in (("left", 1.0), ("right", -1.0)):
            stiffness, friction = push.stiffness, push.friction
            if push.patches:
                sin, cos = on.sin(psi), on.cos(psi)
                there = x + at * cos - left * half * sin, y + at * sin + left * half * cos
                stiffness, friction = surface_at(push, *there, side, on)
            load = on.maximum(rest - left * transfer, _LEAST_LOAD * rest)
            z = load / rest
            slip = delta - on.atan((v + at * r) / (push.U - left * half * r))
            C_i = C * stiffness * z * (1.0 - self.body.load_sensitivity * (z - 1.0))
            most = axle_limit(load, friction, push.ax, on)
            force = force + lateral_force(self.tyre, C_i, slip, most, on)
            if push.ax != 0.0:
                used = on.minimum(abs(push.ax) / (friction * GRAVITY), MOST_BRAKING)
                pulling = pulling - left * half * on.sign(push.ax) * used * friction * load
        return force, pulling
