"""The population filter applied to a log: setup, lag, estimate, verdict, and what was assumed.

Invariant: the verdict is decided on the pass whose numbers are reported.
"""

from __future__ import annotations

from dataclasses import asdict

import numpy as np

from similitude.accelerometer import Accelerometer, find_accelerometer
from similitude.change_alarm import watch
from similitude.cross_check import cross_check, sentence
from similitude.drive_memory import TakenUp, in_line, remember, take_up
from similitude.filter_run import Pass
from similitude.handling import handling
from similitude.identify_setup import (
    assumed_of,
    average_lag,
    edges,
    group_table,
    prepare,
    reported,
    seen_speed,
    warnings_of,
    whole_log,
    with_whole_log,
)
from similitude.information_meter import information
from similitude.log import Log
from similitude.monitor_config import BETWEEN_FALSE_ALARMS
from similitude.prediction import predict_ahead
from similitude.run import Assumed, Nuisance, Run, Trace, axle_stiffness, held, positive_estimate
from similitude.saved_state import SavedState
from similitude.speed_unit_doubt import speed_unit_doubts
from similitude.steer_passes import passes
from similitude.time_scales import time_scales
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import NAMES
from similitude.verdict import evidence, linear_doubts, verdict

SIDEWAYS = {"ay_bias": "m/s^2", "place": "-"}  # of the accelerometer's filter


def identify_population(log: Log, vehicle: Vehicle, state: SavedState | None = None) -> Run:
    """Run the population filter over a log; see `similitude.identification.identify`."""
    ready = prepare(log, vehicle, state.settings if state else None)
    batch = None
    if ready.setup.library.c is not None and state is None:
        ready, batch = with_whole_log(ready)
    elif ready.setup.library.c is not None:
        batch = whole_log(ready, ready.setup.run())
    prior, scan = ready.prior, ready.scan
    accelerometer, unused = find_accelerometer(log, vehicle)
    setup = ready.setup.with_accelerometer(accelerometer) if accelerometer else ready.setup
    taken = take_up(state, vehicle, setup) if state else None
    in_time = in_line(setup, taken)
    if taken is None:
        done, lag_spread = passes(in_time, scan)
    else:
        done = in_time.run(taken.filter)
        lag_spread = np.full(log.samples, taken.state.settings["ln_K_std_of_lag"])
    watched = watch(done, taken.monitor if taken else None)
    check = cross_check(ready, done)
    trace = trace_of(done, done.output("estimate"), np.hypot(np.sqrt(done.output("variance")), lag_spread))
    seen = evidence(log, trace, prior, noise_scale=done.value("noise_scale"), at_limit=edges(done))
    code, reason = verdict(seen)
    learnt = code != "not_excited"
    doubts = linear_doubts(seen) if learnt else ()
    K = positive_estimate(trace.K[-1], trace.ln_K_std[-1], "m^2/s^2")
    scales = time_scales(trace, taken.state.tyre if taken else None, taken.idle if taken else 0.0)
    values = {name: done.value(name) for name in NAMES}
    covariance = done.covariance(list(NAMES))
    covariance[0, 0] = trace.ln_K_std[-1] ** 2
    return Run(
        log=log,
        vehicle=vehicle,
        estimator="population",
        trace=trace,
        verdict=code,
        reason=reason,
        K=K,
        pi3={
            "value": trace.pi3[-1],
            "std": trace.pi3_std[-1],
            "at_speed": float(seen_speed(trace.U[-1], prior)),
        },
        groups=group_table(values, np.sqrt(np.diag(covariance)), prior),
        nuisance=_nuisance(done),
        lag=scan,
        prediction=predict_ahead(setup, batch, average_lag=average_lag(ready)),
        handling=handling(values, covariance, L=setup.L, U=usual_speed(done), mass=vehicle.m),
        warnings=(
            *log.warnings,
            *([unused] if unused else []),
            *([sentence(check)] if check and check.structure_error else []),
            *(one.warning for one in (speed_unit_doubts(ready, batch) if learnt else ())),
            *warnings_of(ready, batch, learnt=learnt),
            *doubts,
        ),
        assumed=assumed_of(ready) | _assumed_of_accelerometer(accelerometer) | _assumed_of_watch(taken),
        Caf=axle_stiffness(vehicle, K),
        batch=reported(batch, float(lag_spread[-1]) if scan.others else 0.0) if batch else None,
        cross_check=check,
        alarms=tuple(alarm.record for alarm in watched.alarms),
        monitor={"armed_share": watched.armed_share, "hours_between_false_alarms": BETWEEN_FALSE_ALARMS},
        information=asdict(information(trace.t, trace.information, float(trace.ln_K_std[-1]))),
        time_scales=scales.record,
        memory=remember(vehicle, done, watched, scales, float(lag_spread[-1])),
    )


def _assumed_of_accelerometer(found: Accelerometer | None) -> dict[str, Assumed]:
    if found is None:
        return {}
    return {
        "accelerometer": Assumed(
            found.behind, "m", f"vehicle file, ± {found.behind_sd:.2g} m behind the axle"
        ),
        "ay_noise": Assumed(found.noise, "m/s^2", "estimated from the log"),
    }


def _assumed_of_watch(taken: TakenUp | None) -> dict[str, Assumed]:
    alarms = Assumed(BETWEEN_FALSE_ALARMS, "h", "threshold measured over simulated roads; docs/monitor.md")
    started = {"start": Assumed(taken.elapsed, "s", taken.told)} if taken else {}
    return {"time between false alarms": alarms, **started}


def usual_speed(done: Pass) -> float:
    """Median speed of the rows a pass could use [m/s]; without any, the last speed."""
    U = held(done.setup.log.U)
    return float(np.median(U[done.used])) if done.used.any() else float(U[-1])


def trace_of(done: Pass, K: np.ndarray, ln_K_std: np.ndarray, information: np.ndarray | None = None) -> Trace:
    """Rows of the log; a missing speed is that of the row before.

    ``K`` and ``ln_K_std`` (n,) are the estimate; ``information`` (n,) that of the pass, if not given.
    """
    log = done.setup.log
    U = held(log.U)
    pi3 = K / seen_speed(U, done.setup.prior) ** 2
    predicted = done.output("predicted")
    return Trace(
        t=log.t,
        K=K,
        ln_K_std=ln_K_std,
        pi3=pi3,
        pi3_std=pi3 * ln_K_std,
        r_measured=log.r,
        r_predicted=predicted,
        innovation=np.where(np.isfinite(log.r) & done.used, done.output("innovation"), np.nan),
        innovation_std=np.sqrt(done.output("innovation_variance")),
        information=done.output("information_gained") if information is None else information,
        U=U,
        ay_kinematic=U * predicted,
        status=done.status,
    )


def _nuisance(done: Pass) -> dict[str, Nuisance]:
    names = {
        "yaw_bias": "output_bias",
        "steer_offset": "input_offset",
        "steer_scale": "input_scale",
        "disturbance": "disturbance",
    }
    names |= {name: name for name in SIDEWAYS if name in done.setup.library.names("state")}
    units = SIDEWAYS | {"yaw_bias": "rad/s", "steer_offset": "rad", "steer_scale": "-", "disturbance": "rad"}
    std = np.sqrt(np.diag(done.covariance(list(names.values()))))
    return {
        name: Nuisance(done.value(field), float(s), units[name])
        for (name, field), s in zip(names.items(), std, strict=True)
    }
