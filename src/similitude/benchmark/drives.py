"""The drives of a cell: cars drawn, simulated once a seed, what their loggers wrote, and the truth.

Cars are drawn about the population's mean as in the reference experiment of docs/filter.md: L U(2.3, 3.2) m,
pi1 N(0.4431, 0.025), ln k N(ln 1.0977, 0.12), ln pi5 N(ln 0.251, 0.08), ln K N(ln 145.68, 0.2). A car that
oversteers is drawn again: a given speed beyond its critical one is no drive. The foreign cars are three, in
turn, and differ otherwise in their sensors' noise alone.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.benchmark.cells import Cell
from similitude.benchmark.kept_drives import kept
from similitude.simulation.car import Car, generator
from similitude.simulation.foreign import VEHICLES, foreign_car
from similitude.simulation.recording import Recording, run_scenario
from similitude.simulation.scenario import Scenario, read_scenario
from similitude.units import Uncertain, parse_unit
from similitude.vehicle_file import Vehicle

Array = NDArray[np.float64]
NOISE = np.deg2rad(0.15)  # rad/s, that of the scenario's gyro
K, LN_K_SD = 145.68, 0.2  # m^2/s^2
PI1, PI1_SD = 0.4431, 0.025
K_RATIO, LN_K_RATIO_SD = 1.0977, 0.12  # pi4/pi3
PI5, LN_PI5_SD = 0.251, 0.08
LEAST_ETA = 1.05
MASS = 1500.0  # kg; it cancels, but for the weight of a gust
AY_NOISE = 0.1  # m/s^2, that of its accelerometer
BEHIND, BEHIND_SD = 1.20, 0.05  # m: what the file says of the accelerometer's place
GROUPS = ("pi1", "eta", "rho")
BASE = "slalom"  # the shipped scenario whose every section is replaced


@dataclass(frozen=True, eq=False)
class Drive:
    """What an estimator is given: a log and a vehicle file, nothing else.

    Parameters
    ----------
    t : (n,)           time [s], 100 Hz
    delta, r, U : (n,) road-wheel angle [rad], yaw rate [rad/s], speed [m/s]; NaN where a sample is lost
    ay : (n,)          lateral acceleration felt at the accelerometer [m/s^2]
    vehicle : Vehicle  wheelbase, population, the gyro's noise per sample [rad/s], the accelerometer's place
    """

    t: Array
    delta: Array
    r: Array
    U: Array
    ay: Array
    vehicle: Vehicle

    @property
    def L(self) -> float:
        """Wheelbase [m]."""
        return self.vehicle.L.value

    @property
    def noise(self) -> float:
        """Sd of the gyro's noise [rad/s]."""
        return self.vehicle.yaw_rate_noise.value

    def until(self, t: float) -> Drive:
        """Return the part before a time [s]."""
        rows = self.t < t
        return Drive(*(x[rows] for x in (self.t, self.delta, self.r, self.U, self.ay)), self.vehicle)


@dataclass(frozen=True, eq=False)
class Truth:
    """What a drive was: K (n,) [m^2/s^2], steer at the wheels (n,) [rad], groups pi1, eta, rho [-]."""

    K: Array
    delta: Array
    groups: dict[str, float]


def drives(cell: Cell, seed: int) -> list[tuple[Drive, Truth]]:
    """Simulate a cell.

    Parameters
    ----------
    cell : Cell
    seed : int   the run's; drive i has the seed ``seed + i``

    Returns
    -------
    list of (Drive, Truth), one a seed
    """
    seeds = [seed + i for i in range(cell.seeds)]
    if cell.is_foreign:
        return [_foreign(cell, one) for one in seeds]
    cars = draw(seeds, cell.car)
    recordings = run_scenario(scenario(cell), seeds, car=cars)
    return [told(columns(one), L) for one, L in zip(recordings, np.atleast_1d(cars.L).tolist(), strict=True)]


def _foreign(cell: Cell, seed: int) -> tuple[Drive, Truth]:
    """One drive of a foreign plant, simulated once and kept; the cars take turns."""
    vehicle = list(VEHICLES)[seed % len(VEHICLES)]
    return foreign_drive(scenario(cell, vehicle), seed, {"scenario": cell.changes, "vehicle": vehicle})


def foreign_drive(scenario: Scenario, seed: int, description: Mapping[str, Any]) -> tuple[Drive, Truth]:
    """Return one drive of a foreign plant, whose true K is the slope of its tyres.

    Parameters
    ----------
    scenario : Scenario   with the plant's model and vehicle
    seed : int
    description : mapping   all that the scenario depends on, by which the drive is kept
    """
    car = foreign_car(scenario.plant.model, scenario.plant.vehicle)
    held = kept({**description, "seed": seed}, lambda: columns(run_scenario(scenario, [seed])[0]))
    return told(held, car.L)


def columns(one: Recording) -> dict[str, Array]:
    """Return what the benchmark reads of a recording: arrays (n,) in SI by a short name."""
    log, truth = one.log, one.truth
    found = {"t": log["t [s]"], "delta": log["delta [rad]"], "r": log["r [rad/s]"], "U": log["U [m/s]"]}
    found |= {"ay": log["ay [m/s^2]"], "K": truth["K [m^2/s^2]"], "acting": truth["delta [rad]"]}
    return found | {name: truth[f"{name} [-]"] for name in GROUPS}


def draw(seeds: list[int], factors: dict[str, float]) -> Car:
    """Return the cars of the seeds: floats for one, arrays (seeds,) for more; ``factors`` on K and eta."""
    rows = [_one_car(generator(seed, "benchmark car")) for seed in seeds]
    L, k, pi1, eta, rho = np.array(rows).T if len(rows) > 1 else rows[0]
    return Car.of_groups(L=L, K=k * factors["K"], pi1=pi1, eta=eta * factors["eta"], rho=rho, m=MASS + 0 * L)


def _one_car(rng: np.random.Generator) -> tuple[float, ...]:
    while True:
        L, stiffness = rng.uniform(2.3, 3.2), K * np.exp(LN_K_SD * rng.standard_normal())
        pi1 = rng.normal(PI1, PI1_SD)
        ratio = K_RATIO * np.exp(LN_K_RATIO_SD * rng.standard_normal())
        pi5 = PI5 * np.exp(LN_PI5_SD * rng.standard_normal())
        eta = ratio * (1 - pi1) / pi1
        if eta > LEAST_ETA:
            return L, stiffness, pi1, eta, pi5 / (pi1 * (1 - pi1))


def scenario(cell: Cell, foreign: str = "") -> Scenario:
    """Return a cell's scenario; ``foreign`` names the car that its plant brings along."""
    changes = cell.changes
    if foreign:
        changes["plant"]["vehicle"] = foreign
        changes["vehicle"] = {"name": foreign, "population": "passenger_cars", "known": ["L"]}
    return read_scenario(BASE, changes=changes)


def told(one: dict[str, Array], L: float) -> tuple[Drive, Truth]:
    """Return what an estimator is told of a recording's `columns` and the wheelbase [m], and the truth."""
    vehicle = Vehicle(
        "benchmark",
        L=Uncertain(L, None, parse_unit("m")),
        yaw_rate_noise=Uncertain(NOISE, None, parse_unit("rad/s")),
        accelerometer=Uncertain(BEHIND, BEHIND_SD, parse_unit("m")),
        origins=dict.fromkeys(("L", "yaw_rate_noise", "accelerometer"), "vehicle file"),
    )
    drive = Drive(one["t"], one["delta"], one["r"], one["U"], one["ay"], vehicle)
    groups = {name: float(one[name][0]) for name in GROUPS}
    return drive, Truth(one["K"], one["acting"], groups)
