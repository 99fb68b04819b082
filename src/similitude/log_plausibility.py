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
    ("U", LARGEST_SPEED, ("km/h", "cm/s", "mm/s"), "m/s"),
    ("r", LARGEST_YAW_RATE, ("deg/s", "mrad/s"), "rad/s"),
    ("delta", LARGEST_ROAD_ANGLE, ("deg", "mrad"), "rad"),
    ("steering_wheel", LARGEST_WHEEL_ANGLE, ("deg", "mrad"), "rad"),
    ("ay", LARGEST_ACCELERATION, ("m/s^2", "mg"), "m/s^2"),
)

# unit that the values look like -> repair; deg is offered for the steer, deg/s for the yaw rate
_READ_AS = {"km/h": "speed_is_kmh", "deg/s": "yaw_rate_is_deg_per_s", "deg": "steer_is_deg"}
FEWEST_FILLED = 3  # cells; one or two impossible values may be glitches, and are left to the estimator
MOST_FILL_VALUES = 2  # different ones: an error has one number, or one for either end
TURN = 2 * np.pi  # rad
NEARLY = 0.9  # of a turn, from one row to the next

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
        if name not in values:
            continue
        column = column_of(name, columns)
        filled = fill_rows(values[name], name)
        if filled.any():
            found.append(_fill_value(values[name], filled, column, file))
        else:
            found += _above(values[name], most, column, guesses, file, si)
    if {"r", "U"} <= values.keys() and not found:
        found += _above(
            values["r"], LARGEST_ACCELERATION, columns["r"], ("deg/s", "mrad/s"), file, "m/s^2",
            seen=lambda one: one * np.abs(values["U"]), label="|r| U",
        )  # fmt: skip
    return found


def check_turns(
    values: Mapping[str, np.ndarray], columns: Mapping[str, Column], *, file: str
) -> dict[str, Finding]:
    """Find angles and rates that are counted from 0 to 360 deg instead of with a sign.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI, before a steering wheel's angle is divided by its ratio
    columns : mapping of str to Column        where they come from
    file : str                                name of the file

    Returns
    -------
    dict of str to Finding                    quantity -> a certain fault
    """
    rows = {name: _full_turns(values[name]) for name in ("delta", "steering_wheel", "r") if name in values}
    return {name: _counted_round(row, columns[name], file) for name, row in rows.items() if row is not None}


def fill_rows(values: np.ndarray, name: str) -> np.ndarray:
    """Rows (n,) that hold a number for a missing value: one or two, beyond the possible, again and again."""
    most = {quantity: limit for quantity, limit, _, _ in _LIMITS}[name]
    far = np.abs(values) > most
    count = int(np.count_nonzero(far))
    if count < FEWEST_FILLED or count > values.size / 2:
        return np.zeros(values.size, dtype=bool)
    _, counts = np.unique(values[far], return_counts=True)
    constant = counts.size <= MOST_FILL_VALUES and counts.min() >= FEWEST_FILLED
    return far if constant else np.zeros(values.size, dtype=bool)


def _fill_value(values: np.ndarray, rows: np.ndarray, column: Column, file: str) -> Finding:
    numbers = " and ".join(f"{one / column.unit.factor:.6g}" for one in np.unique(values[rows]))
    first, last = (int(one) + 1 for one in np.flatnonzero(rows)[[0, -1]])
    return Finding(
        "fill_value", True,
        f"column {shown(column.header)} of {file} is {numbers} {column.unit.text}, which cannot be, in "
        f"{np.count_nonzero(rows)} of {values.size} rows, first in data row {first}",
        "the logger writes this number where it has no measurement; this leaves the cells empty.",
        "--fix drop_fill_values", READ, column=column.header, value=float(np.count_nonzero(rows)),
        rows=(first, last), fix="drop_fill_values",
    )  # fmt: skip


def _full_turns(values: np.ndarray) -> int | None:
    """Data row where an angle or a rate jumps by 360 deg because it is counted without a sign, or None."""
    known = np.flatnonzero(np.isfinite(values))
    if known.size < 2 or not NEARLY * TURN < values[known].max() <= TURN or values[known].min() < 0:
        return None
    jumps = np.flatnonzero(np.abs(np.diff(values[known])) > NEARLY * TURN)
    return int(known[jumps[0] + 1]) + 1 if jumps.size else None


def _counted_round(row: int, column: Column, file: str) -> Finding:
    turn = TURN / column.unit.factor
    cell = f'log["{column.header}"]'
    return Finding(
        "impossible_unit", True,
        f"column {shown(column.header)} of {file} jumps by a full turn in data row {row}, never below 0",
        f"it is counted from 0 to {turn:.6g} {column.unit.text}; an angle has a sign.",
        f"{cell} = ({cell} + {turn / 2:.6g}) % {turn:.6g} - {turn / 2:.6g}", READ,
        column=column.header, value=turn, rows=(row, row),
    )  # fmt: skip


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
    fix = _READ_AS.get(guess or "")
    words = "; this reads them so" if fix else "; write it in the header"
    found = Finding(
        "impossible_unit",
        certain=True,
        what=what,
        usually=f"the unit is another: these values look like {guess}{words}."
        if guess
        else "the column holds raw counts or another signal; scale it first.",
        paste=f"--fix {fix}" if fix else f"{name} [{guess}]" if guess else f'--map "{name}=COLUMN"',
        read=READ,
        fix=fix,
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
