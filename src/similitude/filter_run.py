"""The population filter over a log: samples, configuration, one pass, and what stands at the end.

Invariant: every pass over a log, with whatever lag or prior, goes through `Setup.run`, so the
scan, the estimate and the predictions use one and the same step.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from similitude.accelerometer import Accelerometer
from similitude.coarse_log import CoarseLog
from similitude.filter_config import filter_config
from similitude.log import Log
from similitude.population import Prior
from similitude.program.library import Library, shipped
from similitude.servo import DIRECT, Servo
from similitude.slow_bus import bridged

POPULATION = "saturating_bicycle_population"
WITH_ACCELEROMETER = "bicycle_with_accelerometer_population"
LINEAR = "bicycle_population"  # the same with linear tyres: the whole-log fit's, and the average car's
BRIDGED = 0.1  # s: hands on a wheel do little in between
# Passes at a time: ctypes lets go of the interpreter while one runs. Where whoever starts the process says
# that it has one processor, threads would only take turns.
WORKERS = 1 if os.environ.get("OMP_NUM_THREADS") == "1" else 2
FEW = 4000  # rows: two milliseconds of the filter
Found = TypeVar("Found")


@dataclass(frozen=True, eq=False)
class Setup:
    """All a pass over a log needs; values in SI units."""

    log: Log
    library: Library
    prior: Prior
    L: float  # m
    noise_std: float  # rad/s
    input_scale_sd: float  # -
    lag: float = 0.0  # s
    servo: Servo = DIRECT  # through which the wheels follow the steer of a lag ago
    accelerometer: Accelerometer | None = None
    first_step: float | None = None  # s from the last row of an earlier log
    tail: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None  # its last times [s] and steer [rad]
    coarse: CoarseLog | None = None  # whose means the log is, if it is

    @cached_property
    def dt(self) -> NDArray[np.float64]:
        """Time since the row before, (n,) [s]; the median step for the first row of all."""
        first = self.log.usual_step if self.first_step is None else self.first_step
        return np.concatenate([[first], self.log.steps])

    @cached_property
    def usual_step(self) -> float:
        """Median time between rows [s]."""
        return float(np.median(self.dt))

    def samples(self) -> NDArray[np.float64]:
        """Rows for the step: dt, steer as it acts, speed, yaw rate; then ay for the filter that takes it."""
        columns = [self.dt, self._acting_steer(), self.log.U, self.log.r]
        if len(self.library.layout.SAMPLE) > len(columns):
            columns.append(self.log.ay)
        return np.column_stack(columns)

    def _acting_steer(self) -> NDArray[np.float64]:
        """Steer of a lag ago behind the servo, (n,) [rad]; a long hole stays missing, a short is bridged."""
        log = self.log if self.coarse is None else self.coarse.whole
        known = np.flatnonzero(np.isfinite(log.delta))
        if (self.lag == 0 and self.servo.is_none) or known.size < 2:
            return self.log.delta
        there, angle = log.t[known], log.delta[known]
        if self.tail is not None:
            there, angle = np.concatenate([self.tail[0], there]), np.concatenate([self.tail[1], angle])
        late = self._late(log, there, angle)
        return late if self.servo.is_none else self._behind_servo(late, there, angle)

    def _late(self, log: Log, there: NDArray[np.float64], angle: NDArray[np.float64]) -> NDArray[np.float64]:
        """Steer of a lag ago at the filter's rows, (n,) [rad], from its readings and those before them.

        What is averaged is late, not late what was averaged: a line between two means is flatter half-way
        than at its ends, and the log would speak for lags of whole rows.
        """
        late = np.interp(log.t - self.lag, there, angle)
        gaps = np.diff(there)
        if (gaps > BRIDGED).any():
            wide = gaps > max(BRIDGED, 3 * log.usual_step)
            before = np.clip(np.searchsorted(there, log.t - self.lag), 1, there.size - 1) - 1
            late[wide[before]] = np.nan
        return late if self.coarse is None else self.coarse.steer(late)

    def _behind_servo(
        self, late: NDArray[np.float64], there: NDArray[np.float64], angle: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """What the servo makes of it, (n,) [rad]; it came from what was told before the first row."""
        known = np.isfinite(late)
        early = there + self.lag < self.log.t[0]
        at = np.concatenate([there[early] + self.lag, self.log.t[known]])
        told = np.concatenate([angle[early], late[known]])
        acting = np.full(late.size, np.nan)
        acting[known] = self.servo.follow(at, told)[early.sum() :]
        return acting

    def config(self, **changes: float) -> NDArray[np.float64]:
        """The filter's configuration; ``changes`` replaces design constants by name."""
        return filter_config(
            self.library,
            self.prior,
            L=self.L,
            noise_std=self.noise_std,
            input_scale_sd=self.input_scale_sd,
            accelerometer=self.accelerometer,
            **changes,
        )

    def run(self, state: NDArray[np.float64] | None = None, **changes: float) -> Pass:
        """One pass over the whole log, from the prior or from where an earlier log left the state."""
        config = self.config(**changes)
        state = self.library.start(config) if state is None else state.copy()
        outputs, status = self.library.run(config, state, self.samples())
        return Pass(self, config, state, outputs, status)

    def at_rate(self, rate: float) -> Setup:
        """The same over the log's means at so many rows a second [Hz], where it has twice as many."""
        if self.log.rate < 2 * rate * 0.999:
            return self
        untouched = self.coarse is not None and self.log is self.coarse.log
        coarse = CoarseLog(self.coarse.whole if untouched else bridged(self.log), rate)
        measured = max(int(np.isfinite(self.log.r).sum()), 1)
        noise_std = self.noise_std * float(np.sqrt(coarse.log.samples / measured))
        return replace(self, log=coarse.log, coarse=coarse, noise_std=noise_std)

    def with_accelerometer(self, accelerometer: Accelerometer) -> Setup:
        """The same with the filter that takes lateral acceleration."""
        return replace(self, accelerometer=accelerometer, library=shipped(WITH_ACCELEROMETER))

    def with_servo(self, servo: Servo) -> Setup:
        """The same with another steering servo."""
        return replace(self, servo=servo)

    def with_lag(self, lag: float, input_scale_sd: float) -> Setup:
        """The same with another steer lag [s] and steer scale sd [-]."""
        return replace(self, lag=lag, input_scale_sd=input_scale_sd)


@dataclass(frozen=True, eq=False)
class Pass:
    """Outputs (n, fields) and status (n,) of a pass, and the state after its last row."""

    setup: Setup
    config: NDArray[np.float64]
    state: NDArray[np.float64]
    outputs: NDArray[np.float64]
    status: NDArray[np.int32]

    def output(self, name: str) -> NDArray[np.float64]:
        """One output over the log, (n,)."""
        return self.outputs[:, self.setup.library.index("output", name)]

    def value(self, name: str) -> float:
        """One real of the final state."""
        return float(self.state[self.setup.library.index("state", name)])

    def covariance(self, names: list[str]) -> NDArray[np.float64]:
        """Final covariance of the named coordinates, (k, k)."""
        order = coordinates(self.setup.library)
        n = len(order)
        upper = np.zeros((n, n))
        start = self.setup.library.index("state", "P")
        upper[np.triu_indices(n)] = self.state[start : start + n * (n + 1) // 2]
        full = upper + np.triu(upper, 1).T
        at = [order.index(name) for name in names]
        return full[np.ix_(at, at)]

    @property
    def used(self) -> NDArray[np.bool_]:
        """Rows whose measurement was used, (n,)."""
        codes = self.setup.library.layout.STATUS
        counts = np.ones(max(codes.values()) + 1, bool)
        counts[[codes[name] for name in ("no_measurement", "too_slow", "bad_sample")]] = False
        return counts[self.status]

    @property
    def loss(self) -> NDArray[np.float64]:
        """Negative log likelihood of each innovation, (n,) [-]; NaN where none was used."""
        variance, innovation = self.output("innovation_variance"), self.output("innovation")
        return np.where(self.used, 0.5 * (np.log(variance) + innovation**2 / variance), np.nan)


def coordinates(library: Library) -> list[str]:
    """Names of the covariance's coordinates, in order."""
    return list(library.layout.COORDINATES)


def population_setup(log: Log, prior: Prior, **known: float) -> Setup:
    """A setup of the shipped bicycle filter; ``known`` holds L, noise_std and input_scale_sd."""
    return Setup(log, shipped(POPULATION), prior, **known)


def side_by_side(passes: Sequence[Callable[[], Found]], *, rows: int = FEW) -> list[Found]:
    """Results of independent passes, in the order given, `WORKERS` of them at a time.

    Passes over fewer than `FEW` rows are done one after another: each takes less than a thread does.
    """
    if rows < FEW or WORKERS == 1:
        return [one() for one in passes]
    with ThreadPoolExecutor(WORKERS) as pool:
        return [each.result() for each in [pool.submit(one) for one in passes]]
