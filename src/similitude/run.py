"""Run: what an estimator found in a log, with everything the reports say.

Invariant: every number of a Run is finite (where there was no measurement, its innovation is NaN; a
bound of a handling number that does not exist is infinite), and whatever was not in the log is listed
under ``assumed`` with where it came from.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.log import Log
from similitude.steer_lag import LagScan
from similitude.vehicle_file import Vehicle

Z95 = 1.96


@dataclass(frozen=True)
class Estimate:
    """A value with its sd and 95 % interval."""

    value: float
    std: float
    lo: float
    hi: float
    unit: str


@dataclass(frozen=True)
class Group:
    """A slow unknown at the end of the log, beside what the population said."""

    value: float
    std: float
    prior_value: float
    prior_std: float
    meaning: str


@dataclass(frozen=True)
class Nuisance:
    """A quantity the estimate had to live with."""

    value: float
    std: float
    unit: str


@dataclass(frozen=True)
class Assumed:
    """A number that was not in the log, and where it came from."""

    value: float | str | None
    unit: str
    origin: str


@dataclass(frozen=True)
class Batch:
    """What one car for the whole log gives: K, and how it hangs together with the rest.

    ``correlation`` is of ln K with each other coordinate; ``widened`` by how much the variance from the
    data was raised for innovations that are alike; ``halves`` K of the ``first`` and ``second`` half
    [m^2/s^2] and by how many sd they are apart (``apart_sd``).
    """

    K: Estimate
    correlation: Mapping[str, float]
    widened: float
    halves: Mapping[str, float]


@dataclass(frozen=True)
class CrossCheck:
    """The filter's K against that of an estimator of another kind over the same stretch of the log.

    ``K`` is that of the other, ``population`` the filter's own; ``apart`` is their difference as a share
    of it, ``std`` the sd that it would have if both were right; ``average_apart`` and ``average_std`` are
    the same with the other's groups at the population's averages; ``unknowns`` is how many the drive let
    the other carry.
    """

    K: Estimate
    population: Estimate
    apart: float
    std: float
    average_apart: float
    average_std: float
    unknowns: int
    structure_error: bool


@dataclass(frozen=True, eq=False)
class Trace:
    """The estimate row by row, (n,) each; ``innovation`` is NaN where nothing was measured."""

    t: NDArray[np.float64]
    K: NDArray[np.float64]
    ln_K_std: NDArray[np.float64]
    pi3: NDArray[np.float64]
    pi3_std: NDArray[np.float64]
    r_measured: NDArray[np.float64]
    r_predicted: NDArray[np.float64]
    innovation: NDArray[np.float64]
    innovation_std: NDArray[np.float64]
    information: NDArray[np.float64]
    U: NDArray[np.float64]
    ay_kinematic: NDArray[np.float64]
    status: NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class Run:
    """What `identify` found in one log."""

    log: Log
    vehicle: Vehicle
    estimator: str
    trace: Trace
    verdict: str
    reason: str
    K: Estimate
    pi3: Mapping[str, float]
    groups: Mapping[str, Group]
    nuisance: Mapping[str, Nuisance]
    lag: LagScan
    prediction: Mapping[str, float]
    handling: Mapping[str, Mapping[str, float | str]]
    warnings: tuple[str, ...]
    assumed: Mapping[str, Assumed]
    Caf: Estimate | None = None
    alarms: tuple = ()
    batch: Batch | None = None
    cross_check: CrossCheck | None = None
    monitor: Mapping[str, float | str] | None = None  # share of the log it was armed, false alarms
    information: Mapping[str, float | str | None] | None = None  # in the driver's terms
    time_scales: Mapping[str, Mapping[str, float]] | None = None  # of the tyre and of the road
    memory: Any = None  # a SavedState to take up with the next drive


def positive_estimate(value: float, log_std: float, unit: str) -> Estimate:
    """Estimate of a positive quantity from the sd of its logarithm; 95 % is value exp(±1.96 sd)."""
    factor = float(np.exp(Z95 * min(log_std, 300.0)))
    return Estimate(value, value * log_std, value / factor, value * factor, unit)


def axle_stiffness(vehicle: Vehicle, K: Estimate) -> Estimate | None:
    """Caf = K m/L where the mass is known; the mass's own sd counts."""
    if vehicle.m is None or vehicle.L is None:
        return None
    own = (vehicle.m.sd or 0.0) / vehicle.m.value
    return positive_estimate(
        K.value * vehicle.m.value / vehicle.L.value, float(np.hypot(K.std / K.value, own)), "N/rad"
    )


def held(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Missing values replaced by the last one before (or, at the start, the first one after)."""
    known = np.flatnonzero(np.isfinite(values))
    if not known.size:
        return np.zeros_like(values)
    at = np.maximum(np.searchsorted(known, np.arange(len(values)), side="right") - 1, 0)
    return values[known[at]]
