"""The paper's two drives from their shipped scenarios, and the estimators on them.

    Figure 5  square_closed_loop        60 s, linear tyres, stiffness halved every other 10 s
    Figure 7  treadmill_hydroplaning   110 s, saturating tyres, dry and wet half, split while crossing

Invariant: what an estimator reads is a log of the scenario: with the yaw rate as it was (a perfect
sensor) or as a gyro of 0.1 deg/s writes it. The driver feels the truth in both, so the motion is one.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.estimators.paper_design import PAPER_GROUPS, paper_config
from similitude.filter_config import MEASURED_STEER_SD, filter_config
from similitude.filter_run import POPULATION
from similitude.paper.ahead import kept
from similitude.population import Prior
from similitude.program.library import Library, shipped
from similitude.simulation.loop import Estimate
from similitude.simulation.recording import Recording, run_scenario
from similitude.simulation.scenario import Scenario, read_scenario
from similitude.vehicle_file import read_vehicle
from similitude.vehicle_prior import vehicle_prior

Array = NDArray[np.float64]
GYRO = "0.1 deg/s"
NOISE = float(np.deg2rad(0.1))  # rad/s, of that gyro
QUIET = 1e-4  # rad/s: what the regression is told of a sensor without noise; bounds its reported sd only
SEED = 0


@dataclass(frozen=True, eq=False)
class Drive:
    """One drive of a scenario: (n,) arrays in SI units.

    ``delta`` measured steer, ``r`` yaw rate as it was, ``r_gyro`` as the gyro wrote it, ``K`` true,
    ``y`` and ``wanted`` the place across the road, ``beta`` sideslip.
    """

    scenario: Scenario
    t: Array
    delta: Array
    r: Array
    r_gyro: Array
    U: Array
    K: Array
    y: Array
    wanted: Array
    beta: Array

    @property
    def step(self) -> float:
        """Sample time [s]."""
        return float(self.t[1] - self.t[0])

    @property
    def L(self) -> float:
        """Wheelbase [m]."""
        return float(self.scenario.vehicle.nominal().L)

    @property
    def pi3(self) -> Array:
        """K/U², true (n,) [-]."""
        return self.K / self.U**2

    def during(self, first: float, last: float) -> NDArray[np.bool_]:
        """Rows from a time to another [s], (n,)."""
        return (self.t >= first) & (self.t < last)

    def samples(self, r: Array) -> Array:
        """Rows for an estimator, (n, 4): dt, steer, speed, yaw rate."""
        return np.column_stack([np.full(self.t.size, self.step), self.delta, self.U, r])


def drive_of(scenario: Scenario, estimate: Estimate | None = None, seed: int = SEED) -> Drive:
    """Drive a scenario once.

    Parameters
    ----------
    scenario : Scenario   with a path. estimate : for a driver with ``schedule = "estimate"``.
    """
    (recording,) = run_scenario(scenario, [seed], estimate=estimate)
    return _drive(scenario, recording)


def _drive(scenario: Scenario, recording: Recording) -> Drive:
    log, truth = recording.log, recording.truth
    return Drive(
        scenario,
        truth["t [s]"],
        log["delta [rad]"],
        truth["r [rad/s]"],
        log["r [rad/s]"],
        log["U [m/s]"],
        truth["K [m^2/s^2]"],
        truth["y [m]"],
        truth["wanted y [m]"],
        truth["beta [rad]"],
    )


@kept
def square() -> Drive:
    """Figure 5."""
    return drive_of(read_scenario("square_closed_loop", changes={"sensors.r.noise": GYRO}))


@kept
def belt() -> Drive:
    """Figure 7, with the fixed gain."""
    return drive_of(read_scenario("treadmill_hydroplaning"))


@kept
def belt_scheduled() -> Drive:
    """Figure 7 once more, the gain following the estimate of the filter that runs beside."""
    scenario = read_scenario("treadmill_hydroplaning", changes={"driver.schedule": "estimate"})
    return drive_of(scenario, RunningFilter(scenario))


@lru_cache
def prior_of(scenario: str) -> Prior:
    """What the scenario's vehicle file and its population say of K, pi1, eta and rho."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "vehicle.toml"
        path.write_text(read_scenario(scenario).vehicle.vehicle_file(), encoding="utf-8")
        return vehicle_prior(read_vehicle(path))


def population_config(scenario: Scenario) -> tuple[Library, Array]:
    """The default filter and its configuration for a scenario's car and a gyro of 0.1 deg/s."""
    library = shipped(POPULATION)
    config = filter_config(
        library,
        prior_of(scenario.name),
        L=scenario.vehicle.nominal().L,
        noise_std=NOISE,
        input_scale_sd=MEASURED_STEER_SD,
    )
    return library, config


def population_reads(drive: Drive, r: Array) -> tuple[Array, Array]:
    """K and the sd of its logarithm from the population filter, (n,) each [m²/s²], [-]."""
    library, config = population_config(drive.scenario)
    outputs, _ = library.run(config, library.start(config), drive.samples(r))
    return outputs[:, library.index("output", "estimate")], np.sqrt(
        outputs[:, library.index("output", "variance")]
    )


def regression_reads(
    drive: Drive, r: Array, *, groups: Mapping[str, float] = PAPER_GROUPS, **changes: float
) -> Array:
    """The paper's estimate of pi3, (n,) [-].

    Parameters
    ----------
    r : (n,) yaw rate [rad/s]. groups : frozen, the averages unless given. changes : of its constants.
    """
    library = shipped("bicycle_paper")
    config = paper_config(library, sample_time=drive.step, L=drive.L, noise_std=QUIET, **groups, **changes)
    outputs, _ = library.run(config, library.start(config), drive.samples(r))
    return outputs[:, library.index("output", "pi3")]


class RunningFilter:
    """The population filter beside a drive: called once a tick, it reads one sample and says pi3.

    ``heard`` collects K of every tick [m²/s²].
    """

    def __init__(self, scenario: Scenario) -> None:
        self._library, self._config = population_config(scenario)
        self._state = self._library.start(self._config)
        self._step = scenario.timing.step
        self.heard: list[float] = []

    def __call__(self, t: float, steer: float, r: float, U: float) -> float:
        """Return pi3 [-] after the sample: steer [rad], gyro's yaw rate [rad/s], speed [m/s]."""
        sample = np.array([[self._step, steer, U, r]])
        outputs, _ = self._library.run(self._config, self._state, sample)
        self.heard.append(float(outputs[0, 0]))
        return self.heard[-1] / (U * U)
