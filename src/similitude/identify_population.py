"""The population filter applied to a log: setup, lag, estimate, verdict, and what was assumed.

Invariant: the verdict is decided on the pass whose numbers are reported.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from similitude.filter_config import COMMANDED_STEER_SD, MEASURED_STEER_SD
from similitude.filter_run import Pass, Setup, population_setup
from similitude.handling import handling
from similitude.log import Log
from similitude.noise import SensorNoise, gyro_noise
from similitude.population import Prior
from similitude.prediction import predict_ahead
from similitude.run import (
    Z95,
    Assumed,
    Estimate,
    Group,
    Nuisance,
    Run,
    Trace,
    axle_stiffness,
    held,
    positive_estimate,
)
from similitude.steer_lag import LagScan, find_lag, looks_like_command
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import NAMES, vehicle_prior
from similitude.verdict import evidence, verdict

MEANING = {
    "K": "Caf L/m, front cornering stiffness per mass and length",
    "pi1": "a/L, position of the centre of gravity",
    "eta": "Car b/(Caf a), rear over front cornering coefficient",
    "rho": "Iz/(m a b), yaw inertia ratio",
}
UNITS = {"K": "m^2/s^2", "pi1": "-", "eta": "-", "rho": "-"}
SLOW_PI3 = 10  # beyond this pi3 the tyres do not show, and the filter holds
AT_EDGE = 0.1  # prior sds: a group that was stopped at its limit stays this near to it
SCALE_STEP = 0.05  # of the steer angle, to see what its scale does to K


def identify_population(log: Log, vehicle: Vehicle) -> Run:
    """Run the population filter over a log; see `similitude.identification.identify`."""
    prior = vehicle_prior(vehicle)
    noise = gyro_noise(log.r, vehicle.yaw_rate_noise)
    setup = population_setup(
        log, prior, L=vehicle.L.value, noise_std=noise.std, input_scale_sd=MEASURED_STEER_SD
    )
    scan = find_lag(setup, vehicle)
    commanded = looks_like_command(scan)
    setup = setup.with_lag(scan.chosen, COMMANDED_STEER_SD if commanded else MEASURED_STEER_SD)
    done = setup.run()
    trace = _trace(done, _lag_spread(setup, scan))
    code, reason = verdict(
        evidence(log, trace, prior, noise_scale=done.value("noise_scale"), at_limit=_edges(done))
    )
    K = positive_estimate(trace.K[-1], trace.ln_K_std[-1], "m^2/s^2")
    unknowns = {name: done.value(name) for name in NAMES}
    speed = float(np.median(trace.U[done.used])) if done.used.any() else float(trace.U[-1])
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
            "at_speed": float(_seen_speed(trace.U[-1], prior)),
        },
        groups=_groups(done, prior, K),
        nuisance=_nuisance(done),
        lag=scan,
        prediction=predict_ahead(setup),
        handling=handling(unknowns, done.covariance(list(NAMES)), L=setup.L, U=speed),
        warnings=(*log.warnings, *_warnings(setup, scan, commanded, learnt=code != "not_excited")),
        assumed=_assumed(setup, vehicle, prior, noise, scan, commanded),
        Caf=axle_stiffness(vehicle, K),
    )


def _lag_spread(setup: Setup, scan: LagScan) -> np.ndarray | float:
    """Sd of ln K from the sd of a scanned lag: half the difference of two passes, (n,)."""
    if scan.std == 0:
        return 0.0
    sides = [
        setup.with_lag(max(scan.chosen + sign * scan.std, 0.0), setup.input_scale_sd).run()
        for sign in (1, -1)
    ]
    later, earlier = (np.log(side.output("estimate")) for side in sides)
    return np.abs(later - earlier) / 2


def _trace(done: Pass, lag_spread: np.ndarray | float) -> Trace:
    """Rows of the log; a missing speed is that of the row before."""
    setup = done.setup
    log = setup.log
    U = held(log.U)
    K = done.output("estimate")
    std = np.hypot(np.sqrt(done.output("variance")), lag_spread)
    pi3 = K / _seen_speed(U, setup.prior) ** 2
    predicted = done.output("predicted")
    innovation = np.where(np.isfinite(log.r) & done.used, done.output("innovation"), np.nan)
    return Trace(
        t=log.t,
        K=K,
        ln_K_std=std,
        pi3=pi3,
        pi3_std=pi3 * std,
        r_measured=log.r,
        r_predicted=predicted,
        innovation=innovation,
        innovation_std=np.sqrt(done.output("innovation_variance")),
        information=done.output("information_gained"),
        U=U,
        ay_kinematic=U * predicted,
        status=done.status,
    )


def _seen_speed(U: np.ndarray, prior: Prior) -> np.ndarray:
    """Speed at which pi3 is printed: that of the car, or the least at which it can be seen."""
    return np.maximum(np.abs(U), np.sqrt(prior.mean[0] / SLOW_PI3))


def _edges(done: Pass) -> tuple[str, ...]:
    """Unknowns that the limits of the population, and not the drive, hold where they are.

    K, which the drive is to find, counts as held when its 95 % interval reaches the limit.
    """
    prior, library = done.setup.prior, done.setup.library
    room = AT_EDGE * prior.std
    room[0] = Z95 * np.sqrt(done.covariance(["K"])[0, 0])
    value = np.array([done.value(name) for name in NAMES])
    log = np.array([kind == "log" for kind in prior.kinds])
    held_there = np.zeros(len(NAMES), bool)
    for side in ("low", "high"):
        limit = np.array([done.config[library.index("config", f"{name}_{side}")] for name in NAMES])
        away = np.where(log, np.abs(np.log(value / limit)), np.abs(value - limit))
        held_there |= away <= room
    return tuple(name for name, here in zip(NAMES, held_there, strict=True) if here)


def _groups(done: Pass, prior: Prior, K: Estimate) -> dict[str, Group]:
    """Every unknown at the end of the log; K with what the lag adds to its sd."""
    groups = {}
    std = np.sqrt(np.diag(done.covariance(list(NAMES))))
    for i, name in enumerate(NAMES):
        value = done.value(name)
        scale = prior.mean[i] if prior.kinds[i] == "log" else 1.0
        now = value if prior.kinds[i] == "log" else 1.0
        groups[name] = Group(
            value, now * std[i], float(prior.mean[i]), float(scale * prior.std[i]), MEANING[name]
        )
    groups["K"] = dataclasses.replace(groups["K"], std=K.std)
    return groups


def _nuisance(done: Pass) -> dict[str, Nuisance]:
    names = {
        "yaw_bias": "output_bias",
        "steer_offset": "input_offset",
        "disturbance": "disturbance",
    }
    units = {"yaw_bias": "rad/s", "steer_offset": "rad", "disturbance": "rad"}
    std = np.sqrt(np.diag(done.covariance(list(names.values()))))
    return {
        name: Nuisance(done.value(field), float(s), units[name])
        for (name, field), s in zip(names.items(), std, strict=True)
    }


def _warnings(setup: Setup, scan: LagScan, commanded: bool, *, learnt: bool) -> list[str]:
    lines = []
    if setup.library.why_slow:
        lines.append(f"running the scalar Python twin, {setup.library.why_slow}")
    if commanded:
        lines.append(
            f"the steer acts {1000 * scan.chosen:.0f} ms after its column says so: it looks like a command, "
            "so its scale is taken as uncertain by 20 %; measure the road wheel to do better"
        )
    if learnt:
        slope = _scale_slope(setup)
        lines.append(
            f"K and steer scale trade: were the steer angle 5 % larger than logged, "
            f"K would read {100 * slope:+.0f} %"
        )
    if setup.log.rate < 20:
        lines.append(f"{setup.log.rate:.1f} samples a second are few for yaw dynamics; 50 or more are better")
    return lines


def _scale_slope(setup: Setup) -> float:
    """Relative change of K when the steer angle is scaled up by 5 %."""
    samples = setup.samples()
    ends = []
    for scale in (1.0, 1.0 + SCALE_STEP):
        config = setup.config()
        state = setup.library.start(config)
        setup.library.run(config, state, samples * np.array([1.0, scale, 1.0, 1.0]))
        ends.append(state[setup.library.index("state", "K")])
    return float(ends[1] / ends[0] - 1)


def _assumed(
    setup: Setup, vehicle: Vehicle, prior: Prior, noise: SensorNoise, scan: LagScan, commanded: bool
) -> dict[str, Assumed]:
    stated = vehicle.yaw_rate_noise is not None
    scale = "the steer looks like a command" if commanded else "a measured road-wheel angle"
    lag = {
        "scanned": "scanned: the log speaks for it",
        "assumed": "assumed: the log does not speak for one",
    }
    assumed = {
        name: Assumed(float(prior.mean[i]), UNITS[name], prior.origins[name]) for i, name in enumerate(NAMES)
    }
    return assumed | {
        "population": Assumed(vehicle.population, "-", vehicle.origins.get("population", "default")),
        "L": Assumed(setup.L, "m", vehicle.origins.get("L", "vehicle file")),
        "yaw_rate_noise": Assumed(noise.std, "rad/s", "vehicle file" if stated else "estimated from the log"),
        "steer_lag": Assumed(scan.chosen, "s", lag.get(scan.origin, scan.origin)),
        "steer_scale_std": Assumed(setup.input_scale_sd, "-", scale),
    }
