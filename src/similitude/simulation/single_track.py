"""The car with one wheel an axle: the linear bicycle, and the same with tyres that saturate.

    v' = (Ff cos δ + Fr + F)/m + pull − U r        F, M   outer force [N] and moment [N m]
    r' = (a Ff cos δ − b Fr + M)/Iz
    αf = δ − atan((v + a r)/U),  αr = −atan((v − b r)/U)

With linear tyres angles are small by definition: atan and cos are left out, and this is the model
of Brennan & Alleyne (2004), eqs 2 and 3. Braking with the ideal distribution uses the share
ax/(μ g) of every tyre's grip and leaves √(1 − share²) for the side.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from similitude.simulation.arithmetic import Arithmetic
from similitude.simulation.car import GRAVITY, Car
from similitude.simulation.plant import Output, Push, runge_kutta
from similitude.simulation.road import surface_at
from similitude.simulation.tyres import lateral_force

MOST_BRAKING = 0.95  # share of the grip that a driver can use for braking [-]


class SingleTrack:
    """A plant with five states x, y, psi, v, r.

    Parameters
    ----------
    car : Car
    tyre : str        "linear", "cubic" or "brush"
    height : float    of the centre of gravity [m], for load transfer under braking
    on : Arithmetic
    """

    def __init__(self, car: Car, *, tyre: str, height: float, on: Arithmetic) -> None:
        self.car, self.tyre, self.height, self.on = car, tyre, height, on

    def start(self, push: Push, y: Any) -> list[Any]:
        """Return the state straight ahead at offset y [m]."""
        nothing = 0.0 * push.delta
        return [nothing, nothing + y, nothing, nothing, nothing]

    def rates(self, state: Sequence[Any], push: Push) -> list[Any]:
        """Return the derivative of each state, each a float or (cars,) per second."""
        car, on = self.car, self.on
        _, _, psi, v, r = state
        U = push.U
        front, rear = self._axle_forces(state, push)
        if self.tyre != "linear":
            front = front * on.cos(push.delta)
        v_dot = (front + rear + push.force) / car.m + push.pull - U * r
        r_dot = (car.a * front - car.b * rear + push.moment) / car.Iz
        sin, cos = on.sin(psi), on.cos(psi)
        return [U * cos - v * sin, U * sin + v * cos, r, v_dot, r_dot]

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

    def _axle_forces(self, state: Sequence[Any], push: Push) -> tuple[Any, Any]:
        """Lateral force of the front and the rear axle in its wheels' frame [N]."""
        car, on, tyre = self.car, self.on, self.tyre
        x, y, psi, v, r = state
        stiff_f = stiff_r = push.stiffness
        grip_f = grip_r = push.friction
        if push.patches:
            sin, cos = on.sin(psi), on.cos(psi)
            stiff_f, grip_f = surface_at(push, x + car.a * cos, y + car.a * sin, "", on)
            stiff_r, grip_r = surface_at(push, x - car.b * cos, y - car.b * sin, "", on)
        at_front, at_rear = (v + car.a * r) / push.U, (v - car.b * r) / push.U
        if tyre == "linear":
            return car.Caf * stiff_f * (push.delta - at_front), car.Car * stiff_r * -at_rear
        share, L = self.height * push.ax, car.L
        most_f = axle_limit(car.m * (GRAVITY * car.b - share) / L, grip_f, push.ax, on)
        most_r = axle_limit(car.m * (GRAVITY * car.a + share) / L, grip_r, push.ax, on)
        return (
            lateral_force(tyre, car.Caf * stiff_f, push.delta - on.atan(at_front), most_f, on),
            lateral_force(tyre, car.Car * stiff_r, -on.atan(at_rear), most_r, on),
        )


def axle_limit(load: Any, friction: Any, ax: Any, on: Arithmetic) -> Any:
    """Return the largest lateral force [N] of a load [N] while the car accelerates by ax [m/s^2]."""
    if isinstance(ax, float) and ax == 0.0:  # most of the time
        return friction * load
    used = on.minimum(abs(ax) / (friction * GRAVITY), MOST_BRAKING)
    return friction * load * on.sqrt(1.0 - used * used)
