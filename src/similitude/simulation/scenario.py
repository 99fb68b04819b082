"""A scenario: which car on which road, how it is driven, and what its logger sees.

Invariant: every value was stated in the file, or is a default that means "nothing of that kind";
the parts have been checked against each other.
"""

from __future__ import annotations

import copy
import difflib
import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib import resources
from pathlib import Path as FilePath
from typing import Any

import numpy as np

from similitude.errors import ScenarioError, UsageError, shown
from similitude.simulation.actuator import Actuator
from similitude.simulation.foreign import LARGEST_STEP
from similitude.simulation.keys import READ, Place, read_kind, read_table, refuse
from similitude.simulation.lqr import Lqr
from similitude.simulation.manoeuvres import FromLog
from similitude.simulation.road import Road
from similitude.simulation.sections import DRIVERS, PLANTS, Commonroad, Timing, TwoTrackKeys
from similitude.simulation.sensors import Sensors
from similitude.simulation.speed import SPEEDS, Logged
from similitude.simulation.stated_vehicle import StatedVehicle, read_stated_vehicle

_NOTHING: Mapping[str, str] = {}


SECTIONS = ("run", "vehicle", "told", "plant", "speed", "driver", "actuator", "sensors", "road")


@dataclass(frozen=True)
class Scenario:
    """A scenario, read and checked.

    Parameters
    ----------
    name, title, about : str    name of the file without its end; one line; a paragraph
    folder : Path               where files that it names are looked for
    timing : Timing
    vehicle : StatedVehicle     what the car is, and what its vehicle file will tell
    plant, speed, driver        dataclasses of `PLANTS`, `SPEEDS`, `DRIVERS`
    actuator : Actuator
    sensors : Sensors
    road : Road
    """

    name: str
    title: str
    about: str
    folder: FilePath
    timing: Timing
    vehicle: StatedVehicle
    plant: Any
    speed: Any
    driver: Any
    actuator: Actuator
    sensors: Sensors
    road: Road


def shipped() -> dict[str, FilePath]:
    """Return the scenario files that come with the package, by name."""
    folder = FilePath(str(resources.files("similitude") / "scenarios"))
    return {path.stem: path for path in sorted(folder.glob("*.toml"))}


def read_scenario(named: str | FilePath, *, changes: Mapping[str, str] = _NOTHING) -> Scenario:
    """Read a scenario, strictly.

    Parameters
    ----------
    named : str or Path   a shipped scenario's name, or the path of a TOML file
    changes : mapping     dotted keys to values that replace those of the file, values as in TOML
                          or as text with a unit: ``{"sensors.r.noise": "0.1 deg/s"}``

    Returns
    -------
    Scenario

    Raises
    ------
    UsageError      there is no such scenario
    ScenarioError   the file cannot be read; a key is not known or missing; a value cannot be; parts
                    do not fit together
    VehicleError    a value of [vehicle] cannot be
    """
    path = find_scenario(named)
    text = _text(path)
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ScenarioError(
            f"{path.name} is not TOML: {error}",
            usually="a value stands without quotes, or a key is written twice.",
            paste='duration = "60 s"',
            read=READ,
        ) from None
    return _scenario(path, text, _changed(document, changes))


def find_scenario(named: str | FilePath) -> FilePath:
    """Return the file of a scenario.

    Parameters
    ----------
    named : str or Path   a shipped scenario's name, or a path

    Raises
    ------
    UsageError   there is none
    """
    known, path = shipped(), FilePath(named)
    if str(named) in known:
        return known[str(named)]
    if path.is_file():
        return path
    near = difflib.get_close_matches(path.stem, known, n=1, cutoff=0.0)
    raise UsageError(
        f"there is no scenario {shown(named)}: neither a file nor one of {', '.join(known)}",
        usually="the name is misspelled, or the path is that of another folder.",
        paste=f"similitude simulate {near[0] if near else '--list'}",
        read='docs/simulate.md, "The command"',
    )


def _text(path: FilePath) -> str:
    try:
        return path.read_bytes().decode("utf-8-sig").replace("\r\n", "\n")
    except (OSError, UnicodeDecodeError) as error:
        raise ScenarioError(
            f"scenario file {path.name} cannot be read: {error}",
            usually="it is no text in UTF-8, or belongs to somebody else.",
            paste="similitude simulate slalom --show > mine.toml",
            read=READ,
        ) from None


def _changed(document: dict, changes: Mapping[str, str]) -> dict:
    document = copy.deepcopy(document)
    for dotted, value in changes.items():
        *sections, name = dotted.split(".")
        inside = document
        for section in sections:
            inside = inside.setdefault(section, {})
            if not isinstance(inside, dict):
                raise UsageError(
                    f"'{dotted}' = {shown(value)} leads through '{section}', which is no single table",
                    usually="a list of tables, such as road.surface, is changed in a file of your own.",
                    paste="similitude simulate slalom --show > mine.toml",
                    read='docs/simulate.md, "The command"',
                )
        inside[name] = _as_toml(value)
    return document


def _as_toml(value: Any) -> Any:
    """A value as TOML would read it, text where that fails: 0.5, true, [1, 2], 2 m/s."""
    if not isinstance(value, str):
        return value
    try:
        return tomllib.loads(f"value = {value}")["value"]
    except tomllib.TOMLDecodeError:
        return value


def _scenario(path: FilePath, text: str, document: dict) -> Scenario:
    place = Place(path.name, text)
    head = {"title": "", "about": ""}
    for name, value in document.items():
        if name in head and isinstance(value, str):
            head[name] = value.strip()
        elif name not in SECTIONS:
            near = difflib.get_close_matches(name, [*SECTIONS, *head], n=1, cutoff=0.0)[0]
            refuse(
                place, name, f"{shown(name)} is not known, or is not what it should be",
                usually=f"it is a matter of spelling; sections are {', '.join(SECTIONS)}.",
                paste=f"[{near}]" if near in SECTIONS else f'{near} = "..."',
            )  # fmt: skip
    for name in ("run", "plant", "speed", "driver"):
        if name not in document:
            refuse(
                place, "", f"section [{name}] is missing", paste=f"[{name}]",
                usually="it was left out; `similitude simulate slalom --show` prints a whole one.",
            )  # fmt: skip
    plant = read_kind(PLANTS, document["plant"], place.within("plant"))
    scenario = Scenario(
        name=path.stem,
        title=head["title"],
        about=head["about"],
        folder=path.parent,
        timing=read_table(Timing, document["run"], place.within("run")),
        vehicle=read_stated_vehicle(
            document.get("vehicle", {}), document.get("told", {}), plant, path=path, text=text
        ),
        plant=plant,
        speed=read_kind(SPEEDS, document["speed"], place.within("speed")),
        driver=read_kind(DRIVERS, document["driver"], place.within("driver")),
        actuator=read_table(Actuator, document.get("actuator", {}), place.within("actuator")),
        sensors=read_table(Sensors, document.get("sensors", {}), place.within("sensors")),
        road=read_table(Road, document.get("road", {}), place.within("road")),
    )
    _check(scenario, place)
    return _with_log(scenario, place)


def _with_log(scenario: Scenario, place: Place) -> Scenario:
    """Fill in the log that a scenario is driven from, where there is one."""
    driver, speed = scenario.driver, scenario.speed
    if not isinstance(driver, FromLog):
        if isinstance(speed, Logged):
            refuse(
                place.within("speed"), "kind", "speed.kind = 'log' needs driver.kind = 'log'",
                usually="the driver was changed and the speed was not.", paste='kind = "constant"',
            )  # fmt: skip
        return scenario
    from similitude.log import read_log
    from similitude.vehicle_file import Vehicle

    near = scenario.folder / driver.file
    ratio = scenario.vehicle.stated.get("steering_ratio")
    log = read_log(
        near if near.is_file() else driver.file,
        vehicle=Vehicle(scenario.vehicle.name, L=scenario.vehicle.length, steering_ratio=ratio),
    )
    t = log.t - log.t[0]
    ok_steer, ok_speed = np.isfinite(log.delta), np.isfinite(log.U)
    driver = replace(driver, times=t[ok_steer], angles=log.delta[ok_steer])
    if isinstance(speed, Logged):
        speed = replace(speed, times=t[ok_speed], speeds=log.U[ok_speed])
    return replace(scenario, driver=driver, speed=speed)


def _check(scenario: Scenario, place: Place) -> None:
    """Raise ScenarioError where parts do not fit together."""
    timing, run = scenario.timing, place.within("run")
    if abs(timing.rows_every * timing.log_rate * timing.step - 1) > 1e-6 or timing.rows_every < 1:
        refuse(
            run, "log_rate", f"a row every {1e3 / timing.log_rate:.6g} ms is no whole number of steps of "
            f"{1e3 * timing.step:.6g} ms",
            usually="the step was changed and the log's rate was not.",
            paste=f'step = "{1e3 / timing.log_rate / max(1, math.ceil(500 / timing.log_rate)):.10g} ms"',
        )  # fmt: skip
    is_foreign = isinstance(scenario.plant, Commonroad)
    if is_foreign and timing.step > LARGEST_STEP * (1 + 1e-9):
        refuse(
            run, "step", f"step = {1e3 * timing.step:.6g} ms is too long for plant.kind = 'commonroad'",
            usually="another plant was meant first; its wheels turn at up to 300 1/s.",
            paste='step = "2 ms"',
        )  # fmt: skip
    _check_road(scenario, place.within("road"))
    if isinstance(scenario.driver, Lqr):
        scenario.driver.check(place.within("driver"))
    if scenario.sensors.steer_as == "steering_wheel" and scenario.vehicle.steering_ratio is None:
        refuse(
            place.within("sensors"), "steer_as", "the steering wheel's angle needs a ratio",
            usually="[vehicle] has no steering_ratio.", paste="steering_ratio = 15.3",
        )  # fmt: skip


def _check_road(scenario: Scenario, place: Place) -> None:
    patches, plant = scenario.road.surface, scenario.plant
    is_foreign = isinstance(plant, Commonroad)
    if any(patch.side != "both" for patch in patches) and not isinstance(plant, TwoTrackKeys):
        refuse(
            place.within("surface"), "side", "this plant has no left and right wheels",
            usually="the two-track plant is wanted.", paste='kind = "two_track"',
        )  # fmt: skip
    unknown_there = {
        "surface": any(patch.has_place for patch in patches), "bank": bool(scenario.road.bank),
        "gusts": scenario.road.gusts is not None, "kerbs": scenario.road.kerbs is not None,
    }  # fmt: skip
    for name, wanted in unknown_there.items():
        if is_foreign and wanted:
            refuse(
                place, name, f"plant.kind = 'commonroad' knows no {name} "
                + ("at a place, only over time" if name == "surface" else "of the road"),
                usually="the scenario was written for another plant.", paste='kind = "two_track"',
            )  # fmt: skip
