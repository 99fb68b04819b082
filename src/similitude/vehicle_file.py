"""The vehicle file: what is known about one car, each value with its unit and its origin.

Invariant: every value of a `Vehicle` was stated in the file or follows from two that were, and
`origins` says which; a key that is not known or a value that cannot be is refused, never dropped.
"""

from __future__ import annotations

import dataclasses
import difflib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from similitude.errors import VehicleError, shown
from similitude.units import Uncertain
from similitude.vehicle_checks import POPULATIONS, Fault, find_fault
from similitude.vehicle_values import (
    KEYS,
    READ,
    SENSOR_KEYS,
    line_of,
    read_document,
    read_values,
    unknown_key,
)

DEFAULT_POPULATION = "passenger_cars"
STEERS = ("measured", "command")  # the angle of the road wheels, or what a servo was told

NEW_VEHICLE = """\
# What is known about the car. Only L is needed (or a and b); every further line narrows the
# answer. Values carry their unit, and their standard deviation where you know one:
#   m = "1650 ± 50 kg"    or    m = { value = "1650 kg", sd = "50 kg" }
# Take the leading "# " away from the lines you can fill in.

name = "my car"
L = "2.69 m"                        # wheelbase

# a = "1.19 m"                      # centre of gravity to the front axle
# b = "1.50 m"                      # centre of gravity to the rear axle; a + b = L
# m = "1650 ± 50 kg"                # mass as driven
# Iz = "3000 kg m^2"                # yaw inertia about the centre of gravity
# Caf = "95000 N/rad"               # cornering stiffness, both front tyres together
# Car = "110000 N/rad"              # cornering stiffness, both rear tyres together
# steering_ratio = 15.3             # steering wheel angle over road wheel angle
# steer_lag = "20 ms"               # from the logged steer to the road wheels
# steer = "command"                 # the logged steer is what a servo was told; or "measured"
population = "passenger_cars"       # what similar cars are like; or "light_trucks", "all_vehicles",
                                    # "small_cars_1to10", "brennan_2004"

# [sensor]
# yaw_rate_noise = "0.15 deg/s"     # standard deviation of the gyro's noise
# accelerometer = "1.3 ± 0.05 m"    # its place behind the front axle; with it the log's ay is used
"""


@dataclass(frozen=True)
class Vehicle:
    """What is known about one car; None where nobody stated it.

    Parameters
    ----------
    name : str                          as the user calls it
    L, a, b : Uncertain or None         wheelbase, front and rear axle to the centre of gravity [m]
    m : Uncertain or None               mass [kg]
    Iz : Uncertain or None              yaw inertia [kg m^2]
    Caf, Car : Uncertain or None        cornering stiffness of the front and rear axle [N/rad]
    steering_ratio : Uncertain or None  steering wheel angle over road wheel angle [-]
    steer_lag : Uncertain or None       from logged steer to road wheels [s]
    steer : str or None                 what the log's steer is: one of `STEERS`
    yaw_rate_noise : Uncertain or None  standard deviation of the yaw rate's noise [rad/s]
    accelerometer : Uncertain or None   its place behind the front axle [m]
    population : str                    one of `similitude.populations.shipped.shipped_names`
    origins : dict of str to str        where each value that is not None comes from
    """

    name: str
    L: Uncertain | None = None
    a: Uncertain | None = None
    b: Uncertain | None = None
    m: Uncertain | None = None
    Iz: Uncertain | None = None
    Caf: Uncertain | None = None
    Car: Uncertain | None = None
    steering_ratio: Uncertain | None = None
    steer_lag: Uncertain | None = None
    yaw_rate_noise: Uncertain | None = None
    accelerometer: Uncertain | None = None
    steer: str | None = None
    population: str = DEFAULT_POPULATION
    origins: dict[str, str] = field(default_factory=dict)


def read_vehicle(path: str | Path) -> Vehicle:
    """Read a vehicle file, strictly.

    Parameters
    ----------
    path : str or Path   a TOML file; `NEW_VEHICLE` is a commented one

    Returns
    -------
    Vehicle              SI values; L, a and b completed from each other where two are known

    Raises
    ------
    VehicleError
        The file cannot be read; a key is not known; a value has no unit, the wrong one, or
        cannot be (b < 0, L other than a + b, a mass in tonnes, ...); neither L nor a and b.
    """
    path = Path(path)
    document, text = read_document(path)
    source = f"vehicle file {path.name}"
    sensor = document.pop("sensor", {})
    if not isinstance(sensor, Mapping):
        raise unknown_key(path, "sensor", SENSOR_KEYS, text)
    name = document.pop("name", path.stem)
    population, steer = document.pop("population", None), document.pop("steer", None)
    values = read_values(path, document, KEYS, text) | read_values(path, sensor, SENSOR_KEYS, text)
    origins = dict.fromkeys(values, source)
    _check_words(path, name, {"population": (population, POPULATIONS), "steer": (steer, STEERS)}, text)
    if steer:
        origins["steer"] = source
    origins["population"] = source if population else "assumed: population not named in the file"
    population = population or DEFAULT_POPULATION
    fault = find_fault(values, population=population)
    if fault is not None:
        raise _impossible(path, fault, text)
    _complete_lengths(values, origins)
    if "L" not in values:
        raise VehicleError(
            f"{path.name} has no wheelbase: neither 'L' nor both 'a' and 'b'",
            usually="the line is still missing; the wheelbase sets the scale of everything.",
            paste='L = "2.69 m"',
            read=READ,
        )
    return Vehicle(name=name, population=population, steer=steer, origins=origins, **values)


def _check_words(
    path: Path, name: object, chosen: Mapping[str, tuple[object, Iterable[str]]], text: str
) -> None:
    """Refuse a name that is no text, and a word that is none of those to choose from."""
    if not isinstance(name, str):
        raise VehicleError(
            f"{path.name}{line_of('name', text)}: name = {shown(name)} is not text",
            usually="the quotes are missing.",
            paste=f'name = "{name if isinstance(name, (int, float)) else "my car"}"',
            read=READ,
        )
    for key, (word, words) in chosen.items():
        if word is None or (isinstance(word, str) and word in words):
            continue
        near = difflib.get_close_matches(str(word), words, n=1, cutoff=0.0)
        raise VehicleError(
            f"{path.name}{line_of(key, text)}: {key} {shown(word)} is not "
            f"known; there are {', '.join(map(repr, words))}",
            usually="it is a matter of spelling.",
            paste=f'{key} = "{near[0]}"',
            read=READ,
        )


def _impossible(path: Path, fault: Fault, text: str) -> VehicleError:
    return VehicleError(
        f"{path.name}{line_of(fault.key, text)}: {fault.what}",
        usually=fault.usually,
        paste=fault.paste,
        read=READ,
    )


def _complete_lengths(values: dict[str, Uncertain], origins: dict[str, str]) -> None:
    have = values.keys() & {"L", "a", "b"}
    if have == {"a", "b"}:
        values["L"], origins["L"] = _sum(values["a"], values["b"], sign=1), "a + b"
    elif have == {"L", "a"}:
        values["b"], origins["b"] = _sum(values["L"], values["a"], sign=-1), "L - a"
    elif have == {"L", "b"}:
        values["a"], origins["a"] = _sum(values["L"], values["b"], sign=-1), "L - b"


def _sum(first: Uncertain, second: Uncertain, *, sign: int) -> Uncertain:
    known = [held.sd for held in (first, second) if held.sd is not None]
    # Independent measurements; one without a stated deviation adds none.
    sd = sum(one**2 for one in known) ** 0.5 if known else None
    return dataclasses.replace(first, value=first.value + sign * second.value, sd=sd)
