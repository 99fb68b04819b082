"""Units at the border: text in, SI floats inside. The door to everything about units.

Invariant: nothing is guessed. A number without a unit, a unit that is not known and a unit of
another dimension than the expected one are refused with the line to write. Importing this module
imports neither numpy nor pint.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

from similitude.dimension import (
    ACCELERATION,
    FORCE,
    FREQUENCY,
    INERTIA,
    LENGTH,
    MASS,
    SPEED,
    TIME,
    Dimension,
)
from similitude.errors import UnitError, shown
from similitude.unit import Unit, parse_unit

__all__ = [
    "ACCELERATION",
    "FORCE",
    "FREQUENCY",
    "INERTIA",
    "LENGTH",
    "MASS",
    "SPEED",
    "TIME",
    "Dimension",
    "Uncertain",
    "Unit",
    "parse_quantity",
    "parse_uncertain",
    "parse_unit",
]

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_QUANTITY = re.compile(rf"\s*({_NUMBER})(?![\d.,])\s*(.*?)\s*", re.DOTALL)
_PLUS_MINUS = re.compile(r"±|\+/-|\+-")


@dataclass(frozen=True)
class Uncertain:
    """A value with, perhaps, a standard deviation.

    Parameters
    ----------
    value : float       in SI
    sd : float or None  standard deviation in SI; None when nobody stated one
    unit : Unit         the unit it was written in
    """

    value: float
    sd: float | None
    unit: Unit


def parse_quantity(text: str, *, expect: Dimension | None = None) -> tuple[float, Unit]:
    """Read a number with its unit.

    Parameters
    ----------
    text : str
        Such as ``"2.69 m"`` or ``"10 ms"``; the unit may be left out where a pure number is
        expected.
    expect : Dimension, optional
        The dimension it must have.

    Returns
    -------
    value : float   in SI
    unit : Unit     as written

    Raises
    ------
    UnitError
        No number, no unit, an unknown unit, or another dimension than the expected one.

    Examples
    --------
    >>> parse_quantity("2.69 m")[0]
    2.69
    """
    number, unit_text = _split(text)
    if not unit_text and expect == Dimension.none:
        unit_text = "1"
    if not unit_text:
        raise _bare_number(text, number, expect)
    unit = parse_unit(unit_text, expect=expect)
    return _finite(text, number * unit.factor), unit


def _split(text: str) -> tuple[float, str]:
    match = _QUANTITY.fullmatch(text)
    if match is None:
        comma = re.sub(r"(?<=\d),(?=\d)", ".", text)
        raise UnitError(
            f"{shown(text)} does not begin with a number",
            usually="a value is a number, a blank and a unit; the decimal sign is a point.",
            paste=comma if _QUANTITY.fullmatch(comma) else "2.69 m",
            read='docs/units.md, "Values"',
        )
    return _finite(text, float(match.group(1))), match.group(2)


def _finite(text: str, value: float) -> float:
    if math.isfinite(value):
        return value
    raise UnitError(
        f"{shown(text)} is too large for a number",
        usually="an exponent has a digit too many.",
        paste="1e3 N",
        read='docs/units.md, "Values"',
    )


def _bare_number(text: str, number: float, expect: Dimension | None) -> UnitError:
    unit = str(expect) if expect is not None else "m"
    wanted = f" of dimension '{expect}'" if expect is not None else ""
    return UnitError(
        f"{shown(text.strip())} has no unit{wanted}",
        usually="SI was meant; write it, so that nobody has to guess.",
        paste=f"{number:.12g} {unit}",
        read='docs/units.md, "Values"',
    )


def parse_uncertain(source: str | Mapping[str, str], *, expect: Dimension | None = None) -> Uncertain:
    """Read a value with or without its standard deviation.

    Parameters
    ----------
    source : str or mapping
        ``"2010 kg"``, ``"2010 ± 50 kg"``, ``"2010 +- 50 kg"``, ``"2010 kg ± 50 kg"`` or
        ``{"value": "2010 kg", "sd": "50 kg"}`` (``sd`` may be left out).
    expect : Dimension, optional
        The dimension both must have.

    Returns
    -------
    Uncertain   value and sd in SI, sd positive or None.

    Raises
    ------
    UnitError
        As `parse_quantity`, and when sd is not positive or a key is not "value" or "sd".
    """
    if isinstance(source, Mapping):
        value_text, sd_text = _of_mapping(source)
    else:
        value_text, sd_text = _of_text(source)
    value, unit = parse_quantity(value_text, expect=expect)
    if sd_text is None:
        return Uncertain(value, None, unit)
    sd, _ = parse_quantity(sd_text, expect=unit.dimension)
    if sd <= 0:
        raise UnitError(
            f"standard deviation '{sd_text.strip()}' of '{value_text.strip()}' is not positive",
            usually="the value is known exactly, or not at all; then leave the deviation out.",
            paste=value_text.strip(),
            read='docs/units.md, "Uncertain values"',
        )
    return Uncertain(value, sd, unit)


def _of_text(source: str) -> tuple[str, str | None]:
    text = source.strip()
    bracketed = re.fullmatch(r"\((.*)\)\s*(\S.*)", text)
    if bracketed and _PLUS_MINUS.search(bracketed.group(1)):
        text = f"{bracketed.group(1)} {bracketed.group(2)}"
    value_text, *more = _PLUS_MINUS.split(text)
    if not more:
        return value_text, None
    sd_text = more[0] if len(more) == 1 else text
    # In "2010 ± 50 kg" the unit stands once, at the end, for both.
    if not _split(value_text)[1]:
        value_text = f"{value_text.strip()} {_split(sd_text)[1]}"
    elif not _split(sd_text)[1]:
        sd_text = f"{sd_text.strip()} {_split(value_text)[1]}"
    return value_text, sd_text


def _of_mapping(source: Mapping[str, str]) -> tuple[str, str | None]:
    strays = sorted(set(source) - {"value", "sd"})
    not_text = [key for key in source if not isinstance(source[key], str)]
    if strays or not_text or "value" not in source:
        wrong = (
            f"key '{strays[0]}' is not known" if strays
            else f"'{not_text[0]}' = {source[not_text[0]]!r} has no unit" if not_text
            else "key 'value' is missing"
        )  # fmt: skip
        raise UnitError(
            f"an uncertain value is written with 'value' and 'sd' as text, but {wrong}",
            usually="a number was written without its unit, or a key is spelled differently.",
            paste='{ value = "2010 kg", sd = "50 kg" }',
            read='docs/units.md, "Uncertain values"',
        )
    return source["value"], source.get("sd")
