"""One unit: its text, its factor to SI and its exact dimension.

Invariant: a unit that is not known, or of another dimension than the expected one, is refused
with the line to write; nothing is guessed.
"""

from __future__ import annotations

import difflib
import math
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from similitude import unit_table
from similitude.dimension import Dimension
from similitude.errors import UnitError, shown
from similitude.unit_grammar import GrammarError, parse_terms

READ = 'docs/units.md, "How units are written"'


@dataclass(frozen=True)
class Unit:
    """A unit as somebody wrote it.

    Parameters
    ----------
    text : str             as written, such as ``"deg/s"``
    factor : float         SI value = factor * value; positive and finite
    dimension : Dimension  angles carry none
    angle : Fraction       exponent of the radian [-], for callers that want it as a base
    """

    text: str
    factor: float
    dimension: Dimension
    angle: Fraction = Fraction(0)

    @property
    def is_angle(self) -> bool:
        """True for a plain angle (rad, deg, mrad), which has no dimension of its own."""
        return self.dimension == Dimension.none and self.angle == 1


@lru_cache(maxsize=4096)  # a model asks for the same few again and again
def parse_unit(text: str, *, expect: Dimension | None = None) -> Unit:
    """Read a unit.

    Parameters
    ----------
    text : str
        Such as ``"deg/s"``, ``"kg m^2"``, ``"kg*m**2"``, ``"N m/rad"``, ``"m/s²"``, ``"km/h"``;
        ``"1"`` and ``"-"`` for a pure number. Powers may be rational: ``"m^(1/2)"``.
    expect : Dimension, optional
        The dimension it must have. With that of an acceleration "g" is standard gravity,
        otherwise the gram.

    Returns
    -------
    Unit

    Raises
    ------
    UnitError
        The text is no unit, or its dimension is not the expected one.

    Examples
    --------
    >>> parse_unit("km/h").factor * 36
    10.0
    >>> from similitude.dimension import ACCELERATION
    >>> parse_unit("g", expect=ACCELERATION).factor
    9.80665
    """
    if text.strip() in ("-", "–", "—"):
        unit = Unit(text, 1.0, Dimension.none)
    else:
        unit = _unit_of_terms(text, _terms(text), expect)
    if expect is not None and unit.dimension != expect:
        raise UnitError(
            f"unit {shown(text)} has the dimension '{unit.dimension}', but '{expect}' is expected",
            usually="another quantity was meant, or a division sign was lost.",
            paste=str(expect) if expect != Dimension.none else "1",
            read=READ,
        )
    return unit


def _terms(text: str) -> list[tuple[str, Fraction]]:
    try:
        return parse_terms(text)
    except GrammarError as error:
        raise UnitError(
            f"unit {shown(text)} cannot be read: {error}",
            usually="a unit is a product with one slash: kg m^2, deg/s, J/(kg K); 1 for none.",
            paste="deg/s",
            read=READ,
        ) from None


def _unit_of_terms(text: str, terms: list, expect: Dimension | None) -> Unit:
    factor, dimension, angle = 1.0, Dimension.none, Fraction(0)
    for name, power in terms:
        # "g" beside other names ("g m^2") is a gram whatever is expected.
        entry = unit_table.find(name, expect=expect if len(terms) == 1 else None)
        if entry is None:
            raise _unknown(text, name)
        try:
            factor *= entry.factor**power
        except OverflowError:
            factor = math.inf
        dimension *= entry.dimension**power
        angle += entry.angle * power
    if not 0 < factor < math.inf:
        raise UnitError(
            f"unit {shown(text)} is {factor:g} SI units, which no number can hold",
            usually="a power has a digit too many.",
            paste="m/s^2",
            read=READ,
        )
    return Unit(text, factor, dimension, angle)


def _unknown(text: str, name: str) -> UnitError:
    if name in unit_table.OFFSET_UNITS:
        return UnitError(
            f"unit '{name}' in '{text}' has its zero elsewhere, so it is no factor",
            usually="a temperature is meant; only differences can be converted by a factor.",
            paste="K",
            read=READ,
        )
    known = unit_table.names()
    near = [other for other in known if other.lower() == name.lower()]
    near = near or difflib.get_close_matches(name, known, n=1, cutoff=0.5)
    hint = f"; did you mean '{near[0]}'?" if near else ""
    return UnitError(
        f"unit {shown(name)} in {shown(text)} is not known{hint}",
        usually="it is a matter of spelling: upper and lower case differ ('s', 'm/s', 'kg').",
        paste=text.replace(name, near[0], 1) if near else "rad/s",
        read=READ,
    )
