"""What every estimator on the population's prior needs of a log: setup, lag, whole-log fit, what was assumed.

Invariant: the estimators differ in what they do with a setup, never in how it was made.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from similitude.batch_fit import BatchFit, fit_batch
from similitude.batch_pass import COMMANDED_LAG, FrozenFilter, batch_prior
from similitude.filter_config import COMMANDED_STEER_SD, DESIGN, MEASURED_STEER_SD
from similitude.filter_run import LINEAR, POPULATION, Pass, Setup, population_setup
from similitude.log import Log
from similitude.noise import SensorNoise, gyro_noise
from similitude.population import Prior
from similitude.program.library import shipped
from similitude.run import Z95, Assumed, Batch, Group, positive_estimate
from similitude.servo import Servo
from similitude.slow_bus import held_columns, new_readings, without_lines, without_repeats
from similitude.steer_lag import COMMAND, MEASURED_LAG, LagScan, find_lag, is_command
from similitude.steer_servo import find_servo
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import NAMES, ONE_DRIVE, vehicle_prior

MEANING = {
    "K": "Caf L/m, front cornering stiffness per mass and length",
    "pi1": "a/L, position of the centre of gravity",
    "eta": "Car b/(Caf a), rear over front cornering coefficient",
    "rho": "Iz/(m a b), yaw inertia ratio",
}
UNITS = {"K": "m^2/s^2", "pi1": "-", "eta": "-", "rho": "-"}
TWO_CLOCKS = 0.15  # s: few commands act so late
SLOW_PI3 = 10  # beyond this pi3 the tyres do not show, and the filter holds
AT_EDGE = 0.1  # prior sds: a group that was stopped at its limit stays this near to it
SCALE_CHANGE = 0.05  # of the steer angle, to say what its scale does to K
WORTH_SAYING = 0.01  # of K
MOSTLY = 0.75  # of the prior variance gone: half its sd
FROM_STATE = "state file"
LIMIT_DRIVE = 0.1  # of the rows
APART = 3.0  # sd between the halves of a log: one log in 400 by chance


@dataclass(frozen=True, eq=False)
class Prepared:
    """A log ready for the population's estimators; ``setup`` holds the lag and the steer scale's sd."""

    vehicle: Vehicle
    prior: Prior
    noise: SensorNoise
    setup: Setup
    scan: LagScan
    commanded: bool
    held: Mapping[str, int]  # columns of a slow bus: rows for which each reading is repeated


def prepare(log: Log, vehicle: Vehicle, settings: Mapping[str, float] | None = None) -> Prepared:
    """Prior, noise, steer lag and steer scale of a log; ``settings`` are those of the drives before it."""
    prior = vehicle_prior(vehicle)
    log = without_lines(log)
    held = held_columns(log)
    if settings is not None:
        return _as_before(without_repeats(log, held), vehicle, prior, settings, held)
    noise = gyro_noise(log.r[new_readings(log.r, held.get("r", 1))], vehicle.yaw_rate_noise)
    known = {"L": vehicle.L.value, "noise_std": noise.std, "input_scale_sd": MEASURED_STEER_SD}
    setup = population_setup(without_repeats(log, held), prior, **known)
    scan = find_lag(setup, vehicle)
    if is_command(scan, vehicle):
        return _of_command(Prepared(vehicle, prior, noise, setup, scan, True, held))
    return Prepared(vehicle, prior, noise, setup.with_lag(scan.chosen, MEASURED_STEER_SD), scan, False, held)


def _of_command(ready: Prepared) -> Prepared:
    """The same with the servo that the log of a command speaks for, and the sd of a command's scale."""
    setup, scan = ready.setup, ready.scan
    if ready.vehicle.steer_lag is None:
        scan = find_servo(setup.with_lag(0.0, MEASURED_STEER_SD), scan)
    setup = setup.with_lag(scan.chosen, COMMANDED_STEER_SD).with_servo(scan.servo)
    return replace(ready, setup=setup, scan=scan, commanded=True)


def _as_before(
    log: Log, vehicle: Vehicle, prior: Prior, settings: Mapping[str, float], held: Mapping[str, int]
) -> Prepared:
    noise = SensorNoise(settings["yaw_rate_noise"], fresh=1.0, step=0.0)
    scale, lag = settings["steer_scale_std"], settings["steer_lag"]
    servo = Servo(settings.get("steer_servo", 0.0), settings.get("steer_servo_slew", np.inf))
    setup = population_setup(log, prior, L=vehicle.L.value, noise_std=noise.std, input_scale_sd=scale)
    scan = LagScan(np.empty(0), np.empty(0), lag, FROM_STATE, servo=servo)
    setup = setup.with_lag(lag, scale).with_servo(servo)
    return Prepared(vehicle, prior, noise, setup, scan, is_command(scan, vehicle), held)


def with_whole_log(ready: Prepared) -> tuple[Prepared, BatchFit]:
    """A log ready for the filter once its whole-log fit has been asked for the lag, and that fit.

    A steer that acts later than a measured wheel can is a command, and is fitted as one.
    """
    batch = whole_log(ready, ready.setup.run())
    fitted = with_fitted_lag(ready, batch)
    if fitted.setup.lag < COMMAND or fitted is ready or ready.vehicle.steer is not None:
        return fitted, batch
    ready = _of_command(fitted)
    return ready, whole_log(ready, ready.setup.run())


def whole_log(ready: Prepared, done: Pass) -> BatchFit:
    """The batch fit, started where a pass of the population filter ended."""
    lag = ready.vehicle.steer_lag or (COMMANDED_LAG if ready.commanded else MEASURED_LAG)
    prior = batch_prior(ready.prior, steer_scale_sd=ready.setup.input_scale_sd, lag=lag)
    frozen = FrozenFilter(replace(ready.setup, library=shipped(_tyres(ready.setup.log))), prior)
    scanned = ready.scan.chosen if ready.scan.origin == "scanned" else lag.value
    start = np.array([*(done.value(name) for name in NAMES), 1.0, scanned])
    scales = np.log([done.value("noise_scale"), done.value("disturbance_scale")])
    return fit_batch(frozen, frozen.coordinates(start), scales)


def _tyres(log: Log) -> str:
    """The program of the whole-log fit: tyres that saturate where much was driven beyond the linear range.

    Elsewhere their grip, which the fit takes as known, would have a say in K for nothing.
    """
    beyond = np.abs(log.U * log.r) > DESIGN["validity_limit"]
    return POPULATION if np.mean(beyond) > LIMIT_DRIVE else LINEAR


def with_fitted_lag(ready: Prepared, batch: BatchFit | None) -> Prepared:
    """The same with the lag of the whole-log fit, where the steer is a measured angle.

    A recursive pass makes up for 20 ms at town speeds by a K that is a fifth too low, and then its
    innovations speak against the lag; the fit holds K, scale and lag together. A lag that was stated
    stays, and that of the scan for a command, or where there is no fit or it did not come to rest.
    """
    if batch is None or not batch.settled or ready.commanded or ready.vehicle.steer_lag is not None:
        return ready
    lag = round(batch.values["steer_lag"], 4)  # a tenth of a millisecond: below it the fit's rounding shows
    scan = replace(ready.scan, chosen=lag, std=batch.lag_std, origin="fitted")
    setup = ready.setup.with_lag(lag, ready.setup.input_scale_sd)
    return replace(ready, scan=scan, setup=setup)


def reported(batch: BatchFit, behind_servos: float = 0.0) -> Batch:
    """What a report says of a batch fit; ``behind_servos`` is the sd of ln K from the servo of a command."""
    names = ("pi1", "eta", "rho", "steer_scale", "steer_lag")
    return Batch(
        K=positive_estimate(batch.values["K"], float(np.hypot(batch.std[0], behind_servos)), UNITS["K"]),
        correlation={name: batch.correlation(name) for name in names},
        widened=batch.widened,
        halves={
            "first": float(np.exp(batch.halves.first)),
            "second": float(np.exp(batch.halves.second)),
            "apart_sd": batch.halves.apart,
        },
    )


def seen_speed(U: NDArray[np.float64] | float, prior: Prior) -> NDArray[np.float64]:
    """Speed at which pi3 is printed: that of the car, or the least at which it can be seen."""
    return np.maximum(np.abs(U), np.sqrt(prior.mean[0] / SLOW_PI3))


def held_by_limits(
    x: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64], prior: Prior, ln_K_std: float
) -> tuple[str, ...]:
    """Unknowns that the limits of the population, and not the drive, hold where they are.

    K, which the drive is to find, counts as held when its 95 % interval reaches the limit.
    All are coordinates, (4,).
    """
    room = AT_EDGE * prior.std
    room[0] = Z95 * ln_K_std
    here = np.minimum(np.abs(x - low), np.abs(high - x)) <= room
    return tuple(name for name, held in zip(NAMES, here, strict=True) if held)


def edges(done: Pass) -> tuple[str, ...]:
    """Unknowns at the end of a pass that the limits of the population hold where they are."""
    prior, library = done.setup.prior, done.setup.library
    low, high = (
        prior.coordinates(
            np.array([done.config[library.index("config", f"{name}_{side}")] for name in NAMES])
        )
        for side in ("low", "high")
    )
    x = prior.coordinates(np.array([done.value(name) for name in NAMES]))
    return held_by_limits(x, low, high, prior, float(np.sqrt(done.output("variance")[-1])))


def group_table(values: dict[str, float], std: NDArray[np.float64], prior: Prior) -> dict[str, Group]:
    """Every unknown beside what the population said; ``std`` (4,) of the coordinates.

    All but K keep half the population's spread at least: what the model lacks looks like them.
    """
    std = np.concatenate([std[:1], np.maximum(std[1:], ONE_DRIVE * prior.std[1:])])
    groups = {}
    for i, name in enumerate(NAMES):
        is_log = prior.kinds[i] == "log"
        before, now = float(prior.mean[i]), values[name]
        groups[name] = Group(
            now,
            float((now if is_log else 1.0) * std[i]),
            before,
            float((before if is_log else 1.0) * prior.std[i]),
            MEANING[name],
        )
    return groups


def warnings_of(ready: Prepared, batch: BatchFit | None, *, learnt: bool) -> list[str]:
    """What a reader should know before the number, in the order of weight."""
    setup, scan, lines = ready.setup, ready.scan, []
    if setup.library.why_slow:
        left_out = "" if batch else "; the fit of the whole log is left out"
        lines.append(f"running the scalar Python twin, {setup.library.why_slow}{left_out}")
    if ready.commanded:
        lines.append(
            f"the steer acts {1000 * scan.total:.0f} ms after its column says so: "
            f"{'it looks like' if ready.vehicle.steer is None else 'it is'} a command, "
            "so its scale is taken as uncertain by 20 %; measure the road wheel to do better"
            + (" (or steer and yaw rate were logged by two clocks)" if scan.total > TWO_CLOCKS else "")
        )
    if scan.early:
        lines.append(
            f"the yaw rate comes about {1000 * scan.early:.0f} ms before the steer that should cause it, as "
            "no car's does: steer and yaw rate were logged by two clocks, and K is wrong; move the steer "
            f"{scan.early:g} s to earlier times and identify again"
        )
    if batch and learnt:
        lines += _of_the_fit(batch)
    if setup.log.rate < 20:
        lines.append(f"{setup.log.rate:.1f} samples a second are few for yaw dynamics; 50 or more are better")
    return lines


def _of_the_fit(batch: BatchFit) -> list[str]:
    lines = _of_the_steer_scale(batch)
    halves = batch.halves
    if halves.apart > APART:
        lines.append(
            f"the first half of the log reads K about {np.exp(halves.first):.3g} m^2/s^2, the second about "
            f"{np.exp(halves.second):.3g}, {halves.apart:.1f} sd apart: the stiffness changed on the way "
            "(tyres, road, load, or corners beyond 0.3 g), and one number for the whole log is an average; "
            "the population filter follows it, and its K is that of the end"
        )
    if not batch.settled:
        lines.append("the fit of the whole log did not come to rest; take its K as a rough guide")
    return lines


def _of_the_steer_scale(batch: BatchFit) -> list[str]:
    """By how much a steer angle logged too small makes K read wrong; nothing where it does not."""
    if batch.told("steer_scale") > MOSTLY:
        spread = batch.std[batch.frozen.prior.names.index("steer_scale")]
        return [
            f"K and steer scale trade, but this drive tells the scale itself to ± {100 * spread:.2g} %, "
            f"{100 * (batch.values['steer_scale'] - 1):+.2g} % against the log; a wrong one moves K little"
        ]
    change = np.expm1(batch.leans("steer_scale") * np.log1p(SCALE_CHANGE))
    if abs(change) < WORTH_SAYING:
        return []
    return [
        f"K and steer scale trade: were the steer angle {100 * SCALE_CHANGE:.0f} % larger than logged, "
        f"K would read {100 * change:+.0f} % (correlation {batch.correlation('steer_scale'):+.2f}; "
        f"with the steer lag {batch.correlation('steer_lag'):+.2f})"
    ]


def assumed_of(ready: Prepared) -> dict[str, Assumed]:
    """Every number that was not in the log, with where it came from."""
    vehicle, prior, scan = ready.vehicle, ready.prior, ready.scan
    stated = vehicle.yaw_rate_noise is not None
    looks = "looks like" if vehicle.steer is None else "is"
    scale = f"the steer {looks} a command" if ready.commanded else "a measured road-wheel angle"
    lag = {
        "fitted": "fitted to the whole log",
        "scanned": "scanned: the log speaks for it",
        "assumed": "assumed, as measured angles have it: the log does not speak for another",
    }
    assumed = {
        name: Assumed(float(prior.mean[i]), UNITS[name], prior.origins[name]) for i, name in enumerate(NAMES)
    }
    rate = ready.setup.log.rate
    for name, rows in ready.held.items():
        origin = f"{name} repeats each reading for {rows} rows, as a slow bus does; repeats do not count"
        assumed[f"{name}_rate"] = Assumed(rate / rows, "Hz", origin)
    return assumed | {
        "population": Assumed(vehicle.population, "-", vehicle.origins.get("population", "default")),
        "L": Assumed(ready.setup.L, "m", vehicle.origins.get("L", "vehicle file")),
        "yaw_rate_noise": Assumed(
            ready.noise.std, "rad/s", "vehicle file" if stated else _noise_origin(scan)
        ),
        "steer_lag": Assumed(scan.chosen, "s", lag.get(scan.origin, scan.origin)),
        **_of_the_servo(scan),
        "steer_scale_std": Assumed(ready.setup.input_scale_sd, "-", scale),
    }


def _of_the_servo(scan: LagScan) -> dict[str, Assumed]:
    origin = FROM_STATE if scan.origin == FROM_STATE else "scanned: the log and what is usual"
    found = {} if scan.servo.is_none else {"steer_servo": Assumed(scan.servo.constant, "s", origin)}
    if np.isfinite(scan.servo.slew):
        found["steer_servo_slew"] = Assumed(scan.servo.slew, "rad/s", origin)
    return found


def average_lag(ready: Prepared) -> float:
    """Steer lag [s] of the average vehicle, of which nothing was learnt from the log."""
    if ready.vehicle.steer_lag is not None:
        return ready.vehicle.steer_lag.value
    return (COMMANDED_LAG if ready.commanded else MEASURED_LAG).value


def _noise_origin(scan: LagScan) -> str:
    return FROM_STATE if scan.origin == FROM_STATE else "estimated from the log"
