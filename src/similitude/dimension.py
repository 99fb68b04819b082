"""Exact physical dimensions: a vector of seven rational exponents.

Invariant: exponents are `Fraction`s, never floats, so equality and hashing are exact and
`(d ** Fraction(1, 3)) ** 3 == d` for every dimension `d`. An angle is dimensionless here;
`Unit.angle` remembers it for those who want it as a base dimension.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

_SYMBOLS = {
    "mass": "kg",
    "length": "m",
    "time": "s",
    "current": "A",
    "temperature": "K",
    "amount": "mol",
    "luminosity": "cd",
}


@dataclass(frozen=True)
class Dimension:
    """The dimension of a quantity over the seven SI base dimensions.

    Parameters
    ----------
    mass, length, time, current, temperature, amount, luminosity : int or Fraction
        Exponents [-]; zero when left out. A float is refused: 1/3 has no exact float.

    Raises
    ------
    TypeError
        An exponent that is neither an int nor a Fraction.

    Examples
    --------
    >>> force = Dimension(mass=1, length=1, time=-2)
    >>> str(force)
    'kg m s^-2'
    >>> str(force / force)
    '-'
    """

    mass: Fraction = Fraction(0)
    length: Fraction = Fraction(0)
    time: Fraction = Fraction(0)
    current: Fraction = Fraction(0)
    temperature: Fraction = Fraction(0)
    amount: Fraction = Fraction(0)
    luminosity: Fraction = Fraction(0)

    none: ClassVar[Dimension]

    def __post_init__(self) -> None:
        for name in _SYMBOLS:
            object.__setattr__(self, name, _exact(getattr(self, name)))

    @property
    def exponents(self) -> dict[str, Fraction]:
        """Exponents by base name (``"mass"``, ``"length"``, ...), zeros left out [-]."""
        return {name: getattr(self, name) for name in _SYMBOLS if getattr(self, name)}

    @property
    def powers(self) -> tuple[Fraction, ...]:
        """The seven exponents in the order of the arguments, zeros included [-]."""
        return tuple(getattr(self, name) for name in _SYMBOLS)

    def __mul__(self, other: Dimension) -> Dimension:
        if not isinstance(other, Dimension):
            return NotImplemented
        return Dimension(*(x + y if y else x for x, y in zip(self.powers, other.powers, strict=True)))

    def __truediv__(self, other: Dimension) -> Dimension:
        if not isinstance(other, Dimension):
            return NotImplemented
        return Dimension(*(x - y if y else x for x, y in zip(self.powers, other.powers, strict=True)))

    def __pow__(self, power: int | Fraction) -> Dimension:
        exact = _exact(power)
        return Dimension(*(x * exact if x else x for x in self.powers))

    def __str__(self) -> str:
        parts = [
            _SYMBOLS[name] if power == 1 else f"{_SYMBOLS[name]}^{_power_text(power)}"
            for name, power in self.exponents.items()
        ]
        return " ".join(parts) or "-"

    def __repr__(self) -> str:
        return f"<Dimension {self}>"


def _exact(power: int | Fraction) -> Fraction:
    if isinstance(power, bool) or not isinstance(power, (int, Fraction)):
        raise TypeError(f"an exponent must be an int or a Fraction, not {power!r}")
    return power if type(power) is Fraction else Fraction(power)


def _power_text(power: Fraction) -> str:
    return str(power) if power.denominator == 1 else f"({power})"


Dimension.none = Dimension()

MASS = Dimension(mass=1)
LENGTH = Dimension(length=1)
TIME = Dimension(time=1)
FREQUENCY = Dimension(time=-1)  # also an angular rate: angles carry no dimension
SPEED = LENGTH / TIME
ACCELERATION = SPEED / TIME
FORCE = MASS * ACCELERATION
INERTIA = MASS * LENGTH**2
