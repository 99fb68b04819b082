"""The population filter beside a drive: it reads a row of the log as it is written, and says pi3.

Invariant: it is told what the vehicle file and the population tell, and the noise of the gyro; never
the truth. What it says is held from one row of the log to the next.
"""

from __future__ import annotations

import math
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.errors import ScenarioError
from similitude.filter_config import MEASURED_STEER_SD, filter_config
from similitude.filter_run import POPULATION
from similitude.population import Prior
from similitude.program.library import Library, shipped
from similitude.simulation.scenario import Scenario
from similitude.vehicle_file import Vehicle, read_vehicle
from similitude.vehicle_prior import vehicle_prior


def told_vehicle(scenario: Scenario) -> Vehicle:
    """The vehicle as the file that belongs to the scenario's log tells it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "vehicle.toml"
        path.write_text(scenario.vehicle.vehicle_file(), encoding="utf-8")
        return read_vehicle(path)


def told_prior(scenario: Scenario) -> Prior:
    """What that vehicle file and its population say of K, pi1, eta and rho."""
    return vehicle_prior(told_vehicle(scenario))


def gyro_noise(scenario: Scenario) -> float:
    """Noise of the gyro at a row of the log [rad/s]: as told, or the sensor's own with its rounding.

    Raises
    ------
    ScenarioError   nothing is told and the gyro is perfect: a filter needs a noise to weigh rows by
    """
    told, sensor = told_vehicle(scenario).yaw_rate_noise, scenario.sensors.r
    noise = told.value if told else math.hypot(sensor.noise, sensor.quantum / math.sqrt(12))
    if noise > 0:
        return noise
    raise ScenarioError(
        f"{scenario.name}: driver.schedule = 'estimate' with a gyro that has neither noise nor rounding",
        usually="the scenario has perfect sensors; the filter that runs beside the drive weighs its rows by "
        "the noise of the gyro.",
        paste='--set "sensors.r.noise=0.1 deg/s"',
        read='docs/simulate.md, "Drivers"',
    )


def filter_of(scenario: Scenario, noise_std: float, prior: Prior | None = None) -> tuple[Library, NDArray]:
    """The default filter and its configuration for a scenario's car.

    Parameters
    ----------
    scenario : Scenario
    noise_std : of the gyro at a row [rad/s], > 0.
    prior : of K, pi1, eta, rho; that of the scenario's vehicle file when left out.
    """
    library = shipped(POPULATION)
    prior = told_prior(scenario) if prior is None else prior
    L = scenario.vehicle.length.value
    return library, filter_config(library, prior, L=L, noise_std=noise_std, input_scale_sd=MEASURED_STEER_SD)


class RunningFilter:
    """The filter of one drive: called at every step, it reads at every row of the log.

    ``heard`` collects K at every row [m²/s²].

    Parameters
    ----------
    scenario : Scenario   with a driver who follows a path

    Raises
    ------
    ScenarioError   see `gyro_noise`
    """

    def __init__(self, scenario: Scenario) -> None:
        self._library, self._config = filter_of(scenario, gyro_noise(scenario))
        self._state = self._library.start(self._config)
        self._every = scenario.timing.rows_every
        self._step = scenario.timing.step * self._every
        self._ticks = 0
        self.heard: list[float] = []

    def __call__(self, t: float, steer: float, r: float, U: float) -> float:
        """Return pi3 [-] after a step at time t [s]: steer [rad], gyro's yaw rate [rad/s], speed [m/s]."""
        if self._ticks % self._every == 0:
            outputs, _ = self._library.run(self._config, self._state, np.array([[self._step, steer, U, r]]))
            self.heard.append(float(outputs[0, 0]))
        self._ticks += 1
        return self.heard[-1] / (U * U)
