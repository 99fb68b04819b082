"""A product of powers of named parameters, read from text: ``a*b``, ``Caf L/m``, ``Iz/(m L^2)``.

Invariant: exponents are exact; names are whatever the model declares, digits included.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from fractions import Fraction

from similitude.errors import UsageError, shown

READ = 'docs/populations.md, "The table"'
_TOKEN = re.compile(
    r"\s*(?:(?P<name>[A-Za-z_]\w*)|(?P<power>(?:\^|\*\*)\s*(?:-?\d+|\(-?\d+(?:/\d+)?\)))|(?P<sign>[*/()]))"
)


def read_monomial(text: str, known: Collection[str]) -> dict[str, Fraction]:
    """Read a product of powers.

    Parameters
    ----------
    text : str     names, ``*`` or blanks between factors, ``/``, ``^`` and brackets after a slash.
    known : names that may occur.

    Returns
    -------
    dict           name -> exponent [-], zeros left out.

    Raises
    ------
    UsageError     a name is not known, or the text is no product of powers.
    """
    powers: dict[str, Fraction] = {}
    sign, at, last, inside = 1, 0, "", False
    while at < len(text.rstrip()):
        found = _TOKEN.match(text, at)
        if found is None:
            raise _unreadable(text, known)
        at, mark = found.end(), found["sign"]
        if name := found["name"]:
            if name not in known:
                raise _unreadable(text, known, name)
            powers[name] = powers.get(name, Fraction(0)) + sign
            added, last = (name, sign), "name"
            sign = sign if inside else 1
        elif (power := found["power"]) and last == "name":
            powers[added[0]] += added[1] * (Fraction(re.sub(r"[\s()^*]", "", power)) - 1)
            last = "power"
        elif mark == "/" and not inside and last in ("name", "power"):
            sign, last = -1, "/"
        elif mark == "*" and last in ("name", "power"):
            last = "*"
        elif mark == "(" and last == "/":
            inside, last = True, "("
        elif mark == ")" and inside and last in ("name", "power"):
            inside, sign, last = False, 1, "power"
        else:
            raise _unreadable(text, known)
    depth = inside or last in ("*", "/", "(")
    if depth or not powers:
        raise _unreadable(text, known)
    return {name: power for name, power in powers.items() if power}


def monomial_text(powers: Mapping[str, Fraction]) -> str:
    """Write a product of powers: ``Iz/(m L^2)``."""
    above = [_factor(name, p) for name, p in powers.items() if p > 0]
    below = [_factor(name, -p) for name, p in powers.items() if p < 0]
    top = " ".join(above) or "1"
    if not below:
        return top
    return f"{top}/{below[0]}" if len(below) == 1 else f"{top}/({' '.join(below)})"


def _factor(name: str, power: Fraction) -> str:
    if power == 1:
        return name
    return f"{name}^{power}" if Fraction(power).denominator == 1 else f"{name}^({power})"


def _unreadable(text: str, known: Collection[str], name: str = "") -> UsageError:
    what = (
        f"{shown(name)} in {shown(text)} is no parameter"
        if name
        else f"{shown(text)} is no product of powers"
    )
    return UsageError(
        f"{what}; the parameters are {', '.join(known)}",
        usually="a letter is spelt otherwise in the model; upper and lower case differ.",
        paste="a*b",
        read=READ,
    )
