"""The car that is driven: its true values, and how they are drawn from what is stated of them.

L = a + b wheelbase [m];  m mass [kg];  Iz yaw inertia [kg m^2];  Caf, Car cornering stiffness
of the axles [N/rad];  K = Caf L/m [m^2/s^2];  pi1 = a/L;  eta = Car b/(Caf a);  rho = Iz/(m a b)
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from similitude.units import Uncertain

GRAVITY = 9.80665  # m/s^2


@dataclass(frozen=True)
class Car:
    """True values of one car (floats) or many ((cars,) arrays).

    Parameters
    ----------
    m, Iz : mass [kg], yaw inertia [kg m^2]
    a, b : centre of gravity to front and rear axle [m]
    Caf, Car : cornering stiffness of the axles [N/rad]
    """

    m: Any
    Iz: Any
    a: Any
    b: Any
    Caf: Any
    Car: Any

    @property
    def L(self) -> Any:
        """Wheelbase [m]."""
        return self.a + self.b

    @property
    def K(self) -> Any:
        """Caf L/m [m^2/s^2]."""
        return self.Caf * self.L / self.m

    @property
    def groups(self) -> dict[str, Any]:
        """The dimensionless groups pi1, eta and rho [-]."""
        return {
            "pi1": self.a / self.L,
            "eta": self.Car * self.b / (self.Caf * self.a),
            "rho": self.Iz / (self.m * self.a * self.b),
        }

    @classmethod
    def of_groups(cls, *, L: Any, K: Any, pi1: Any, eta: Any, rho: Any, m: Any) -> Car:
        """Return the car with these groups; floats or (cars,) arrays.

        Parameters
        ----------
        L, K, m : wheelbase [m], Caf L/m [m^2/s^2], mass [kg]
        pi1, eta, rho : a/L, Car b/(Caf a), Iz/(m a b) [-]
        """
        a, Caf = pi1 * L, K * m / L
        b = L - a
        return cls(m=m, Iz=rho * m * a * b, a=a, b=b, Caf=Caf, Car=eta * Caf * a / b)

    def fastest_rate(self, U: Any) -> float:
        """Return a bound of the fastest rate of lateral motion at speed U, over all cars [1/s]."""
        lateral = (self.Caf + self.Car) / self.m
        yaw = (self.a**2 * self.Caf + self.b**2 * self.Car) / self.Iz
        return float(np.max((lateral + yaw) / U))


def generator(seed: int, purpose: str) -> np.random.Generator:
    """Return the random numbers of one purpose of one seed.

    Each purpose has numbers of its own, so that another sensor does not change the gusts.

    Parameters
    ----------
    seed : int     at least 0
    purpose : str  such as ``"sensor r"``
    """
    return np.random.default_rng([seed, zlib.crc32(purpose.encode())])


def draw_car(stated: Mapping[str, Uncertain], seeds: Sequence[int]) -> Car:
    """Draw a car for each seed: a value without deviation is itself, another log-normal about it.

    Parameters
    ----------
    stated : mapping of str to Uncertain   m, Iz, Caf, Car and two of L, a, b, in SI
    seeds : sequence of int                one a car

    Returns
    -------
    Car   floats for one seed, (seeds,) arrays for more
    """
    values = {}
    for name, held in stated.items():
        spread = 0.0 if held.sd is None else held.sd / held.value
        z = [generator(seed, f"car {name}").standard_normal() for seed in seeds]
        drawn = held.value * np.exp(spread * np.array(z))
        values[name] = float(drawn[0]) if len(seeds) == 1 else drawn
    if "a" not in values:
        values["a"] = values["L"] - values["b"]
    if "b" not in values:
        values["b"] = values["L"] - values["a"]
    return Car(**{name: values[name] for name in ("m", "Iz", "a", "b", "Caf", "Car")})
