"""Measure: an exact dimension and, for those who count it, a power of the radian.

Invariant: exact rationals throughout. Where angles are not counted the power of the radian is zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from similitude.units import Dimension, Unit


@dataclass(frozen=True)
class Measure:
    """What a quantity is measured in.

    Parameters
    ----------
    dimension : exact exponents over the seven base dimensions [-].
    angle : exponent of the radian [-]; zero where an angle is a pure number.
    """

    dimension: Dimension = Dimension.none
    angle: Fraction = Fraction(0)

    def __mul__(self, other: Measure) -> Measure:
        return Measure(self.dimension * other.dimension, self.angle + other.angle)

    def __truediv__(self, other: Measure) -> Measure:
        return Measure(self.dimension / other.dimension, self.angle - other.angle)

    def __pow__(self, power: int | Fraction) -> Measure:
        return Measure(self.dimension**power, self.angle * Fraction(power))

    @property
    def is_none(self) -> bool:
        """True for a pure number."""
        return self == NONE

    @property
    def exponents(self) -> dict[str, Fraction]:
        """Exponents by the name of the dimension (``"mass"``, ..., ``"angle"``), zeros left out [-]."""
        return self.dimension.exponents | ({"angle": self.angle} if self.angle else {})

    def __str__(self) -> str:
        """In SI units with one slash, such as ``kg m/s^2``; ``-`` for a pure number."""
        powers = [
            (symbol, self.exponents[name]) for name, symbol in SYMBOLS.items() if name in self.exponents
        ]
        over = [_power(symbol, e) for symbol, e in powers if e > 0]
        under = [_power(symbol, -e) for symbol, e in powers if e < 0]
        if not under:
            return " ".join(over) or "-"
        below = under[0] if len(under) == 1 else f"({' '.join(under)})"
        return f"{' '.join(over) or '1'}/{below}"


NONE = Measure()
ANGLE = Measure(angle=Fraction(1))
SYMBOLS = {
    "mass": "kg", "length": "m", "time": "s", "current": "A", "temperature": "K", "amount": "mol",
    "luminosity": "cd", "angle": "rad",
}  # fmt: skip


def measure_of(unit: Unit, *, angle: bool) -> Measure:
    """The measure of a unit; ``angle`` says whether the radian counts."""
    return Measure(unit.dimension, unit.angle if angle else Fraction(0))


def _power(symbol: str, power: Fraction) -> str:
    if power == 1:
        return symbol
    return f"{symbol}^{power}" if power.denominator == 1 else f"{symbol}^({power})"
