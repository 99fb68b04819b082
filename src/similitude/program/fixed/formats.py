"""Formats: how many bits of a 32- or 64-bit integer stand behind the point.

Invariant: a format holds its whole range, with the finest step that does.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from similitude.program.fixed.integer import NARROW

WIDE_ROOM = 2**61  # greatest magnitude of a 64-bit variable: a sum of two still fits
ROOM = Fraction(129, 128)  # of a sample's format over what is believed: beyond it must be seen
SLIM = 2**28  # greatest magnitude of a 32-bit variable: a sum of eight still fits 32 bits
MISSING = -(2**31)  # a sample that is not there


@dataclass(frozen=True)
class Format:
    """value = integer 2^-fraction, the integer in lo..hi; ``wide`` has 64 bits."""

    fraction: int
    lo: int
    hi: int
    wide: bool = False

    @property
    def step(self) -> float:
        """The value of one unit."""
        return math.ldexp(1.0, -self.fraction)

    @property
    def span(self) -> tuple[float, float]:
        """Least and greatest value."""
        return self.lo * self.step, self.hi * self.step

    def integer(self, value: float | Fraction) -> int:
        """The integer nearest to a value, kept in the format's range."""
        scaled = Fraction(value) * Fraction(2) ** self.fraction
        return min(max(math.floor(scaled + Fraction(1, 2)), self.lo), self.hi)


def fraction_of(magnitude: float | Fraction, most: int) -> int:
    """Most bits behind the point with which a magnitude stays within ``most``."""
    if not magnitude:
        return 30
    exact = Fraction(most) / Fraction(magnitude)
    bits = math.floor(math.log2(exact)) + 1
    while Fraction(2) ** bits > exact:
        bits -= 1
    return bits


def format_of(
    low: float, high: float, *, wide: bool = False, whole: bool = False, full: bool = False
) -> Format:
    """The finest format that holds low..high; with room for a sum of eight, unless ``full``."""
    most = WIDE_ROOM // 2 if wide else NARROW[1] if full else SLIM
    fraction = 0 if whole else fraction_of(max(abs(low), abs(high)), most - 1)
    scale = Fraction(2) ** fraction
    ends = (math.floor(Fraction(end) * scale + Fraction(1, 2)) for end in (low, high))  # as literals round
    return Format(fraction, *ends, wide)


def sample_format(low: float, high: float) -> Format:
    """The format of a sample: any 32 bits may come in, and what is beyond belief must be seen to be."""
    fraction = fraction_of(Fraction(max(abs(low), abs(high))) * ROOM, NARROW[1])
    return Format(fraction, *NARROW)
