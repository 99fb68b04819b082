"""The batch fit applied to a log: one car for the whole of it, with the verdict and the report of any run.

Invariant: K is the same on every row, and so is its interval; the rows show how that car explains the log.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from similitude.batch_fit import BatchFit, coordinate_limits
from similitude.handling import handling
from similitude.identify_population import trace_of, usual_speed
from similitude.identify_setup import (
    assumed_of,
    average_lag,
    group_table,
    held_by_limits,
    prepare,
    reported,
    seen_speed,
    warnings_of,
    with_whole_log,
)
from similitude.log import Log
from similitude.prediction import predict_ahead
from similitude.run import Nuisance, Run, axle_stiffness
from similitude.speed_unit_doubt import speed_unit_doubts
from similitude.steer_passes import behind_servos
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import NAMES
from similitude.verdict import evidence, linear_doubts, verdict


def identify_batch(log: Log, vehicle: Vehicle) -> Run:
    """Fit a whole log at once; see `similitude.identification.identify`."""
    ready, batch = with_whole_log(prepare(log, vehicle))
    prior = ready.prior
    setup = replace(ready.setup, library=batch.frozen.setup.library)
    done = replace(batch.frozen, setup=setup).run(batch.x, batch.scales)
    rows = np.ones(log.samples)
    information = np.interp(log.t, batch.t, batch.information)
    open_servo = behind_servos(ready.setup, ready.scan)
    ln_K_std = float(np.hypot(batch.std[0], open_servo))
    trace = trace_of(done, batch.values["K"] * rows, ln_K_std * rows, information)
    low, high = (limit[:4] for limit in coordinate_limits(batch.frozen))
    at_limit = held_by_limits(batch.x[:4], low, high, prior, ln_K_std)
    noise_scale = float(np.exp(batch.scales[0]))
    seen = evidence(log, trace, prior, noise_scale=noise_scale, at_limit=at_limit)
    code, reason = verdict(seen)
    learnt = code != "not_excited"
    found = reported(batch, open_servo)
    values = {name: batch.values[name] for name in NAMES}
    return Run(
        log=log,
        vehicle=vehicle,
        estimator="batch",
        trace=trace,
        verdict=code,
        reason=reason,
        K=found.K,
        pi3={
            "value": trace.pi3[-1],
            "std": trace.pi3_std[-1],
            "at_speed": float(seen_speed(trace.U[-1], prior)),
        },
        groups=group_table(values, batch.std[:4], prior),
        nuisance=_nuisance(batch),
        lag=ready.scan,
        prediction=predict_ahead(ready.setup, batch, recursive=False, average_lag=average_lag(ready)),
        handling=handling(
            values, batch.covariance[:4, :4], L=ready.setup.L, U=usual_speed(done), mass=vehicle.m
        ),
        warnings=(
            *log.warnings,
            *(linear_doubts(seen) if learnt else ()),
            *(one.warning for one in (speed_unit_doubts(ready, batch) if learnt else ())),
            *warnings_of(ready, batch, learnt=learnt),
        ),
        assumed=assumed_of(ready),
        Caf=axle_stiffness(vehicle, found.K),
        batch=found,
    )


def _nuisance(batch: BatchFit) -> dict[str, Nuisance]:
    (offset, bias), (offset_std, bias_std) = batch.zero, batch.zero_std
    scale, lag = batch.values["steer_scale"], batch.values["steer_lag"]
    return {
        "yaw_bias": Nuisance(bias, bias_std, "rad/s"),
        "steer_offset": Nuisance(offset, offset_std, "rad"),
        "steer_scale": Nuisance(scale, float(scale * batch.std[4]), "-"),
        "steer_lag": Nuisance(lag, batch.lag_std, "s"),
    }
