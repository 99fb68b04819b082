"""Can these values be in the unit they claim? A wrong unit is refused with the guess, never cured.

Invariant: no value is changed. A guess is printed only if, under it, the values become possible.

    r yaw rate [rad/s];  U speed [m/s];  delta road wheel angle [rad];  L wheelbase [m]
    ay lateral acceleration [m/s^2];  g 9.80665 m/s^2
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from similitude.errors import LogError, shown
from similitude.log_columns import Column, split_header
from similitude.units import ACCELERATION, parse_unit

_G = 9.80665  # m/s^2
LARGEST_ACCELERATION = 6 * _G  # beyond the tyres of any racing car
LARGEST_YAW_RATE = 12.0  # rad/s; two turns a second
LARGEST_ROAD_ANGLE = 1.2  # rad; 69 deg at the road wheels
LARGEST_WHEEL_ANGLE = 25.0  # rad; four turns of the steering wheel
LARGEST_SPEED = 130.0  # m/s; 468 km/h
STANDSTILL = 0.5  # m/s

# Judged at the 99th percentile: a single spike (a glitch of the bus, a blow to the gyro) is left
# to the estimator's gate, while a wrong unit lifts the whole log and this percentile with it.
SUSTAINED = 99.0


def check_units(values: Mapping[str, np.ndarray], columns: Mapping[str, Column], *, file: str) -> None:
    """Refuse values that cannot be in the unit of their column.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI values as the header claims; NaN where missing;
                                              "r", "U", and "delta" or "steering_wheel", "ay"
    columns : mapping of str to Column        where they come from
    file : str                                name of the file

    Raises
    ------
    LogError   |r| U > 6 g, |r| > 12 rad/s, |ay| > 6 g, |U| > 130 m/s, or an angle beyond any car's,
               at the 99th percentile; with the unit under which the values would be possible
    """
    speed, rate = values["U"], values["r"]
    _refuse_above(speed, LARGEST_SPEED, columns["U"], ("km/h", "mm/s"), file, "m/s")
    _refuse_above(rate, LARGEST_YAW_RATE, columns["r"], ("deg/s", "mrad/s"), file, "rad/s")
    _refuse_above(
        rate, LARGEST_ACCELERATION, columns["r"], ("deg/s", "mrad/s"), file, "m/s^2",
        seen=lambda one: one * np.abs(speed), label="|r| U",
    )  # fmt: skip
    for name, most in (("delta", LARGEST_ROAD_ANGLE), ("steering_wheel", LARGEST_WHEEL_ANGLE)):
        if name in values:
            _refuse_above(values[name], most, columns[name], ("deg", "mrad"), file, "rad")
    if "ay" in values:
        _refuse_above(values["ay"], LARGEST_ACCELERATION, columns["ay"], ("m/s^2", "mg"), file, "m/s^2")


def _refuse_above(
    values: np.ndarray,
    most: float,
    column: Column,
    guesses: tuple[str, ...],
    file: str,
    si: str,
    *,
    seen: Callable[[np.ndarray], np.ndarray] = lambda one: one,
    label: str = "",
) -> None:
    size = np.abs(seen(values))
    if not np.nanmax(size) > most:  # a sound log is done here, without a sort
        return
    level = float(np.nanpercentile(size, SUSTAINED))
    if level <= most:
        return
    row = int(np.flatnonzero(size > most)[0])
    raw = values[row] / column.unit.factor
    name = split_header(column.header)[0]
    guess = _guess(level, most, column, guesses)
    label = label or f"|{name}|"
    raise LogError(
        f"column {shown(column.header)} of {file}, data row {row + 1}: {raw:.6g} "
        f"{column.unit.text} cannot be; {label} reaches {level:.3g} {si} for 1 % of the rows, and "
        f"{most:.3g} {si} is the most",
        usually=f"the unit is another: these values look like {guess}; write it in the header."
        if guess
        else "the column holds raw counts or another signal; scale it first.",
        paste=f"{name} [{guess}]" if guess else f'--map "{name}=COLUMN"',
        read='docs/logs.md, "What is refused"',
    )


def _guess(level: float, most: float, column: Column, guesses: tuple[str, ...]) -> str | None:
    for text in guesses:
        factor = parse_unit(text, expect=ACCELERATION if text == "mg" else None).factor
        if factor < column.unit.factor and level * factor / column.unit.factor <= most:
            return text
    return None


def speed_warnings(speed: np.ndarray) -> tuple[str, ...]:
    """Return warnings on standstill and reverse; `speed` (n,) in m/s, NaN where missing."""
    known = speed[~np.isnan(speed)]
    still = np.count_nonzero(np.abs(known) < STANDSTILL) / known.size
    back = np.count_nonzero(known <= -STANDSTILL) / known.size
    warnings = []
    if still > 0:
        warnings.append(
            f"the car stands (below {STANDSTILL:g} m/s) in {100 * still:.2g} % of the rows: "
            "nothing is learnt there"
        )
    if back > 0:
        warnings.append(
            f"the speed is negative in {100 * back:.2g} % of the rows (reverse): nothing is learnt there"
        )
    return tuple(warnings)


def check_against_steer(
    values: Mapping[str, np.ndarray], columns: Mapping[str, Column], *, wheelbase: float, file: str
) -> tuple[str, ...]:
    """Compare the yaw rate with what the steer asks for, r = U delta / L.

    A tyre only takes from that: a car understeers. So a yaw rate many times larger, in step with
    the steer, is in degrees; this finds the wrong unit of a quiet log, which stays below 6 g.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI: "delta" (road wheel), "r", "U"
    columns : mapping of str to Column        where they come from
    wheelbase : float                         L [m]
    file : str                                name of the file

    Returns
    -------
    tuple of str   warnings: opposite signs; a steer that looks like the steering wheel's

    Raises
    ------
    LogError       r follows U delta / L, but is more than ten times as large
    """
    asked = values["U"] * values["delta"] / wheelbase
    rate = values["r"]
    both = np.isfinite(asked) & np.isfinite(rate) & (values["U"] > 3.0)
    if np.count_nonzero(both) < 50:
        return ()
    asked, rate = asked[both], rate[both]
    asked, rate = asked - asked.mean(), rate - rate.mean()
    power, cross = float(asked @ asked), float(asked @ rate)
    if power == 0 or float(rate @ rate) == 0:
        return ()
    slope, likeness = cross / power, cross / float(np.sqrt(power * (rate @ rate)))
    if likeness > 0.5 and slope > 10:
        raise _too_large_a_slope(slope, columns, file)
    if likeness < -0.8:
        return ("steer and yaw rate have opposite signs: turn one of them round",)
    if likeness > 0.8 and 0 < slope < 0.04:
        return (
            f"the yaw rate is only {slope:.2g} of U delta / L: the steer looks like that of the "
            "steering wheel, or its unit is another",
        )
    return ()


def _too_large_a_slope(slope: float, columns: Mapping[str, Column], file: str) -> LogError:
    rate, steer = columns["r"], columns.get("delta") or columns["steering_wheel"]
    guesses = []
    if rate.unit.factor > np.pi / 180:
        guesses.append((f"those of {shown(rate.header)} look like deg/s",
                        f"{split_header(rate.header)[0]} [deg/s]"))  # fmt: skip
    if steer.unit.factor < 1:
        guesses.append((f"those of {shown(steer.header)} look like rad",
                        f"{split_header(steer.header)[0]} [rad]"))  # fmt: skip
    guesses = guesses or [("the wheelbase or the steering ratio looks wrong", 'L = "2.69 m"')]
    return LogError(
        f"column {shown(rate.header)} of {file} is {slope:.3g} times U delta / L, the yaw rate of "
        "a car on rails; no car turns more than a few times as fast",
        usually="a unit is another: " + ", or ".join(text for text, _ in guesses) + ".",
        paste=guesses[0][1],
        read='docs/logs.md, "What is refused"',
    )
