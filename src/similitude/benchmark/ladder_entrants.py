"""Our own entrants: the estimators of the ladder, through their compiled loops and without reports.

They are what `identify` runs, with one difference: nothing is taken from the end of a log for its
beginning. The steer lag is fitted to the first ten seconds, which are not judged, as `identify` fits it to
the whole log, and for the population filter anew after thirty; only `batch` sees a whole log at once.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import lru_cache, partial
from typing import Any, TypeVar

import numpy as np

from similitude.accelerometer import Accelerometer
from similitude.benchmark.drives import AY_NOISE, Drive
from similitude.benchmark.entrant import Answer, Entrant
from similitude.benchmark.scoring import SETTLING
from similitude.change_alarm import watch
from similitude.estimators import paper_design
from similitude.estimators.paper_bias import predicted_bias
from similitude.filter_config import MEASURED_STEER_SD
from similitude.filter_run import Pass, population_setup, side_by_side
from similitude.identify_paper import known_errors
from similitude.identify_population import edges, trace_of
from similitude.identify_setup import Prepared, whole_log, with_fitted_lag
from similitude.ladder_passes import doubts, rung
from similitude.log import Log
from similitude.noise import SensorNoise
from similitude.program.library import shipped
from similitude.steer_lag import MEASURED_LAG, LagScan
from similitude.vehicle_prior import vehicle_prior
from similitude.verdict import evidence, verdict

Done = TypeVar("Done")
LAG_AGAIN = 30.0  # s: then the steer lag is fitted anew, and what was driven gone over again
SCAN = LagScan(np.empty(0), np.empty(0), MEASURED_LAG.value, "assumed", MEASURED_LAG.sd)


def ladder() -> list[Entrant]:
    """Return our estimators, the simplest first."""
    return [
        Entrant("paper", "the paper's regression, exactly", _paper),
        Entrant("band", "first-order regression in a band", partial(_regression, "band")),
        Entrant("output_error", "recursive prediction error", partial(_regression, "output_error")),
        Entrant("robust", "state-variable filter, four parameters", partial(_regression, "robust")),
        Entrant("population", "Kalman filter with the population as prior, and its alarm", _population),
        Entrant("with_ay", "the same, with lateral acceleration", partial(_population, accelerometer=True)),
        Entrant("batch", "maximum a posteriori over the whole log", _batch, whole_log=True),
    ]


@lru_cache(maxsize=2)
def prepared(drive: Drive, after: float = SETTLING) -> Prepared:
    """Return a drive ready for the population's estimators, with the steer lag that its first seconds show.

    They ask one after another: the lag is fitted for the first, and its time stands with that one.
    """
    ready = _of_measured(drive)
    lag = _fitted_lag(_Start.of(drive.until(drive.t[0] + after)))
    return replace(ready, setup=ready.setup.with_lag(lag.chosen, MEASURED_STEER_SD), scan=lag)


@dataclass(frozen=True)
class _Start:
    """The first seconds of a drive, which a drive that is cut later shares with the whole."""

    rows: bytes
    known: tuple[float, float]
    drive: Drive = field(compare=False)

    @classmethod
    def of(cls, drive: Drive) -> _Start:
        """The start that a drive is."""
        rows = b"".join(x.tobytes() for x in (drive.t, drive.delta, drive.r, drive.U))
        return cls(rows, (drive.L, drive.noise), drive)


@lru_cache(maxsize=2)
def _fitted_lag(start: _Start) -> LagScan:
    ready = _of_measured(start.drive)
    return with_fitted_lag(ready, whole_log(ready, ready.setup.run())).scan


def _of_measured(drive: Drive) -> Prepared:
    """The same with the lag that measured angles have."""
    log = Log(
        name="benchmark",
        path=None,
        t=drive.t,
        delta=drive.delta,
        r=drive.r,
        U=drive.U,
        ay=drive.ay,
        sources={},
    )
    prior = vehicle_prior(drive.vehicle)
    setup = population_setup(
        log, prior, L=drive.L, noise_std=drive.noise, input_scale_sd=MEASURED_STEER_SD
    ).with_lag(SCAN.chosen, MEASURED_STEER_SD)
    return Prepared(drive.vehicle, prior, SensorNoise(drive.noise, 1.0, 0.0), setup, SCAN, False, {})


def _population(drive: Drive, *, accelerometer: bool = False) -> Answer:
    """The first rows with the lag of ten seconds, the others from a pass with that of thirty."""
    again = drive.t[0] + LAG_AGAIN
    if drive.t[-1] < again:
        return _one_pass(drive, prepared(drive), accelerometer)
    begun = drive.until(again)
    first = _one_pass(begun, prepared(begun), accelerometer)
    then = _one_pass(drive, prepared(drive, LAG_AGAIN), accelerometer)
    late = drive.t >= again
    K, sd = then.K.copy(), then.ln_K_std.copy()
    K[~late], sd[~late] = first.K, first.ln_K_std
    alarms = [t for t in first.alarms if t < again] + [t for t in then.alarms if t >= again]
    return replace(then, K=K, ln_K_std=sd, alarms=alarms)


def _one_pass(drive: Drive, ready: Prepared, accelerometer: bool) -> Answer:
    setup = ready.setup
    if accelerometer:
        place = drive.vehicle.accelerometer
        setup = setup.with_accelerometer(Accelerometer(place.value, place.sd, AY_NOISE))
    lag, sd = ready.scan.chosen, ready.scan.std
    lags = [lag + sd, lag - sd]
    done, seconds = _timed(setup.run)
    later, earlier = side_by_side([setup.with_lag(one, MEASURED_STEER_SD).run for one in lags])
    spread = np.abs(np.log(later.output("estimate") / earlier.output("estimate"))) / 2
    sd = np.hypot(np.sqrt(done.output("variance")), spread)
    trace = trace_of(done, done.output("estimate"), sd)
    watched, more = _timed(partial(watch, done))
    operations = done.setup.library.layout.OPERATIONS + shipped("bicycle_monitor").layout.OPERATIONS
    return Answer(
        K=trace.K,
        ln_K_std=sd,
        alarms=[alarm.t for alarm in watched.alarms],
        identified=_identified(ready, trace, done, edges(done)),
        operations=operations,
        step_seconds=seconds + more,
    )


def _regression(name: str, drive: Drive) -> Answer:
    ready = prepared(drive)
    one = rung(name, ready.setup, ready.prior)
    done, seconds = _timed(one.run)
    sd = np.sqrt(sum(part**2 for part in doubts(done, ready.scan).values()))
    sd[np.cumsum(done.output("unknowns") > 0) == 0] = ready.prior.std[0]
    return Answer(
        K=done.output("estimate"),
        ln_K_std=sd,
        operations=one.library.layout.OPERATIONS,
        step_seconds=seconds,
    )


def _paper(drive: Drive) -> Answer:
    ready = prepared(drive)
    library = shipped("bicycle_paper")
    sample_time = float(np.median(np.diff(drive.t)))
    config = paper_design.paper_config(
        library,
        sample_time=sample_time,
        L=drive.L,
        speed=float(np.nanmedian(drive.U)),
        noise_std=drive.noise,
        K_start=float(ready.prior.mean[0]),
        **paper_design.PAPER_GROUPS,
    )
    state, rows = library.start(config), ready.setup.samples()
    (outputs, _), seconds = _timed(partial(library.run, config, state, rows))
    speed = float(state[library.index("state", "last_U")]) or 1.0
    pi3 = ready.prior.mean[0] / speed**2
    bias = predicted_bias(library, config, state, L=drive.L, noise_std=drive.noise, pi3=pi3)
    off = known_errors(paper_design.dimensionless_step(sample_time, speed, drive.L), bias, command=False)
    return Answer(
        K=outputs[:, library.index("output", "estimate")],
        ln_K_std=np.hypot(np.sqrt(outputs[:, library.index("output", "variance")]), off),
        operations=library.layout.OPERATIONS,
        step_seconds=seconds,
    )


def _batch(drive: Drive) -> Answer:
    ready = prepared(drive)
    fit = whole_log(ready, ready.setup.run())
    return Answer(K=fit.values["K"], ln_K_std=float(fit.std[0]))


def _identified(ready: Prepared, trace: Any, done: Pass, at_limit: tuple[str, ...]) -> bool:
    seen = evidence(
        ready.setup.log, trace, ready.prior, noise_scale=done.value("noise_scale"), at_limit=at_limit
    )
    return verdict(seen)[0] == "identified"


def _timed(loop: Callable[[], Done]) -> tuple[Done, float]:
    """What a loop over the rows returns, and its time [s]."""
    begun = time.perf_counter()
    return loop(), time.perf_counter() - begun
