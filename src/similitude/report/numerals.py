"""Numbers and units as people read them: two digits of the uncertainty, angles in degrees."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from similitude.run import Group

DEGREES_PER_RADIAN = 180.0 / math.pi
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_GROUP_NAMES = {"eta": "η", "rho": "ρ", "pi": "π", "psi": "ψ", "mu": "μ"}


def pretty_unit(unit: str) -> str:
    """Write a unit string with superscripts; nothing for a dimensionless one.

    >>> pretty_unit("deg/(m/s^2)"), pretty_unit("-")
    ('deg/(m/s²)', '')
    """
    if unit in ("-", "1", ""):
        return ""
    return re.sub(r"\^(-?\d+)", lambda power: power[1].translate(_SUPERSCRIPT), unit)


def pretty_name(name: str) -> str:
    """Write `pi3` as π3, `ln_K` as ln K; other names keep their letters, underscores opened.

    >>> pretty_name("pi3"), pretty_name("steer_offset")
    ('π3', 'steer offset')
    """
    words = []
    for word in name.split("_"):
        letters = re.fullmatch(r"([a-z]+)(\d*)", word)
        greek = _GROUP_NAMES.get(letters[1]) if letters else None
        words.append(greek + letters[2] if greek else word)
    return " ".join(words)


def for_people(value: float, unit: str) -> tuple[float, str]:
    """Turn radians into degrees wherever the unit begins with rad; other units stay.

    Parameters
    ----------
    value : a number in `unit`.
    unit : unit string such as "rad/s" or "rad/(m/s^2)".

    Returns
    -------
    (value, unit)            the same quantity, in deg... when it was in rad... .
    """
    if re.match(r"rad(?![A-Za-z])", unit):
        return value * DEGREES_PER_RADIAN, "deg" + unit[3:]
    return value, unit


def plain(value: float, digits: int = 3) -> str:
    """Write one number with `digits` significant digits, never as 1e+02, thousands spaced."""
    if not math.isfinite(value):
        return "–"
    if value == 0:
        return "0"
    power = math.floor(math.log10(abs(value)))
    if power > 8 or power < -5:
        return f"{value:.{digits - 1}e}"
    return _fixed(value, digits - 1 - power)


def thousands(value: float) -> str:
    """Write a round number of an axis, from 10 000 on in thousands: 250k."""
    return f"{value / 1000:.6g}k" if abs(value) >= 10_000 else f"{value:.6g}"


def stated(value: float) -> str:
    """Write a number somebody gave: four significant digits, no zeros to make it look measured."""
    text = plain(value, 4)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def uncertain(value: float, std: float) -> tuple[str, str]:
    """Write a value and its standard deviation with the digits the deviation justifies.

    Two digits of the deviation, and of the value as many as stand above them (at least two).

    >>> uncertain(145.678, 12.34), uncertain(0.44311, 0.0213)
    (('146', '12'), ('0.443', '0.021'))
    """
    if not math.isfinite(value):
        return "–", "–"
    if not math.isfinite(std) or std <= 0:
        return plain(value), ("0" if std == 0 else "–")
    power = math.floor(math.log10(std))
    if math.isclose(std, 10.0 ** (power + 1), rel_tol=5e-3):
        power += 1
    decimals = 1 - power
    if value != 0:  # a deviation far larger than the value must not hide the value
        decimals = max(decimals, 1 - math.floor(math.log10(abs(value))))
    if abs(value) > 1e9 or abs(std) > 1e9 or decimals > 7:
        return f"{value:.2e}", f"{std:.1e}"
    return _fixed(value, decimals), _fixed(std, decimals)


def narrower(group: Group) -> float:
    """Share of the population's spread that a drive took away [-]; of sd/value, as ln is what is learnt."""
    now, before = (
        std / abs(value) if value else math.inf
        for value, std in ((group.value, group.std), (group.prior_value, group.prior_std))
    )
    return max(1.0 - now / before, 0.0)


def _fixed(value: float, decimals: int) -> str:
    rounded = round(value, decimals)
    text = f"{rounded:,.{max(decimals, 0)}f}".replace(",", "\u202f")
    small = abs(rounded) < 10_000
    return (text.replace("\u202f", "") if small else text).replace("-", "−")
