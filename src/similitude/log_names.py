"""What a column that no known name fits may be: the line to paste, from names and units.

Invariant: a proposal is printed and never taken; the user decides by pasting it.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Sequence

from similitude.dimension import ACCELERATION
from similitude.errors import UnitError, shown
from similitude.log_quantities import AMBIGUOUS, QUANTITIES, normal_name, split_header
from similitude.units import Unit, parse_unit

# Units as they are spelt at the end of a name, where brackets and slashes are not allowed.
SPELT = {
    "s": "s", "sec": "s", "seconds": "s", "ms": "ms", "us": "us", "ns": "ns",
    "deg": "deg", "degree": "deg", "degrees": "deg", "rad": "rad", "mrad": "mrad",
    "degps": "deg/s", "dps": "deg/s", "deg_s": "deg/s", "deg_per_s": "deg/s", "degs": "deg/s",
    "radps": "rad/s", "rps": "rad/s", "rad_s": "rad/s", "rad_per_s": "rad/s", "rads": "rad/s",
    "mps": "m/s", "m_s": "m/s", "m_per_s": "m/s", "kmh": "km/h", "kph": "km/h", "km_h": "km/h",
    "mph": "mph", "mps2": "m/s^2", "m_s2": "m/s^2", "ms2": "m/s^2", "g": "g",
}  # fmt: skip
ROUND = re.compile(r"(.*?)\s*\(([^()]+)\)\s*")


def other_name(free: Sequence[str], missing: Sequence[str], *, nothing_known: bool) -> tuple[str, str]:
    """What usually hides columns that are missing, and the line to paste.

    Parameters
    ----------
    free : sequence of str       headers that are no quantity yet, as written
    missing : sequence of str    quantities without a column; "delta" where there is no steer at all
    nothing_known : bool         whether no column of the file goes by a known name

    Returns
    -------
    (str, str)                   the end of the sentence "Usually ...", and the line
    """
    unclear = [one for one in free if normal_name(split_header(one)[0]) in AMBIGUOUS]
    if "delta" in missing and unclear:
        column = split_header(unclear[0])[0]
        return (
            f"{shown(column)} is the steering wheel; if it is the road wheel, map delta.",
            f'--map "steering_wheel={column}"',
        )
    if any(_in_round(one) for one in free):
        return (
            "the units stand in round brackets; square ones are read.",
            ",".join(_in_round(one) or one for one in free),
        )
    spelt = _spelt_units(free, missing)
    if spelt:
        return "the units stand in the names; these lines say so.", " ".join(spelt)
    fitting = {name: _of_its_unit(name, free) for name in missing}
    if all(len(columns) == 1 for columns in fitting.values()):
        return _by_units({name: columns[0] for name, columns in fitting.items()})
    if nothing_known:
        return (
            "the file is no driving log, or its header is not in its first line.",
            ",".join(f"{name} [{QUANTITIES[name].si}]" for name in ("t", "delta", "r", "U")),
        )
    first = missing[0]
    known = ", ".join(sorted(QUANTITIES[first].aliases, key=lambda name: (len(name), name))[:6])
    names = [split_header(one)[0] for one in fitting[first] or free]
    near = difflib.get_close_matches(first, names, n=1, cutoff=0.3) or ["COLUMN"]
    return f"it goes by another name than {known}, ...", f'--map "{first}={near[0]}"'


def fits_unit(name: str, unit: Unit) -> bool:
    """Whether a unit is one of a quantity: its dimension, and an angle where it is one."""
    quantity = QUANTITIES[name]
    plain_number = unit.text in ("1", "-", "1/s", "s^-1")  # SI: the radian is 1
    right_angle = unit.angle == 1 or plain_number if quantity.is_angle else unit.angle == 0
    return unit.dimension == quantity.dimension and right_angle


def unit_of(name: str, text: str) -> Unit:
    """The unit that a text means on a quantity: ``g`` on an acceleration is standard gravity."""
    return parse_unit(text, expect=ACCELERATION if name == "ay" and text in ("g", "G", "mg") else None)


def _by_units(columns: dict[str, str]) -> tuple[str, str]:
    words, maps = "it goes by another name; its unit fits that of", []
    for name, header in columns.items():
        steer = name == "delta"
        maps.append(f'--map "{"steering_wheel" if steer else name}={split_header(header)[0]}"')
    shown_headers = ", ".join(shown(header, longest=30) for header in columns.values())
    if len(columns) > 1:
        words = "they go by other names; the units fit those of"
    wheel = " (map delta, not steering_wheel, if it is the road wheel's)" if "delta" in columns else ""
    return f"{words} {shown_headers}{wheel}.", " ".join(maps)


def _spelt_units(headers: Sequence[str], missing: Sequence[str]) -> list[str]:
    """Maps for headers such as ``yaw_rate_deg_s``, where all that is missing is spelt so; else none."""
    found = {}
    for header in headers:
        words = normal_name(header).split("_")
        for cut in range(1, len(words)):
            name, unit = "_".join(words[:-cut]), SPELT.get("_".join(words[-cut:]))
            fits = [
                key for key, one in QUANTITIES.items() if name in one.aliases and unit and _fits(key, unit)
            ]
            if fits and header not in found.values():
                found[fits[0]] = f'--map "{fits[0]}={header} [{unit}]"'
    wanted = {"delta", "steering_wheel"} & found.keys() if "delta" in missing else {"delta"}
    complete = bool(wanted) and all(name in found for name in missing if name != "delta")
    return [found[name] for name in QUANTITIES if name in found] if complete else []


def _of_its_unit(name: str, headers: Sequence[str]) -> list[str]:
    return [one for one in headers if _fits(name, split_header(one)[1])]


def _fits(name: str, text: str | None) -> bool:
    if text is None or text in ("1", "-"):
        return False
    try:
        return fits_unit(name, unit_of(name, text))
    except UnitError:
        return False


def _in_round(header: str) -> str | None:
    """The header with its unit in square brackets, where it stands in round ones."""
    found = ROUND.fullmatch(header)
    if found is None:
        return None
    name, text = found.groups()
    is_one = any(normal_name(name) in one.aliases for one in QUANTITIES.values())
    return f"{name} [{text}]" if is_one else None
