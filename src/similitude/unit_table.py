"""The units this product knows by name: symbol -> factor to SI, dimension, exponent of angle.

Invariant: a name means one thing. The only exception is "g", which is the gram unless the caller
says that an acceleration is expected. pint is asked, and imported, only for a single name that
is not in this table; it never sees an expression.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from similitude.dimension import (
    ACCELERATION,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    SPEED,
    TIME,
    Dimension,
)

STANDARD_GRAVITY = 9.80665  # m/s^2, exact by definition (CGPM 1901)


@dataclass(frozen=True)
class Entry:
    """One named unit: SI value = factor * value; angle is the exponent of radian [-]."""

    factor: float
    dimension: Dimension
    angle: int = 0


_NONE = Dimension.none
_ENERGY = FORCE * LENGTH
_POWER = _ENERGY / TIME
_CURRENT = Dimension(current=1)
_VOLT = _POWER / _CURRENT
_PRESSURE = FORCE / LENGTH**2
_POUND = 0.45359237  # kg, exact (international yard and pound agreement 1959)
_TURN = 2 * math.pi

# Names that take SI prefixes ("ms", "kN", "mrad").
_PREFIXED = {
    "m": Entry(1.0, LENGTH),
    "g": Entry(1e-3, MASS),
    "s": Entry(1.0, TIME),
    "A": Entry(1.0, _CURRENT),
    "K": Entry(1.0, Dimension(temperature=1)),
    "mol": Entry(1.0, Dimension(amount=1)),
    "cd": Entry(1.0, Dimension(luminosity=1)),
    "rad": Entry(1.0, _NONE, angle=1),
    "N": Entry(1.0, FORCE),
    "Pa": Entry(1.0, _PRESSURE),
    "J": Entry(1.0, _ENERGY),
    "W": Entry(1.0, _POWER),
    "Hz": Entry(1.0, FREQUENCY),
    "C": Entry(1.0, _CURRENT * TIME),
    "V": Entry(1.0, _VOLT),
    "ohm": Entry(1.0, _VOLT / _CURRENT),
    "Ω": Entry(1.0, _VOLT / _CURRENT),
    "F": Entry(1.0, _CURRENT * TIME / _VOLT),
    "H": Entry(1.0, _VOLT * TIME / _CURRENT),
    "Wb": Entry(1.0, _VOLT * TIME),
    "T": Entry(1.0, _VOLT * TIME / LENGTH**2),
    "S": Entry(1.0, _CURRENT / _VOLT),
    "L": Entry(1e-3, LENGTH**3),
}
_PREFIXES = {
    "p": 1e-12, "n": 1e-9, "u": 1e-6, "µ": 1e-6, "μ": 1e-6, "m": 1e-3, "c": 1e-2, "d": 1e-1,
    "h": 1e2, "k": 1e3, "M": 1e6, "G": 1e9, "T": 1e12,
}  # fmt: skip

_PLAIN = {
    "deg": Entry(math.pi / 180, _NONE, angle=1),
    "rev": Entry(_TURN, _NONE, angle=1),
    "grad": Entry(math.pi / 200, _NONE, angle=1),
    "rpm": Entry(_TURN / 60, FREQUENCY, angle=1),
    "dps": Entry(math.pi / 180, FREQUENCY, angle=1),
    "min": Entry(60.0, TIME),
    "h": Entry(3600.0, TIME),
    "d": Entry(86400.0, TIME),
    "kph": Entry(1000 / 3600, SPEED),
    "mph": Entry(0.44704, SPEED),
    "mps": Entry(1.0, SPEED),
    "fps": Entry(0.3048, SPEED),
    "kn": Entry(1852 / 3600, SPEED),
    "in": Entry(0.0254, LENGTH),
    "ft": Entry(0.3048, LENGTH),
    "yd": Entry(0.9144, LENGTH),
    "mi": Entry(1609.344, LENGTH),
    "t": Entry(1000.0, MASS),
    "lb": Entry(_POUND, MASS),
    "oz": Entry(_POUND / 16, MASS),
    "slug": Entry(_POUND * STANDARD_GRAVITY / 0.3048, MASS),
    "lbf": Entry(_POUND * STANDARD_GRAVITY, FORCE),
    "kgf": Entry(STANDARD_GRAVITY, FORCE),
    "psi": Entry(_POUND * STANDARD_GRAVITY / 0.0254**2, _PRESSURE),
    "bar": Entry(1e5, _PRESSURE),
    "hp": Entry(550 * 0.3048 * _POUND * STANDARD_GRAVITY, _POWER),
    "gn": Entry(STANDARD_GRAVITY, ACCELERATION),
    "%": Entry(1e-2, _NONE),
}

_SPELLINGS = {
    "°": "deg", "degree": "deg", "degrees": "deg", "Deg": "deg",
    "radian": "rad", "radians": "rad", "Rad": "rad",
    "sec": "s", "second": "s", "seconds": "s", "msec": "ms", "usec": "us",
    "minute": "min", "minutes": "min", "hr": "h", "hour": "h", "hours": "h", "day": "d",
    "meter": "m", "meters": "m", "metre": "m", "metres": "m", "foot": "ft", "feet": "ft",
    "inch": "in", "inches": "in", "mile": "mi", "miles": "mi",
    "gram": "g", "grams": "g", "kilogram": "kg", "kilograms": "kg", "kgs": "kg",
    "tonne": "t", "tonnes": "t", "lbs": "lb", "pound": "lb", "pounds": "lb",
    "newton": "N", "newtons": "N", "joule": "J", "watt": "W", "hertz": "Hz", "volt": "V",
    "kmh": "kph", "kmph": "kph", "kt": "kn", "kts": "kn", "knot": "kn", "knots": "kn",
    "RPM": "rpm", "percent": "%", "gee": "gn", "litre": "L", "liter": "L", "l": "L",
}  # fmt: skip

# A temperature with an offset is not a factor; converting it silently would be wrong.
OFFSET_UNITS = frozenset({"°C", "°F", "degC", "degF", "celsius", "fahrenheit"})


def find(name: str, *, expect: Dimension | None = None) -> Entry | None:
    """Look one unit name up.

    Parameters
    ----------
    name : str
        A symbol or a word: ``"N"``, ``"mrad"``, ``"degrees"``; upper and lower case matter.
    expect : Dimension, optional
        With the dimension of an acceleration, "g" (also "G", "mg") is standard gravity.

    Returns
    -------
    Entry or None
        None when neither this table nor pint knows the name, or when it has an offset.
    """
    if expect == ACCELERATION and name in ("g", "G", "mg"):
        return Entry(STANDARD_GRAVITY * (1e-3 if name == "mg" else 1.0), ACCELERATION)
    name = _SPELLINGS.get(name, name)
    entry = _PLAIN.get(name) or _PREFIXED.get(name) or _prefixed(name)
    if entry is None and name not in OFFSET_UNITS:
        entry = _ask_pint(name)
    return entry


def names() -> list[str]:
    """Return the names of the table, for "did you mean"."""
    extra = ["ms", "us", "mm", "cm", "km", "kg", "mrad", "kN", "kPa", "kHz"]
    return sorted({*_PLAIN, *_PREFIXED, *_SPELLINGS, *extra})


def _prefixed(name: str) -> Entry | None:
    base = _PREFIXED.get(name[1:])
    factor = _PREFIXES.get(name[:1])
    if base is None or factor is None:
        return None
    # One multiplication by a decimal literal keeps "kg" at exactly 1.0.
    value = 1.0 if name == "kg" else base.factor * factor
    return Entry(value, base.dimension, base.angle)


_PINT_BASE = {
    "[mass]": "mass",
    "[length]": "length",
    "[time]": "time",
    "[current]": "current",
    "[temperature]": "temperature",
    "[substance]": "amount",
    "[luminosity]": "luminosity",
}


def _ask_pint(name: str) -> Entry | None:
    if not name.replace("_", "").isalpha() or not name.isascii():
        return None
    try:
        import pint

        quantity = pint.get_application_registry().Quantity(1.0, name).to_base_units()
        powers = {
            _PINT_BASE[base]: Fraction(power).limit_denominator(12)
            for base, power in quantity.dimensionality.items()
        }
        factor = float(quantity.magnitude)
    except Exception:
        # pint may be absent, and its parser answers unknown text with many kinds of exception;
        # to us they all mean that nobody knows this unit.
        return None
    if not (math.isfinite(factor) and factor > 0):
        return None
    return Entry(factor, Dimension(**powers))
