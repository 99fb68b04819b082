"""The road: grip and stiffness by time and place, bank, gusts and kerbs.

Invariant: friction and stiffness are two things. `friction` limits the force of a tyre and does not
touch its slope at small slip; `stiffness` is a factor on the slope. What changes both says both.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.dimension import FORCE, LENGTH, TIME
from similitude.simulation.arithmetic import Arithmetic
from similitude.simulation.car import GRAVITY, generator
from similitude.simulation.keys import ANGLE, NUMBER, choice, key, table, tables
from similitude.simulation.plant import Output, Push

_EVERYWHERE = math.inf


@dataclass(frozen=True, kw_only=True)
class Patch:
    """A surface that lies at a time, a place, or both; what is left out does not bound it.

    Friction replaces that of the road, stiffness multiplies that of the tyre; where patches lie
    over each other the later one wins.
    """

    friction: float = key("0.4", NUMBER, "peak friction coefficient", default=-1.0, least=0.01, most=3)
    stiffness: float = key("0.5", NUMBER, "factor on the tyre's stiffness", default=-1.0,
                           least=0.01, most=10)  # fmt: skip
    begin: float = key('"30 s"', TIME, "first moment", default=-_EVERYWHERE)
    end: float = key('"40 s"', TIME, "last moment", default=_EVERYWHERE)
    every: float = key('"20 s"', TIME, "period after which it comes again", default=0.0, least=1e-3)
    x_from: float = key('"100 m"', LENGTH, "where it begins along the road", default=-_EVERYWHERE)
    x_to: float = key('"150 m"', LENGTH, "where it ends along the road", default=_EVERYWHERE)
    y_from: float = key('"-1 m"', LENGTH, "its right edge", default=-_EVERYWHERE)
    y_to: float = key('"0 m"', LENGTH, "its left edge", default=_EVERYWHERE)
    side: str = choice("both", "left", "right", words="wheels it is under", default="both")

    @property
    def has_place(self) -> bool:
        """Whether it depends on where the wheels are."""
        bounds = (self.x_from, self.x_to, self.y_from, self.y_to)
        return self.side != "both" or any(map(math.isfinite, bounds))

    def lies_at(self, t: Any) -> Any:
        """Whether it is there at time t [s], a float or an array."""
        if self.every:
            t = np.mod(t, self.every)
        return (t >= self.begin) & (t < self.end)


@dataclass(frozen=True, kw_only=True)
class Knot:
    """The bank of the road at one time; straight from knot to knot."""

    at: float = key('"10 s"', TIME, "time")
    angle: float = key('"2 deg"', ANGLE, "bank, positive where the car is pulled to the left",
                       least=-0.8, most=0.8)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Gusts:
    """A random lateral force: Gaussian, first-order, stationary."""

    force: float = key('"300 N"', FORCE, "its standard deviation", least=0)
    correlation: float = key('"1 s"', TIME, "its correlation time", least=1e-3)
    ahead: float = key('"0.2 m"', LENGTH, "centre of pressure ahead of that of gravity", default=0.0)


@dataclass(frozen=True, kw_only=True)
class Kerbs:
    """Lateral pulses at the front axle at random times, half a sine each, to either side."""

    every: float = key('"20 s"', TIME, "mean time between two", least=0.1)
    force: float = key('"2 kN"', FORCE, "peak", least=0)
    duration: float = key('"60 ms"', TIME, "length of a pulse", least=1e-3, most=2)


@dataclass(frozen=True, kw_only=True)
class Road:
    """The road of a scenario."""

    friction: float = key("1.0", NUMBER, "peak friction coefficient", default=1.0, least=0.01, most=3)
    surface: tuple = tables(Patch, "other surfaces")
    bank: tuple = tables(Knot, "bank of the road over time")
    gusts: Gusts | None = table(Gusts, "wind")
    kerbs: Kerbs | None = table(Kerbs, "pulses at the front axle")


@dataclass(frozen=True)
class Felt:
    """What the road does at every instant, alike for all cars where (n,) and not (n, cars).

    Parameters
    ----------
    force, moment : (n,) or (n, cars)     lateral force [N], yaw moment [N m]
    pull : (n,)                           lateral acceleration by the bank [m/s^2]
    stiffness, friction : (n,)            factor, peak friction coefficient [-]
    patches : list of n tuples of Patch   surfaces with a place, those that lie there at the time
    """

    force: NDArray[np.float64]
    moment: NDArray[np.float64]
    pull: NDArray[np.float64]
    stiffness: NDArray[np.float64]
    friction: NDArray[np.float64]
    patches: list[tuple]


def feel(road: Road, t: NDArray[np.float64], *, front: Any, seeds: Sequence[int]) -> Felt:
    """Work the road out over time.

    Parameters
    ----------
    road : Road
    t : (n,)                  even time [s]
    front : float or (cars,)  centre of gravity to the front axle, where kerbs push [m]
    seeds : sequence of int   one a car

    Returns
    -------
    Felt
    """
    stiffness, friction = np.ones(t.size), np.full(t.size, road.friction)
    for patch in road.surface:
        if not patch.has_place:
            there = patch.lies_at(t)
            stiffness[there] = patch.stiffness if patch.stiffness > 0 else stiffness[there]
            friction[there] = patch.friction if patch.friction > 0 else friction[there]
    pull = np.zeros(t.size)
    if road.bank:
        pull = GRAVITY * np.sin(
            np.interp(t, [knot.at for knot in road.bank], [knot.angle for knot in road.bank])
        )
    force = moment = np.zeros(t.size)
    if road.gusts is not None:
        wind = np.stack([gust_force(road.gusts, t, seed) for seed in seeds], axis=1)
        force, moment = force[:, None] + wind, moment[:, None] + wind * road.gusts.ahead
    if road.kerbs is not None:
        kicks = np.stack([kerb_force(road.kerbs, t, seed) for seed in seeds], axis=1)
        force, moment = _column(force) + kicks, _column(moment) + kicks * front
    if force.ndim == 2 and len(seeds) == 1:
        force, moment = force[:, 0], moment[:, 0]
    return Felt(force, moment, pull, stiffness, friction, _patches(road, t))


def _column(x: NDArray) -> NDArray:
    return x[:, None] if x.ndim == 1 else x


def _patches(road: Road, t: NDArray) -> list[tuple]:
    placed = [patch for patch in road.surface if patch.has_place]
    there = np.array([np.broadcast_to(patch.lies_at(t), t.shape) for patch in placed]).reshape(-1, t.size)
    known: dict[bytes, tuple] = {}
    found = []
    for column in there.T:
        mark = column.tobytes()
        if mark not in known:
            known[mark] = tuple(p for p, lies in zip(placed, column, strict=True) if lies)
        found.append(known[mark])
    return found


def gust_force(gusts: Gusts, t: NDArray[np.float64], seed: int) -> NDArray[np.float64]:
    """Return a gust force over time (n,) [N]: exactly an Ornstein-Uhlenbeck process at the instants."""
    return gusts.force * wander(t, gusts.correlation, generator(seed, "gusts"))


def wander(t: NDArray[np.float64], correlation: float, rng: np.random.Generator) -> NDArray[np.float64]:
    """Return an Ornstein-Uhlenbeck process of variance 1 at even times (n,) [-].

    Parameters
    ----------
    t : (n,)             even time [s]
    correlation : float  correlation time [s]
    rng : Generator
    """
    from scipy.signal import lfilter

    white = rng.standard_normal(t.size)
    if t.size < 2:
        return white
    kept = math.exp(-(t[1] - t[0]) / correlation)
    driven = white * math.sqrt(1 - kept * kept)
    driven[0] = white[0]
    return lfilter([1.0], [1.0, -kept], driven)


def kerb_force(kerbs: Kerbs, t: NDArray[np.float64], seed: int) -> NDArray[np.float64]:
    """Return the lateral force of kerbs over time (n,) [N]; times of a Poisson process."""
    rng = generator(seed, "kerbs")
    force, at = np.zeros(t.size), float(t[0])
    while (at := at + rng.exponential(kerbs.every)) < t[-1]:
        aside = kerbs.force * rng.choice([-1.0, 1.0])
        hit = (t >= at) & (t < at + kerbs.duration)
        force[hit] += aside * np.sin(math.pi * (t[hit] - at) / kerbs.duration)
    return force


def surface_at(push: Push, x: Any, y: Any, side: str, on: Arithmetic) -> tuple[Any, Any]:
    """Return stiffness factor and friction [-] under a wheel.

    Parameters
    ----------
    push : Push                    with the patches that lie there at the time
    x, y : float or (cars,)        where the wheel is [m]
    side : str                     "left", "right", or empty for the middle of an axle
    on : Arithmetic
    """
    stiffness, friction = push.stiffness, push.friction
    for patch in push.patches:
        if patch.side not in ("both", side):
            continue
        inside = (x >= patch.x_from) & (x < patch.x_to) & (y >= patch.y_from) & (y < patch.y_to)
        if patch.stiffness > 0:
            stiffness = on.where(inside, patch.stiffness, stiffness)
        if patch.friction > 0:
            friction = on.where(inside, patch.friction, friction)
    return stiffness, friction


def stiffness_under_axle(push: Push, seen: Output, *, ahead: Any, half_track: float, on: Arithmetic) -> Any:
    """Return the stiffness factor [-] of an axle at one instant, the mean of its two wheels.

    Parameters
    ----------
    push : Push               with the patches that lie there at the time
    seen : Output             where the centre of gravity is and where the car points
    ahead : float or (cars,)  of the axle before the centre of gravity [m]
    half_track : float        of a wheel from the middle of the axle [m], 0 on a single track
    on : Arithmetic
    """
    if not push.patches:
        return push.stiffness
    forward, aside = on.cos(seen.psi), on.sin(seen.psi)
    x, y = seen.x + ahead * forward, seen.y + ahead * aside
    sides = (("left", half_track), ("right", -half_track))
    both = [surface_at(push, x - w * aside, y + w * forward, side, on)[0] for side, w in sides]
    return 0.5 * (both[0] + both[1])


def surface_under_axle(
    road: Road,
    felt: Felt,
    t: NDArray,
    x: NDArray,
    y: NDArray,
    psi: NDArray,
    *,
    ahead: float,
    half_track: float,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return stiffness factor and friction (n,) [-] of an axle, the mean of its two wheels.

    Parameters
    ----------
    road, felt : Road, Felt
    t, x, y, psi : (n,)   time [s], place of the centre of gravity [m], heading [rad]
    ahead : float         of the axle before the centre of gravity [m]
    half_track : float    of a wheel from the middle of the axle [m], 0 on a single track
    """
    sums = np.zeros((2, t.size))
    for side, left in (("left", 1.0), ("right", -1.0)):
        wheel_x = x + ahead * np.cos(psi) - left * half_track * np.sin(psi)
        wheel_y = y + ahead * np.sin(psi) + left * half_track * np.cos(psi)
        under = np.stack([felt.stiffness, felt.friction])
        for patch in road.surface:
            if not patch.has_place or patch.side not in ("both", side):
                continue
            inside = patch.lies_at(t) & (wheel_x >= patch.x_from) & (wheel_x < patch.x_to)
            inside &= (wheel_y >= patch.y_from) & (wheel_y < patch.y_to)
            under[0] = np.where(inside & (patch.stiffness > 0), patch.stiffness, under[0])
            under[1] = np.where(inside & (patch.friction > 0), patch.friction, under[1])
        sums += 0.5 * under
    return sums[0], sums[1]
