"""What a vehicle cannot be: bounds and relations between the values of a vehicle file.

Invariant: the bounds are those of quantities without units wherever one exists, so that they
hold for a truck and for a model car alike; only the wheelbase and the mass are compared with the
population, because that is what tells the two apart.

    L wheelbase, a and b axle distances of the centre of gravity [m];  m mass [kg];
    Iz yaw inertia [kg m^2];  C cornering stiffness of an axle [N/rad];  g 9.80665 m/s^2
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from similitude.units import Uncertain

_GRAVITY = 9.80665  # m/s^2


@dataclass(frozen=True)
class Fault:
    """One impossible value: the key to blame and three of the four parts of a message."""

    key: str
    what: str
    usually: str
    paste: str


# population -> (wheelbase [m], mass [kg]), each (least, most) with room to spare
_FULL_SIZE = ((1.0, 12.0), (200.0, 60e3))
POPULATIONS = {
    "passenger_cars": _FULL_SIZE,
    "light_trucks": _FULL_SIZE,
    "all_vehicles": _FULL_SIZE,
    "small_cars_1to10": ((0.08, 0.999), (0.1, 100.0)),
    "brennan_2004": _FULL_SIZE,
}

# Three lengths of a 2.5 m car, each rounded to the centimetre, miss their sum by 1.5 cm.
_ROUNDING = 0.006

# (key, least, most, what it usually means, line to paste): bounds in SI
_BOUNDS = (
    ("steering_ratio", 1.0, 60.0, "the ratio was inverted; it is steering wheel angle over "
     "road wheel angle, 12 to 20 on a car.", "steering_ratio = 15.3"),
    ("steer_lag", 0.0, 1.0, "milliseconds were meant.", 'steer_lag = "20 ms"'),
    ("yaw_rate_noise", 1e-7, 0.5, "deg/s were meant; a car's gyro has 0.01 to 0.5 deg/s.",
     'yaw_rate_noise = "0.15 deg/s"'),
    ("accelerometer", -3.0, 15.0, "millimetres were meant; it is the place behind the front axle.",
     'accelerometer = "1.3 m"'),
)  # fmt: skip


def find_fault(values: Mapping[str, Uncertain], *, population: str) -> Fault | None:
    """Return the first impossible value, or None.

    Parameters
    ----------
    values : mapping of name to Uncertain   SI values under the letters of a vehicle file
    population : str                        a key of `POPULATIONS`

    Returns
    -------
    Fault or None
    """
    # One after the other: the later ones divide by what the earlier ones have found to be sound.
    faults = _signs(values) or _axles(values) or _size(values, population) or _ratios(values)
    return faults[0] if faults else None


def _signs(values: Mapping[str, Uncertain]) -> list[Fault]:
    faults = []
    for key, held in values.items():
        if held.value < 0 or (held.value == 0 and key not in ("steer_lag", "accelerometer")):
            faults.append(Fault(
                key, f"{key} = {held.value:.6g} {_si(key)} is not positive",
                "a sign slipped in; distances, masses and stiffnesses are positive.",
                _line(key, abs(held.value)) if held.value else _EXAMPLES[key],
            ))  # fmt: skip
        elif held.sd is not None and held.sd >= held.value:
            faults.append(Fault(
                key, f"the standard deviation of {key}, {held.sd:.6g} {_si(key)}, is as large as "
                f"its value, {held.value:.6g} {_si(key)}",
                "the two were exchanged, or the value is not known; then leave the line out.",
                f'{key} = "{held.sd:.6g} ± {held.value:.6g} {_SI_UNITS[key]}"',
            ))  # fmt: skip
    for key, least, most, usually, paste in _BOUNDS:
        held = values.get(key)
        if held is not None and not faults and not least <= held.value <= most:
            faults.append(Fault(
                key, f"{key} = {held.value:.6g} {_si(key)} lies outside {least:g} to {most:g}",
                usually, paste,
            ))  # fmt: skip
    return faults


def _axles(values: Mapping[str, Uncertain]) -> list[Fault]:
    length, front, rear = (values.get(key) for key in ("L", "a", "b"))
    for key, part in (("a", front), ("b", rear)):
        if length is not None and part is not None and part.value >= length.value:
            return [Fault(
                key, f"{key} = {part.value:.6g} m is not shorter than L = {length.value:.6g} m",
                f"{key} was measured from another point; it runs from the centre of gravity to "
                f"the {'front' if key == 'a' else 'rear'} axle.",
                _line(key, 0.45 * length.value),
            )]  # fmt: skip
    if length is not None and front is not None and rear is not None:
        total = front.value + rear.value
        spread = sum((held.sd or 0.0) ** 2 for held in (length, front, rear)) ** 0.5
        if abs(total - length.value) > max(_ROUNDING * length.value, 3 * spread):
            return [Fault(
                "L", f"L = {length.value:.6g} m is not a + b = {front.value:.6g} m + {rear.value:.6g} m "
                f"= {total:.6g} m",
                "one of the three belongs to another car or another load; two of them are enough.",
                _line("L", total),
            )]  # fmt: skip
    return _centre(length, front, rear)


def _centre(length: Uncertain | None, front: Uncertain | None, rear: Uncertain | None) -> list[Fault]:
    """Whether the centre of gravity lies where a road vehicle can have it."""
    if length is None and (front is None or rear is None):
        return []
    whole = length.value if length is not None else front.value + rear.value
    for key, part in (("a", front), ("b", rear)):
        if part is not None and not 0.2 <= part.value / whole <= 0.8:
            return [Fault(
                key, f"{key} = {part.value:.6g} m is {part.value / whole:.2g} of the wheelbase, "
                f"{whole:.6g} m; road vehicles lie between 0.2 and 0.8",
                f"{key} was measured from another point, or is in another unit.",
                _line(key, 0.45 * whole),
            )]  # fmt: skip
    return []


def _size(values: Mapping[str, Uncertain], population: str) -> list[Fault]:
    for key, bounds in zip(("L", "m"), POPULATIONS[population], strict=True):
        held = values.get(key)
        if held is None or bounds[0] <= held.value <= bounds[1]:
            continue
        unit = _SI_UNITS[key]
        what = (
            f"{key} = {held.value:.6g} {unit} cannot be one of population '{population}' "
            f"({bounds[0]:g} to {bounds[1]:g} {unit})"
        )
        for name in POPULATIONS:
            if name != population and _fits(values, name):
                return [Fault(key, what, "the car is of another population.",
                              f'population = "{name}"')]  # fmt: skip
        # A number in m that was read off in inches: the unit under which it is nearest to usual.
        usual = (bounds[0] * bounds[1]) ** 0.5
        _, other, guess = min(
            (abs(math.log(held.value * size / usual)), other, held.value * size)
            for other, size in _OTHER_UNITS[key]
        )
        if bounds[0] <= guess <= bounds[1]:
            return [Fault(key, what, f"{unit} and {other} were exchanged.", _line(key, guess))]
        return [Fault(key, what, "a digit or the unit is wrong.", _EXAMPLES[key])]
    return []


def _fits(values: Mapping[str, Uncertain], population: str) -> bool:
    bounds = zip(("L", "m"), POPULATIONS[population], strict=True)
    return all(low <= values[key].value <= high for key, (low, high) in bounds if key in values)


def _ratios(values: Mapping[str, Uncertain]) -> list[Fault]:
    length, mass, inertia = (values.get(key) for key in ("L", "m", "Iz"))
    if length is not None and mass is not None and inertia is not None:
        scale = mass.value * length.value**2
        if not 0.02 <= inertia.value / scale <= 2.0:
            return [Fault(
                "Iz", f"Iz = {inertia.value:.6g} kg m^2 is {inertia.value / scale:.3g} of m L^2; "
                "cars lie near 0.25",
                "the inertia about another axis or in another unit was taken.",
                _line("Iz", 0.25 * scale),
            )]  # fmt: skip
    for key in ("Caf", "Car"):
        held = values.get(key)
        if held is None or mass is None:
            continue
        coefficient = held.value / (mass.value * _GRAVITY)
        if not 0.3 <= coefficient <= 60.0:
            return [Fault(
                key, f"{key} = {held.value:.6g} N/rad is {coefficient:.3g} times the weight of "
                "the car per rad; axles lie between 1 and 12",
                "the stiffness is per degree, or of one tyre in another unit.",
                f'{key} = "{held.value:.6g} N/deg"' if coefficient < 0.3
                else _line(key, 5 * mass.value * _GRAVITY),
            )]  # fmt: skip
    return _balance(values)


def _balance(values: Mapping[str, Uncertain]) -> list[Fault]:
    """Whether the axles' stiffnesses can belong to one car: eta = Car b/(Caf a), > 1 understeers."""
    if not {"Caf", "Car", "a", "b"} <= values.keys():
        return []
    front, rear, a, b = (values[key].value for key in ("Caf", "Car", "a", "b"))
    eta = rear * b / (front * a)
    if 0.4 <= eta <= 5.0:
        return []
    return [Fault(
        "Car", f"Car b/(Caf a) = {rear:.6g} {b:.4g}/({front:.6g} {a:.4g}) = {eta:.3g}; cars lie "
        "between 1.1 and 1.9",
        "one axle is per tyre or per degree, or the two axles were exchanged.",
        _line("Car", 1.4 * front * a / b),
    )]  # fmt: skip


# A line as it looks on an ordinary car, where the value given holds no hint of the one meant.
_EXAMPLES = {
    "L": 'L = "2.69 m"', "a": 'a = "1.19 m"', "b": 'b = "1.50 m"', "m": 'm = "1650 kg"',
    "Iz": 'Iz = "2800 kg m^2"', "Caf": 'Caf = "90 kN/rad"', "Car": 'Car = "110 kN/rad"',
    "steering_ratio": "steering_ratio = 15.3", "steer_lag": 'steer_lag = "20 ms"',
    "yaw_rate_noise": 'yaw_rate_noise = "0.15 deg/s"', "accelerometer": 'accelerometer = "1.3 m"',
}  # fmt: skip

# For a number that was typed with the SI unit: (unit in which it may be instead, its size in SI), or
# the reverse, a number in SI that was typed with that unit.
_OTHER_UNITS = {
    "L": (("mm", 1e-3), ("cm", 1e-2), ("in", 0.0254), ("mm", 1e3), ("cm", 1e2), ("in", 1 / 0.0254)),
    "m": (("t", 1e3), ("lb", 0.45359237), ("t", 1e-3)),
}  # fmt: skip

_SI_UNITS = {
    "L": "m", "a": "m", "b": "m", "m": "kg", "Iz": "kg m^2", "Caf": "N/rad", "Car": "N/rad",
    "steering_ratio": "", "steer_lag": "s", "yaw_rate_noise": "rad/s",
    "accelerometer": "m",
}  # fmt: skip


def _si(key: str) -> str:
    return _SI_UNITS[key] or "[-]"


def _line(key: str, value: float) -> str:
    unit = _SI_UNITS[key]
    return f'{key} = "{value:.6g} {unit}"' if unit else f"{key} = {value:.6g}"
