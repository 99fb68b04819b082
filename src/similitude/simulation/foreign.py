"""Cars that nobody here wrote: the models of `commonroad-vehicle-models` behind the same interface.

    mb   29 states: sprung and unsprung masses, roll, pitch, four wheels with the Magic Formula
    std  9 states: one wheel an axle with the Magic Formula, drifts
    st   7 states: one wheel an axle, linear tyres

They are driven by the rate of the road-wheel angle and by acceleration: the angle wanted at the end
of a step is reached evenly (as fast as the model's steering allows), and speed is held by feedback.
`mb` counts y to the right and z down, the others y to the left and z up; the lateral equations are
the same, so an angle, yaw rate or lateral velocity that is positive here is positive there.

Friction and stiffness become the parameters p_dy1, p_dx1 (peaks) and p_ky1 (slope) of the tyre.

References
----------
M. Althoff, G. Würsching, CommonRoad: Vehicle Models, 2020; PyPI commonroad-vehicle-models 3 (BSD).
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Sequence
from typing import Any

from similitude.errors import UsageError
from similitude.simulation.car import Car
from similitude.simulation.plant import Output, Push

MODELS = ("mb", "std", "st")
VEHICLES = {"ford_escort": 1, "bmw_320i": 2, "vw_vanagon": 3}
SLOWEST = 0.5  # m/s; below 0.1 m/s their equations change to a car without tyres
LARGEST_STEP = 2.5e-3  # s; the wheels of `mb` and `std` turn at up to 300 1/s
_GRAVITY = 9.81  # m/s^2, theirs
_SPEED_GAIN = 2.0  # 1/s, of the acceleration that holds the speed


class ForeignPlant:
    """One car of the package, in floats.

    Parameters
    ----------
    model : str     "mb", "std" or "st"
    vehicle : str   a key of `VEHICLES`

    Raises
    ------
    UsageError      the package is not installed
    """

    def __init__(self, model: str, vehicle: str) -> None:
        self.model = model
        self._p = parameters(vehicle)
        self._f = getattr(_module(f"vehicle_dynamics_{model}"), f"vehicle_dynamics_{model}")
        tire = self._p.tire
        self._peaks, self._slope = (tire.p_dy1, tire.p_dx1), tire.p_ky1

    def start(self, push: Push, y: float) -> list[float]:
        """Return the state straight ahead at speed `push.U`, offset y [m]."""
        at_rest = [0.0, y, push.delta, push.U, 0.0, 0.0, 0.0]
        if self.model == "st":
            return at_rest
        module = _module(f"init_{self.model}")
        return list(getattr(module, f"init_{self.model}")(at_rest, self._p))

    def look(self, state: Sequence[float], push: Push | None) -> Output:
        """Return what is seen of a state; `ay` is 0, it needs the forces."""
        x, y, delta, speed, psi, r = state[:6]
        v = state[10] if self.model == "mb" else speed * math.sin(state[6])
        return Output(x, y, psi, v, r, self._speed(state), delta, 0.0)

    def advance(
        self, state: Sequence[float], before: Push, after: Push, step: float
    ) -> tuple[list[float], Output]:
        """Return the state one step [s] later, and what was seen before it."""
        self._set_road(before)
        u = [(after.delta - state[2]) / step, before.ax + _SPEED_GAIN * (before.U - self._speed(state))]
        k1 = self._rates(state, u)
        k2 = self._rates(_moved(state, k1, 0.5 * step), u)
        k3 = self._rates(_moved(state, k2, 0.5 * step), u)
        k4 = self._rates(_moved(state, k3, step), u)
        sixth = step / 6.0
        moved = [
            x + sixth * (p + 2.0 * (q + s) + w) for x, p, q, s, w in zip(state, k1, k2, k3, k4, strict=True)
        ]
        return moved, self._seen(state, k1)

    def _rates(self, state: Sequence[float], u: list[float]) -> list[float]:
        # They write into the state they are given.
        return self._f(list(state), u, self._p)

    def _set_road(self, push: Push) -> None:
        tire = self._p.tire
        tire.p_dy1, tire.p_dx1 = (peak * push.friction for peak in self._peaks)
        tire.p_ky1 = self._slope * push.stiffness

    def _speed(self, state: Sequence[float]) -> float:
        """Speed forward [m/s]."""
        return state[3] if self.model == "mb" else state[3] * math.cos(state[6])

    def _seen(self, state: Sequence[float], rates: Sequence[float]) -> Output:
        seen = self.look(state, None)
        if self.model == "mb":
            return seen._replace(ay=rates[10] + seen.U * seen.r)
        # v = speed sin(beta): its rate, and U r
        return seen._replace(ay=rates[3] * math.sin(state[6]) + seen.U * (rates[6] + seen.r))


def _moved(state: Sequence[float], rates: Sequence[float], by: float) -> list[float]:
    return [x + by * k for x, k in zip(state, rates, strict=True)]


def parameters(vehicle: str) -> Any:
    """Return the package's parameters of a car, a fresh copy that may be changed.

    Parameters
    ----------
    vehicle : str   a key of `VEHICLES`

    Raises
    ------
    UsageError      the package is not installed
    """
    number = VEHICLES[vehicle]
    return getattr(_module(f"parameters_vehicle{number}"), f"parameters_vehicle{number}")()


def foreign_car(model: str, vehicle: str) -> Car:
    """Return what the model is at small slip, from its parameters.

    The slope of the Magic Formula at no slip is B C D = |p_ky1| F_z, whatever the peak. The load
    of an axle is that of the sprung mass by its lever arms, and of `mb` the axle's own mass.
    What roll does to the wheels of `mb` (camber, its suspension's compliance) is not in it.

    Parameters
    ----------
    model : str     "mb", "std" or "st"
    vehicle : str   a key of `VEHICLES`
    """
    p = parameters(vehicle)
    body = p.m_s if model == "mb" else p.m
    own_f, own_r = (p.m_uf, p.m_ur) if model == "mb" else (0.0, 0.0)
    front = (body * p.b / (p.a + p.b) + own_f) * _GRAVITY
    rear = (body * p.a / (p.a + p.b) + own_r) * _GRAVITY
    slope = abs(p.tire.p_ky1)
    return Car(m=p.m, Iz=p.I_z, a=p.a, b=p.b, Caf=slope * front, Car=slope * rear)


def _module(name: str) -> Any:
    try:
        return importlib.import_module(f"vehiclemodels.{name}")
    except ModuleNotFoundError:
        raise UsageError(
            "plant.kind = 'commonroad' needs the package commonroad-vehicle-models, which is not installed",
            usually="similitude was installed without its extra; the package is not needed otherwise.",
            paste="pip install 'similitude[plants]'",
            read='docs/simulate.md, "Plants"',
        ) from None
