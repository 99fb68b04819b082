"""From the text of a vehicle file to values with units; every key and unit is checked here.

Invariant: a message names the file, the line, the key and the value as typed.
"""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Mapping
from pathlib import Path

from similitude.dimension import FORCE, FREQUENCY, INERTIA, LENGTH, MASS, TIME, Dimension
from similitude.errors import UnitError, VehicleError, shown
from similitude.units import Uncertain, parse_quantity, parse_uncertain

LONGEST_IN_METRES = 100  # a length without a unit from here on is in mm: 2690

READ = 'docs/vehicle.md, "The vehicle file"'

# key -> (dimension, example of a line)
KEYS = {
    "L": (LENGTH, 'L = "2.69 m"'),
    "a": (LENGTH, 'a = "1.19 m"'),
    "b": (LENGTH, 'b = "1.50 m"'),
    "m": (MASS, 'm = "1650 ± 50 kg"'),
    "Iz": (INERTIA, 'Iz = "3000 kg m^2"'),
    "Caf": (FORCE, 'Caf = "95000 N/rad"'),
    "Car": (FORCE, 'Car = "110000 N/rad"'),
    "steering_ratio": (Dimension.none, "steering_ratio = 15.3"),
    "steer_lag": (TIME, 'steer_lag = "20 ms"'),
}
SENSOR_KEYS = {
    "yaw_rate_noise": (FREQUENCY, 'yaw_rate_noise = "0.15 deg/s"'),
    "accelerometer": (LENGTH, 'accelerometer = "1.3 ± 0.05 m"'),
}

# As one line that may stand anywhere above the first section.
_EXAMPLES = {
    "name": 'name = "my car"',
    "population": 'population = "passenger_cars"',
    "steer": 'steer = "command"',
    "sensor": 'sensor.yaw_rate_noise = "0.15 deg/s"',
    **{key: line for key, (_, line) in KEYS.items()},
    **{key: f"sensor.{line}" for key, (_, line) in SENSOR_KEYS.items()},
}
_SYNONYMS = {
    "wheelbase": "L", "wheel_base": "L", "length": "L", "lf": "a", "l_f": "a", "lr": "b",
    "l_r": "b", "mass": "m", "weight": "m", "izz": "Iz", "inertia": "Iz", "yaw_inertia": "Iz",
    "cf": "Caf", "c_f": "Caf", "cr": "Car", "c_r": "Car", "ratio": "steering_ratio",
    "steer_ratio": "steering_ratio", "lag": "steer_lag", "delay": "steer_lag",
    "noise": "yaw_rate_noise", "sigma_r": "yaw_rate_noise", "vehicle": "name",
    "ay_position": "accelerometer", "imu": "accelerometer",
}  # fmt: skip


def read_document(path: Path) -> tuple[dict, str]:
    """Return the TOML document and its text; VehicleError when it is none."""
    try:
        text = path.read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise VehicleError(
            f"vehicle file {shown(path, longest=200)} cannot be opened: {error.strerror or error}",
            usually="the path is relative to another folder, or the file is not made yet.",
            paste="similitude vehicle --new > car.toml",
            read=READ,
        ) from None
    except UnicodeDecodeError as error:
        raise VehicleError(
            f"{path.name} is not UTF-8 text (byte {error.start})",
            usually="the editor saved it in another encoding, or it is no vehicle file at all.",
            paste="similitude vehicle --new > car.toml",
            read=READ,
        ) from None
    try:
        # TOML wants LF or CR LF; a lone CR would be called an illegal character.
        return tomllib.loads(text.replace("\r\n", "\n")), text
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise _not_toml(path, text, str(error)) from None


def _not_toml(path: Path, text: str, reason: str) -> VehicleError:
    at = re.search(r"line (\d+)", reason)
    lines = text.splitlines()
    line = lines[int(at.group(1)) - 1] if at and int(at.group(1)) <= len(lines) else ""
    unquoted = re.fullmatch(r"\s*(\w+)\s*=\s*([^\"'{#]+?)\s*(#.*)?", line)
    key, value = unquoted.group(1, 2) if unquoted else ("L", "2.69 m")
    twice = "overwrite" in reason
    return VehicleError(
        f"{path.name} is not TOML: {reason}" + (f", in the line {shown(line)}" if line else ""),
        usually="a key is written twice." if twice else "a value stands without quotes.",
        paste=f'{key} = "{value}"',
        read=READ,
    )


def read_values(path: Path, table: Mapping, keys: Mapping, text: str) -> dict[str, Uncertain]:
    """Return the values of a table in SI; VehicleError names the first that is wrong."""
    for key in table:
        if key not in keys:
            raise unknown_key(path, key, keys, text)
    return {key: _value(path, key, table[key], text, *keys[key]) for key in keys if key in table}


def _value(path: Path, key: str, raw: object, text: str, dimension: Dimension, example: str) -> Uncertain:
    where = f"{path.name}{line_of(key, text)}"
    is_number = isinstance(raw, (int, float)) and not isinstance(raw, bool)
    if is_number and dimension == Dimension.none:
        raw = str(raw)
    elif is_number:
        unit = example.split('"')[1].split(" ", 1)[1].removeprefix("± 50 ")
        if dimension == LENGTH and raw >= LONGEST_IN_METRES:
            unit = "mm"
        raise VehicleError(
            f"{where}: {key} = {raw} has no unit",
            usually=f"{unit} was meant; write it, so that nobody has to guess.",
            paste=f'{key} = "{raw} {unit}"',
            read=READ,
        )
    if not isinstance(raw, (str, Mapping)):
        raise VehicleError(
            f"{where}: {key} = {shown(raw)} is no value with a unit",
            usually="a value is text in quotes: a number, a blank and a unit.",
            paste=example,
            read=READ,
        )
    try:
        return parse_uncertain(raw, expect=dimension)
    except UnitError as error:
        raise VehicleError(
            f"{where}: {key}: {error.what}",
            usually=error.usually,
            paste=_corrected(key, error.paste, dimension) or example,
            read=READ,
        ) from None


def _corrected(key: str, value: str, dimension: Dimension) -> str | None:
    try:
        parse_quantity(value, expect=dimension)
    except UnitError:
        return None
    return f'{key} = "{value}"'


def unknown_key(path: Path, key: str, keys: Mapping, text: str) -> VehicleError:
    """Return the error for a key that is not known at its place."""
    meant = _meant(key)
    in_sensor = keys is SENSOR_KEYS and key != "sensor"
    misplaced = key in KEYS or key in SENSOR_KEYS or key == "sensor"
    if misplaced:
        place = "above the line [sensor]" if in_sensor else "under [sensor]"
        hint, usually = f" here; it belongs {place}", "a line moved to another section."
    else:
        hint = f"; did you mean '{meant}'?"
        usually = (
            "it is a matter of spelling; upper and lower case differ, and the known keys are "
            f"name, {', '.join(KEYS)}, steer, population and, under [sensor], {', '.join(SENSOR_KEYS)}."
        )
    return VehicleError(
        f"{path.name}{line_of(key, text)}: key {shown(key)} is not known{hint}",
        usually=usually,
        paste=_EXAMPLES[meant],
        read=READ,
    )


def _meant(key: str) -> str:
    if key in _EXAMPLES:
        return key
    lowered = key.lower().replace("-", "_").replace(" ", "_")
    for name in _EXAMPLES:
        if name.lower() == lowered:
            return name
    if lowered in _SYNONYMS:
        return _SYNONYMS[lowered]
    near = difflib.get_close_matches(lowered, [*_EXAMPLES, *_SYNONYMS], n=1, cutoff=0.6)
    return _SYNONYMS.get(near[0], near[0]) if near else "L"


def line_of(key: str, text: str) -> str:
    """Return " line 7" for the line that sets a key, or an empty text."""
    for number, line in enumerate(text.splitlines(), start=1):
        if re.match(rf"\s*\[?\s*[\"']?{re.escape(key)}[\"']?\s*[\]=.]", line):
            return f" line {number}"
    return ""
