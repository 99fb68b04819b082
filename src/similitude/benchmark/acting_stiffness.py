"""The stiffness with which a foreign car's front axle acts, from its motion.

    F = (m ay b + Iz r')/L      force of the front axle       a = delta - atan((v + a r)/U)    its slip angle
    K = (L/m) Σ F a/Σ a²        over all rows with the same road

A multi-body car's axle is no straight line: the tyres of commonroad-vehicle-models shift their force with
the sign of their camber, so in ordinary driving the axle acts a quarter stiffer than the slope of its tyres,
and more so the less it slips. What a drive can show is the line nearest to what the axle did. On a straight
road the shift is larger than the force, and the line tells a hundredth of it: no drive shows a stiffness
there, and the slope that is stated stands.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from similitude.simulation.car import Car

Array = NDArray[np.float64]
ENDS = 2  # rows at both ends of a stretch, whose differences reach beyond it
LEAST = 10  # rows that make a stretch
EXPLAINED = 0.5  # of the force's mean square that a line must tell to be one


def acting_stiffness(truth: Mapping[str, Array], car: Car) -> Array:
    """Return K of the line nearest to the front axle's force over its slip angle.

    Parameters
    ----------
    truth : columns of a recording's truth, (n,) each
    car : its mass, inertia and axles

    Returns
    -------
    (n,) [m^2/s^2], one value for each stretch of road with the same stiffness and friction
    """
    t, U, r = (truth[name] for name in ("t [s]", "U [m/s]", "r [rad/s]"))
    v = U * np.tan(truth["beta [rad]"])
    force = (car.m * truth["ay [m/s^2]"] * car.b + car.Iz * np.gradient(r, t)) / car.L
    slip = truth["delta [rad]"] - np.arctan((v + car.a * r) / U)
    road = np.abs(np.diff(truth["stiffness [-]"])) + np.abs(np.diff(truth["friction [-]"]))
    edges = [0, *(np.flatnonzero(road > 0) + 1), t.size]
    K = np.empty(t.size)
    for first, last in pairwise(edges):
        rows = slice(first + ENDS, last - ENDS)
        line = _line(force[rows], slip[rows]) if last - first > LEAST else None
        stated = car.K * truth["stiffness [-]"][first]
        K[first:last] = stated if line is None else car.L / car.m * line
    return K


def _line(force: Array, slip: Array) -> float | None:
    """Slope of the line through the origin nearest to a force; None where it tells little of the force."""
    together, slipped, pushed = (float(a @ b) for a, b in ((force, slip), (slip, slip), (force, force)))
    return together / slipped if together**2 > EXPLAINED * slipped * pushed else None
