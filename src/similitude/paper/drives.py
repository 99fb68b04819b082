"""The paper's two drives from their shipped scenarios, and the estimators on them.

    Figure 5  square_closed_loop        60 s, linear tyres, stiffness halved every other 10 s
    Figure 7  treadmill_hydroplaning   110 s, saturating tyres, dry and wet half, split while crossing

Invariant: what an estimator reads is a log of the scenario: with the yaw rate as it was (a perfect
sensor) or as a gyro of 0.1 deg/s writes it. The driver feels the truth in both, so the motion is one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from similitude.estimators.paper_design import PAPER_GROUPS, paper_config
from similitude.paper.ahead import kept
from similitude.population import Prior
from similitude.program.library import Library, shipped
from similitude.simulation.recording import Recording, run_scenario
from similitude.simulation.running_filter import filter_of, told_prior
from similitude.simulation.scenario import Scenario, read_scenario

Array = NDArray[np.float64]
GYRO = "0.1 deg/s"
NOISE = float(np.deg2rad(0.1))  # rad/s, of that gyro
QUIET = 1e-4  # rad/s: what the regression is told of a sensor without noise; bounds its reported sd only
SEED = 0
SOFT = "0.5"  # of the stiffness: what the paper measured off-line on the wet half
SOFTEST = "0.06"  # of the stiffness: what the scenario leaves of it while hydroplaning


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


def drive_of(scenario: Scenario, seed: int = SEED) -> Drive:
    """Drive a scenario with a path once."""
    (recording,) = run_scenario(scenario, [seed])
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
    return drive_of(read_scenario("treadmill_hydroplaning", changes={"driver.schedule": "estimate"}))


@kept
def belt_soft() -> Drive:
    """Figure 7 with one gain again, but that of half the stiffness."""
    return _until_back({"driver.design_stiffness": SOFT})


@kept
def belt_softest() -> Drive:
    """Figure 7 with one gain, that of the stiffness which is left while hydroplaning."""
    return _until_back({"driver.design_stiffness": SOFTEST})


@kept
def belt_told() -> Drive:
    """Figure 7 with a gain that follows the true stiffness under the front axle."""
    return _until_back({"driver.schedule": "truth"})


def _until_back(changes: Mapping[str, str]) -> Drive:
    """The first 90 s of Figure 7; what came so far does not depend on when a drive ends."""
    return drive_of(read_scenario("treadmill_hydroplaning", changes={"run.duration": "90 s", **changes}))


@lru_cache
def prior_of(scenario: str) -> Prior:
    """What the scenario's vehicle file and its population say of K, pi1, eta and rho."""
    return told_prior(read_scenario(scenario))


def population_config(scenario: Scenario) -> tuple[Library, Array]:
    """The default filter and its configuration for a scenario's car and a gyro of 0.1 deg/s."""
    return filter_of(scenario, NOISE, prior_of(scenario.name))


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
    place = {"sample_time": drive.step, "L": drive.L, "speed": float(np.median(drive.U))}
    config = paper_config(library, noise_std=QUIET, **place, **groups, **changes)
    outputs, _ = library.run(config, library.start(config), drive.samples(r))
    return outputs[:, library.index("output", "pi3")]
