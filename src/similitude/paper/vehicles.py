"""The tables of vehicles at hand, in place of the 700 of the paper, which are not.

    rho = Iz/(m a b) = pi5/(pi1 pi2)    K = Caf L/m [m^2/s^2]    k = Car/Caf    eta = k pi2/pi1

Invariant: a group that needs a length the table does not have is not made up: the 204 inertias come
with a·b and no wheelbase, so they give rho, and pi5 only together with an assumed pi1.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
TABLES = resources.files("similitude").joinpath("tables")
FULL_SIZE = 500.0  # kg; the two model cars of the table are lighter


@dataclass(frozen=True, eq=False)
class Inertias:
    """204 vehicles, 1971 to 1998: mass (n,) [kg], Iz (n,) [kg m^2], ab (n,) [m^2]."""

    mass: Array
    Iz: Array
    ab: Array

    @property
    def rho(self) -> Array:
        """Iz/(m a b), (n,) [-]."""
        return self.Iz / (self.mass * self.ab)

    def pi5(self, pi1: float) -> Array:
        """Iz/(m L²) (n,) [-] of cars that all have the given pi1."""
        return self.rho * pi1 * (1 - pi1)


@dataclass(frozen=True, eq=False)
class Axles:
    """Full-size cars with published values, one source each: (n,) arrays, NaN where not given."""

    names: tuple[str, ...]
    mass: Array
    a: Array
    b: Array
    Iz: Array
    Caf: Array
    Car: Array

    @property
    def L(self) -> Array:
        """Wheelbase (n,) [m]."""
        return self.a + self.b

    @property
    def pi1(self) -> Array:
        """a/L (n,) [-]."""
        return self.a / self.L

    @property
    def pi5(self) -> Array:
        """Iz/(m L²) (n,) [-]."""
        return self.Iz / (self.mass * self.L**2)

    @property
    def K(self) -> Array:
        """Caf L/m (n,) [m²/s²]."""
        return self.Caf * self.L / self.mass

    @property
    def with_stiffness(self) -> NDArray[np.bool_]:
        """Which cars have both axle stiffnesses, (n,)."""
        return np.isfinite(self.Caf) & np.isfinite(self.Car)


@lru_cache
def inertias() -> Inertias:
    """The table of the NHTSA Light Vehicle Inertial Parameter Database."""
    rows = _rows("lvipd_204.csv")
    return Inertias(*(_column(rows, name) for name in ("m [kg]", "Izz [kg m^2]", "ab [m^2]")))


@lru_cache
def axles() -> Axles:
    """The full-size cars of the literature."""
    rows = [row for row in _rows("vehicles_literature.csv") if float(row["m [kg]"]) > FULL_SIZE]
    names = ("m [kg]", "a [m]", "b [m]", "Iz [kg m^2]", "Caf [N/rad]", "Car [N/rad]")
    return Axles(tuple(row["vehicle"] for row in rows), *(_column(rows, name) for name in names))


def _rows(name: str) -> list[dict[str, str]]:
    text = TABLES.joinpath(name).read_text(encoding="utf-8")
    return list(csv.DictReader(text.splitlines()))


def _column(rows: list[dict[str, str]], name: str) -> Array:
    return np.array([float(row[name]) if row[name] else np.nan for row in rows])
