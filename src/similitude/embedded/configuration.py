"""Numbers of an exported estimator: its configuration, each value with where it came from.

Invariant: nothing is taken silently. What nobody stated is that of a reference car, and is said to be.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.system import READ, Source
from similitude.errors import UsageError
from similitude.program.library import Library

REFERENCE_L = 2.69  # m: a middle-sized car
REFERENCE_NOISE = np.deg2rad(0.15)  # rad/s: an automotive gyro
REFERENCE_TIME = 0.010  # s
REFERENCE_SPEED = 20.0  # m/s: nothing but the weight of the start depends on it
REFERENCE_PLACE = 0.45  # of the wheelbase behind the front axle: on the tunnel between the seats
TIMES = ("s", "1/s")
POPULATION = ("population", "small_population")
ON_TARGET = "reference: state yours with "


@dataclass(frozen=True, eq=False)
class Numbers:
    """The flat configuration (n,), SI units, and where the values that need judgement come from."""

    values: NDArray[np.float64]
    sample_time: float  # s
    assumed: Mapping[str, tuple[float, str, str]]  # name -> value, unit, where from


def find_numbers(source: Source, *, vehicle: Path | None, sample_time: float | None) -> Numbers:
    """The configuration of an estimator.

    Parameters
    ----------
    source : the estimator; a user's carries its own CONFIG.
    vehicle : a vehicle file, for a shipped system.
    sample_time : of the firmware's loop [s].

    Raises
    ------
    UsageError      a user's file leaves values open, or a vehicle file was given for it.
    VehicleError    the vehicle file cannot be used.
    """
    if source.numbers is not None:
        return _held(source, vehicle, sample_time)
    library = source.library()
    if source.stated is not None:
        return _stated(source, library, vehicle, sample_time)
    return _shipped(source, library, vehicle, sample_time)


def _held(source: Source, vehicle: Path | None, sample_time: float | None) -> Numbers:
    """The numbers of an estimator that a file holds; they are for its own sample time."""
    own: Numbers = source.numbers
    if vehicle is None and sample_time in (None, own.sample_time):
        return own
    given = f"--vehicle '{vehicle}'" if vehicle is not None else f"--sample-time {sample_time:g} s"
    raise UsageError(
        f"{given} was given for {source.system}, whose estimator has its own numbers at "
        f"{own.sample_time:g} s",
        usually="the estimator was made for another sample time: make it anew in the file.",
        paste=f"make_estimator(..., step='{1000 * (sample_time or own.sample_time):g} ms')",
        read=READ,
    )


def _shipped(source: Source, library: Library, path: Path | None, sample_time: float | None) -> Numbers:
    from similitude.vehicle_file import read_vehicle
    from similitude.vehicle_prior import vehicle_prior, wheelbase

    car = read_vehicle(path) if path is not None else reference_car()
    L, step = wheelbase(car), sample_time or REFERENCE_TIME
    noise = car.yaw_rate_noise.value if car.yaw_rate_noise is not None else REFERENCE_NOISE
    prior = vehicle_prior(car)
    from_file = f"{ON_TARGET}--vehicle FILE.toml"
    assumed = {
        "L": (L, "m", car.origins.get("L", from_file)),
        "yaw_rate_noise": (
            noise,
            "rad/s",
            car.origins.get("yaw_rate_noise", f"{ON_TARGET}yaw_rate_noise in the vehicle file"),
        ),
        "sample_time": (step, "s", "--sample-time" if sample_time else f"{ON_TARGET}--sample-time"),
    }
    if source.estimator == "paper":
        from similitude.estimators.paper_design import PAPER_GROUPS, SOURCE

        assumed |= {name: (value, "-", SOURCE) for name, value in PAPER_GROUPS.items()}
    if source.estimator != "monitor":
        assumed["K"] = (float(prior.mean[0]), "m^2/s^2", prior.origins["K"])
    meter = _accelerometer(car, L, library, assumed)
    values = _values(source.estimator, library, prior, step, L, noise, meter)
    return Numbers(values, step, assumed)


def _accelerometer(car: Any, L: float, library: Library, assumed: dict[str, Any]) -> Any:
    """The accelerometer of a filter that takes lateral acceleration; what is taken for it is assumed."""
    if "ay_limit" not in library.names("config"):
        return None
    from similitude.accelerometer import BEHIND_SD, QUIETEST, Accelerometer

    place = car.accelerometer
    behind = REFERENCE_PLACE * L if place is None else place.value
    sd = BEHIND_SD if place is None or place.sd is None else place.sd
    state_it = f"{ON_TARGET}accelerometer in the vehicle file"
    assumed["accelerometer"] = (behind, "m", car.origins.get("accelerometer", state_it))
    assumed["ay_noise"] = (QUIETEST, "m/s^2", f"{ON_TARGET}ay_variance; the filter learns its own")
    return Accelerometer(behind, sd, QUIETEST)


def reference_car() -> Any:
    """A car of which only the wheelbase is known, taken where no vehicle file is given."""
    from similitude.units import Uncertain
    from similitude.vehicle_file import Vehicle

    return Vehicle(name="reference car", L=Uncertain(REFERENCE_L, None, "m"))


def _values(
    estimator: str, library: Library, prior: Any, step: float, L: float, noise: float, meter: Any
) -> NDArray:
    if estimator in POPULATION:
        from similitude.filter_config import MEASURED_STEER_SD, filter_config

        return filter_config(
            library,
            prior,
            L=L,
            noise_std=noise,
            input_scale_sd=MEASURED_STEER_SD,
            accelerometer=meter,
        )
    if estimator == "monitor":
        from similitude.monitor_config import monitor_config

        return monitor_config(library, L=L)
    if estimator == "paper":
        from similitude.estimators.paper_design import PAPER_GROUPS, paper_config

        K = float(prior.mean[0])
        place = {"sample_time": step, "L": L, "speed": REFERENCE_SPEED, "noise_std": noise, "K_start": K}
        return paper_config(library, **place, **PAPER_GROUPS)
    if estimator == "scalar_population":
        from similitude.estimators.scalar_design import scalar_config

        return scalar_config(library, prior, sample_time=step, L=L, noise_std=noise)
    from similitude.estimators.ladder_design import ladder_config

    return ladder_config(library, prior, sample_time=step, L=L, noise_std=noise)


def _stated(source: Source, library: Library, vehicle: Path | None, sample_time: float | None) -> Numbers:
    """What CONFIG states over the estimator's design constants; all other fields must be stated."""
    if vehicle is not None:
        raise UsageError(
            f"--vehicle '{vehicle}' was given for {source.system}, which states its own numbers",
            usually="a shipped system was meant, or the file's CONFIG was forgotten.",
            paste='CONFIG = {"noise_variance": 1e-6}   # in ' + source.system,
            read=READ,
        )
    units = {row[0]: row[1] for row in library.layout.CONFIG}
    stated = dict(source.stated or {})
    step = sample_time or float(stated.get("sample_time", 0.0)) or REFERENCE_TIME
    own = _constants(source.estimator, step)
    constants = {n: v for n, v in own.items() if units.get(n) in ("-", *TIMES) and n not in stated}
    values = {**constants, **{n: v for n, v in stated.items() if n in units or n != "sample_time"}}
    if "longest" in units and "longest" not in values:
        from similitude.filter_config import longest

        values["longest"] = longest(values)
    missing = [row for row in library.layout.CONFIG if row[0] not in values]
    if missing:
        lines = "\n".join(
            f"      {n!r}: {'[' + ', '.join(['...'] * s) + ']' if s > 1 else '...'},  # [{u}] {m}"
            for n, u, m, s in missing
        )
        raise UsageError(
            f"{source.system} leaves {len(missing)} numbers of {source.name} open; CONFIG lacks\n{lines}",
            usually="the model and its unknowns are written and its prior, sensors and limits are not yet.",
            paste="CONFIG = {" + f"{missing[0][0]!r}: ..." + "}   # in " + f"{source.system}, SI units",
            read=READ,
        )
    given = "--sample-time" if sample_time else source.system if "sample_time" in stated else ""
    assumed = {"sample_time": (step, "s", given or f"{ON_TARGET}--sample-time")}
    for name, value in constants.items():
        if units[name] in TIMES and name not in ("sample_time", "dt_low", "dt_high"):
            assumed[name] = (float(value), units[name], f"that of a car: state yours in {source.system}")
    return Numbers(library.config(values), step, assumed)


def _constants(estimator: str, step: float) -> dict[str, Any]:
    """Design constants that do not depend on what is identified; those of the car's estimators."""
    if estimator in POPULATION:
        from similitude.filter_config import DESIGN

        return {
            name: value
            for name, value in DESIGN.items()
            if not name.endswith(("_star_sd", "_limit")) or name == "surprise_limit"
        }
    if estimator == "monitor":
        from similitude.monitor_config import DESIGN as MONITOR
        from similitude.monitor_config import RISE_MORE, THRESHOLD

        own = {n: v for n, v in MONITOR.items() if not n.endswith(("_star_sd", "_limit"))}
        return {**own, "threshold_fall": THRESHOLD, "threshold_rise": THRESHOLD + RISE_MORE}
    timed = {"sample_time": step, "dt_low": 0.5 * step, "dt_high": 1.5 * step}
    if estimator == "paper":
        from similitude.estimators.paper_design import DESIGN as PAPER
        from similitude.estimators.paper_design import bessel_biquads, section_poles

        sections = bessel_biquads(step)
        own = {n: PAPER[n] for n in ("forgetting", "variance_limit")}
        own["dt_room"] = 0.5 * step
        own |= {f"biquad_{i}": row for i, row in enumerate(sections, 1)}  # of the fixed-point profile
        return {**own, **timed, **{f"poles_{i}": section_poles(row) for i, row in enumerate(sections, 1)}}
    return timed
