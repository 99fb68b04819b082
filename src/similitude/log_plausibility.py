"""Can these values be in the unit they claim? A wrong unit is refused with the guess, never cured.

Invariant: no value is changed. A guess is printed only if, under it, the values become possible.

    r yaw rate [rad/s];  U speed [m/s];  delta road wheel angle [rad];  L wheelbase [m]
    ay lateral acceleration [m/s^2];  g 9.80665 m/s^2
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding
from similitude.log_columns import Column, column_of, split_header
from similitude.units import ACCELERATION, parse_unit

_G = 9.80665  # m/s^2
LARGEST_ACCELERATION = 6 * _G  # beyond the tyres of any racing car
LARGEST_YAW_RATE = 12.0  # rad/s; two turns a second
LARGEST_ROAD_ANGLE = 1.2  # rad; 69 deg at the road wheels
LARGEST_WHEEL_ANGLE = 25.0  # rad; four turns of the steering wheel
LARGEST_SPEED = 130.0  # m/s; 468 km/h
STANDSTILL = 0.5  # m/s

READ = 'docs/logs.md, "Faults of units and signs"'

# (quantity, the most in SI, units in which a value is often written, SI unit)
_LIMITS = (
    ("U", LARGEST_SPEED, ("km/h", "mm/s"), "m/s"),
    ("r", LARGEST_YAW_RATE, ("deg/s", "mrad/s"), "rad/s"),
    ("delta", LARGEST_ROAD_ANGLE, ("deg", "mrad"), "rad"),
    ("steering_wheel", LARGEST_WHEEL_ANGLE, ("deg", "mrad"), "rad"),
    ("ay", LARGEST_ACCELERATION, ("m/s^2", "mg"), "m/s^2"),
)

# Judged at the 99th percentile: a single spike (a glitch of the bus, a blow to the gyro) is left
# to the estimator's gate, while a wrong unit lifts the whole log and this percentile with it.
SUSTAINED = 99.0


def check_units(
    values: Mapping[str, np.ndarray], columns: Mapping[str, Column], *, file: str
) -> list[Finding]:
    """Find values that cannot be in the unit of their column.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI values as the header claims; NaN where missing;
                                              "r", "U", and "delta" or "steering_wheel", "ay"
    columns : mapping of str to Column        where they come from
    file : str                                name of the file

    Returns
    -------
    list of Finding
               certain: |r| U > 6 g, |r| > 12 rad/s, |ay| > 6 g, |U| > 130 m/s, or an angle beyond
               any car's, at the 99th percentile; with the unit under which the values would be possible
    """
    found = []
    for name, most, guesses, si in _LIMITS:
        if name in values:
            found += _above(values[name], most, column_of(name, columns), guesses, file, si)
    if {"r", "U"} <= values.keys() and not found:
        found += _above(
            values["r"], LARGEST_ACCELERATION, columns["r"], ("deg/s", "mrad/s"), file, "m/s^2",
            seen=lambda one: one * np.abs(values["U"]), label="|r| U",
        )  # fmt: skip
    return found


def _above(
    values: np.ndarray,
    most: float,
    column: Column,
    guesses: tuple[str, ...],
    file: str,
    si: str,
    *,
    seen: Callable[[np.ndarray], np.ndarray] = lambda one: one,
    label: str = "",
) -> list[Finding]:
    size = np.abs(seen(values))
    if not np.any(size > most):  # a sound log is done here, without a sort
        return []
    level = float(np.nanpercentile(size, SUSTAINED))
    if level <= most:
        return []
    row = int(np.flatnonzero(size > most)[0])
    raw = values[row] / column.unit.factor
    name = split_header(column.header)[0]
    guess = _guess(level, most, column, guesses)
    label = label or f"|{name}|"
    what = (
        f"column {shown(column.header)} of {file}, data row {row + 1}: {raw:.6g} "
        f"{column.unit.text} cannot be; {label} reaches {level:.3g} {si} for 1 % of the rows, and "
        f"{most:.3g} {si} is the most"
    )
    found = Finding(
        "impossible_unit",
        certain=True,
        what=what,
        usually=f"the unit is another: these values look like {guess}; write it in the header."
        if guess
        else "the column holds raw counts or another signal; scale it first.",
        paste=f"{name} [{guess}]" if guess else f'--map "{name}=COLUMN"',
        read=READ,
        column=column.header,
        value=level,
        rows=(row + 1, row + 1),
    )
    return [found]


def _guess(level: float, most: float, column: Column, guesses: tuple[str, ...]) -> str | None:
    for text in guesses:
        factor = parse_unit(text, expect=ACCELERATION if text == "mg" else None).factor
        if factor < column.unit.factor and level * factor / column.unit.factor <= most:
            return text
    return None


def check_speed(speed: np.ndarray, *, header: str) -> list[Finding]:
    """Find standstill and reverse; `speed` (n,) in m/s, NaN where missing."""
    known = speed[~np.isnan(speed)]
    if not known.size:
        return []
    still = np.count_nonzero(np.abs(known) < STANDSTILL) / known.size
    back = np.count_nonzero(known <= -STANDSTILL) / known.size
    found = []
    if still > 0:
        found.append(Finding(
            "standstill", False,
            f"the car stands (below {STANDSTILL:g} m/s) in {100 * still:.3g} % of the rows: "
            "nothing is learnt there", "the drive was recorded with its stops.",
            "similitude identify MOVING_PART.csv", READ, column=header, value=still,
        ))  # fmt: skip
    if back > 0:
        found.append(Finding(
            "reverse", False,
            f"the speed is negative in {100 * back:.3g} % of the rows (reverse): nothing is learnt there",
            "the car was backed, or the axis of the sensor points backward.",
            "similitude identify FORWARD_PART.csv", READ, column=header, value=back,
        ))  # fmt: skip
    return found
