"""What a scenario states of its car, and how much of that the vehicle file will tell.

Invariant: values of the truth reach the vehicle file only where `known` names them; where a value
has a standard deviation the car is drawn, and the file tells what was stated, not what was drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from similitude.errors import ScenarioError, shown
from similitude.simulation.car import Car, draw_car
from similitude.simulation.foreign import foreign_car
from similitude.units import Uncertain, parse_unit
from similitude.vehicle_checks import POPULATIONS, find_fault
from similitude.vehicle_values import KEYS, SENSOR_KEYS, line_of, read_values

READ = 'docs/simulate.md, "The car and what is told of it"'
_NEEDED = ("m", "Iz", "Caf", "Car")
_TELLABLE = {**KEYS, **SENSOR_KEYS}
_UNITS = {"L": "m", "a": "m", "b": "m", "m": "kg", "Iz": "kg m^2", "Caf": "N/rad", "Car": "N/rad",
          "steering_ratio": "", "steer_lag": "s", "yaw_rate_noise": "rad/s",
          "accelerometer": "m"}  # fmt: skip


@dataclass(frozen=True)
class StatedVehicle:
    """The car of a scenario as stated.

    Parameters
    ----------
    name : str
    population : str                        for the vehicle file
    stated : dict of str to Uncertain       SI; what is uncertain is drawn for each seed
    told : dict of str to Uncertain         what the vehicle file says, under its letters
    """

    name: str
    population: str
    stated: dict[str, Uncertain]
    told: dict[str, Uncertain]

    @property
    def steering_ratio(self) -> float | None:
        """Steering wheel angle over road wheel angle [-], None where not stated."""
        held = self.stated.get("steering_ratio")
        return None if held is None else held.value

    @property
    def length(self) -> Uncertain:
        """Wheelbase as stated [m]."""
        car = self.nominal()
        return Uncertain(car.L, None, parse_unit("m"))

    def draw(self, seeds: Sequence[int]) -> Car:
        """Return the car of each seed: floats for one seed, (seeds,) arrays for more."""
        return draw_car(self.stated, seeds)

    def nominal(self) -> Car:
        """Return the car as stated, without drawing."""
        sure = {name: Uncertain(held.value, None, held.unit) for name, held in self.stated.items()}
        return draw_car(sure, [0])

    def vehicle_file(self) -> str:
        """Return the vehicle file that belongs to a log of this car."""
        lines = [f'name = "{self.name}"', f'population = "{self.population}"']
        last = []
        for name, held in self.told.items():
            amount = f"{held.value:.10g}" + (f" ± {held.sd:.6g}" if held.sd is not None else "")
            line = f'{name} = "{amount} {_UNITS[name]}"' if _UNITS[name] else f'{name} = "{amount}"'
            last.append(line) if name in SENSOR_KEYS else lines.append(line)
        return "\n".join([*lines, *(["", "[sensor]", *last] if last else [])]) + "\n"


def read_stated_vehicle(
    vehicle: Mapping[str, Any], told: Mapping[str, Any], plant: Any, *, path: Path, text: str
) -> StatedVehicle:
    """Read the sections [vehicle] and [told].

    Parameters
    ----------
    vehicle : mapping   as a vehicle file, and `known`: the letters that its file will tell
    told : mapping      lines that the vehicle file will tell instead
    plant : dataclass   of the scenario; a foreign one brings its car along
    path, text          of the scenario file, for messages

    Raises
    ------
    ScenarioError, VehicleError   a key is not known or missing, a value cannot be
    """
    rest = {name: value for name, value in vehicle.items() if name not in ("name", "population", "known")}
    name = _word(vehicle, "name", path.stem, path)
    population = _word(told, "population", _word(vehicle, "population", "passenger_cars", path), path)
    if population not in POPULATIONS:
        raise ScenarioError(
            f"{path.name}: population {shown(population)} is not known; there are {', '.join(POPULATIONS)}",
            usually="it is a matter of spelling.",
            paste='population = "passenger_cars"',
            read=READ,
        )
    stated = read_values(path, rest, KEYS, text)
    if hasattr(plant, "model"):
        stated |= _of_foreign(plant, stated, path, text)
    _check_complete(stated, path, text)
    # Which population the car is said to be of is belief; that it could be one of them is physics.
    faults = {name: find_fault(stated, population=name) for name in POPULATIONS}
    if all(faults.values()):
        fault = faults[population]
        raise ScenarioError(
            f"{path.name}{line_of(fault.key, text)}: {fault.what}",
            usually=fault.usually,
            paste=fault.paste,
            read=READ,
        )
    telling = {key: stated[key] for key in _known(vehicle, stated, path)}
    lines = {key: value for key, value in told.items() if key not in ("population",)}
    telling |= read_values(path, lines, _TELLABLE, text)
    return StatedVehicle(name, population, stated, telling)


def _word(table: Mapping[str, Any], name: str, default: str, path: Path) -> str:
    value = table.get(name, default)
    if isinstance(value, str) and '"' not in value and value.isprintable():
        return value
    raise ScenarioError(
        f"{path.name}: {name} = {shown(value)} is no plain text",
        usually="the quotes are missing.",
        paste=f'{name} = "{default}"',
        read=READ,
    )


def _of_foreign(plant: Any, stated: Mapping[str, Uncertain], path: Path, text: str) -> dict[str, Uncertain]:
    mixed = sorted(stated.keys() - {"steering_ratio"})
    if mixed:
        raise ScenarioError(
            f"{path.name}{line_of(mixed[0], text)}: {mixed[0]} of [vehicle] has no effect on a foreign plant",
            usually="the car comes with plant.kind = 'commonroad'; what its file says goes under [told].",
            paste='known = ["L"]',
            read=READ,
        )
    car = foreign_car(plant.model, plant.vehicle)
    held = {"L": car.L, "a": car.a, "b": car.b, "m": car.m, "Iz": car.Iz, "Caf": car.Caf, "Car": car.Car}
    return {name: Uncertain(value, None, parse_unit(_UNITS[name])) for name, value in held.items()}


def _check_complete(stated: Mapping[str, Uncertain], path: Path, text: str) -> None:
    lengths = stated.keys() & {"L", "a", "b"}
    missing = [name for name in _NEEDED if name not in stated] + ([] if len(lengths) >= 2 else ["a"])
    if missing:
        raise ScenarioError(
            f"{path.name}{line_of('vehicle', text)}: [vehicle] has no {missing[0]}, and a car that is "
            f"driven needs {', '.join(_NEEDED)} and two of L, a, b",
            usually="a vehicle file was copied, which may leave things unknown; a simulation may not.",
            paste=KEYS[missing[0]][1],
            read=READ,
        )


def _known(vehicle: Mapping[str, Any], stated: Mapping[str, Uncertain], path: Path) -> list[str]:
    known = vehicle.get("known", ["L"])
    wrong = [name for name in known if name not in _UNITS] if isinstance(known, list) else [known]
    if wrong:
        raise ScenarioError(
            f"{path.name}: known = {shown(known)}: {shown(wrong[0])} is no letter of a vehicle file",
            usually="it is a list of letters from [vehicle] that the vehicle file will tell.",
            paste='known = ["L", "a", "m"]',
            read=READ,
        )
    found = [name for name in known if name in stated]
    if "L" in known and "L" not in found:
        found += [name for name in ("a", "b") if name not in found]
    # A wheel angle cannot be read from a steering wheel without its ratio.
    return found + (["steering_ratio"] if "steering_ratio" in stated.keys() - set(found) else [])
