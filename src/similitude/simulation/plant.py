"""What every plant offers, and the fixed Runge-Kutta step that the plants written here share.

A plant moves a state from one instant to the next under a `Push`. Its state begins with position,
heading, lateral velocity and yaw rate; it may hold more.

    x, y  position of the centre of gravity on the road [m], y to the left
    psi   heading [rad], r yaw rate [rad/s], both to the left
    v     lateral velocity of the centre of gravity in the car's frame [m/s]
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Protocol


class Push(NamedTuple):
    """What acts on the car at one instant; each a float or (cars,).

    The first five change straight from one instant to the next, the others are held in between.
    """

    delta: Any  # road-wheel angle [rad]
    U: Any  # speed forward [m/s]
    force: Any  # lateral force at the centre of gravity [N]
    moment: Any  # yaw moment [N m]
    pull: Any  # lateral acceleration by the bank of the road [m/s^2]
    ax: Any  # acceleration forward [m/s^2]
    stiffness: Any  # factor on the cornering stiffness [-]
    friction: Any  # peak friction coefficient [-]
    patches: tuple = ()  # surfaces that lie at a place: see `road.Patch`


class Output(NamedTuple):
    """What can be seen of the car at one instant; each a float or (cars,)."""

    x: Any  # m
    y: Any  # m
    psi: Any  # rad
    v: Any  # m/s
    r: Any  # rad/s
    U: Any  # m/s
    delta: Any  # rad, at the road wheels
    ay: Any  # m/s^2: v' + U r


class Plant(Protocol):
    """A car that can be driven, one step at a time."""

    def start(self, push: Push, y: Any) -> Sequence[Any]:
        """Return the state that drives straight ahead at speed `push.U`, offset `y` [m]."""

    def look(self, state: Sequence[Any], push: Push) -> Output:
        """Return what is seen of a state before anything is integrated; `ay` is 0 there."""

    def advance(
        self, state: Sequence[Any], before: Push, after: Push, step: float
    ) -> tuple[Sequence[Any], Output]:
        """Return the state one step [s] later, and what was seen before the step."""


def between(before: Push, after: Push) -> Push:
    """Return the push in the middle of a step."""
    return Push(*[(x + y) * 0.5 for x, y in zip(before[:5], after[:5], strict=True)], *before[5:])


def at_the_end(before: Push, after: Push) -> Push:
    """Return the push just before the end of a step, where what is held has not changed yet."""
    return Push(*after[:5], *before[5:])


def runge_kutta(
    rates: Callable[[Sequence[Any], Push], list[Any]],
    state: Sequence[Any],
    before: Push,
    after: Push,
    step: float,
) -> tuple[list[Any], list[Any]]:
    """Advance a state by the classical method of fourth order.

    Parameters
    ----------
    rates : (state, push) -> derivative of each entry of the state [per s]
    state : sequence of float or (cars,)
    before, after : Push   at both ends of the step
    step : float           [s]

    Returns
    -------
    state after the step, and its rates before it
    """
    middle, half = between(before, after), 0.5 * step
    k1 = rates(state, before)
    k2 = rates([x + half * k for x, k in zip(state, k1, strict=True)], middle)
    k3 = rates([x + half * k for x, k in zip(state, k2, strict=True)], middle)
    k4 = rates([x + step * k for x, k in zip(state, k3, strict=True)], at_the_end(before, after))
    sixth = step / 6.0
    moved = [x + sixth * (p + 2.0 * (q + s) + u) for x, p, q, s, u in zip(state, k1, k2, k3, k4, strict=True)]
    return moved, k1
