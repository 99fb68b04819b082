"""Sums and products in 32 bits: each product keeps its upper half, so that nothing is 64 bits wide.

A variable has three bits to spare (`formats.SLIM`), so a sum of eight stays within a word; the numbers that
multiply variables are scaled so that the upper half of the product has the point where the sum wants it. The
product of a variable with a number that occurs again, but for a power of two, is taken once: the zeros of a
filter at rest or at the greatest frequency then stay exactly where they are.

Invariant: None is returned where something is wider than a word; the sum is then taken in 64 bits.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from similitude.program.fixed import integer as it
from similitude.program.fixed.arithmetic import Scaled, at, filled
from similitude.program.fixed.formats import SLIM, fraction_of

FULL = 31  # bits of a factor that uses its whole word


@dataclass(frozen=True)
class Term:
    """A value in 32 bits times a number."""

    value: Scaled
    number: Fraction

    @property
    def magnitude(self) -> Fraction:
        """The greatest magnitude."""
        return self.value.magnitude * abs(self.number)


def product(factors: Sequence[Scaled]) -> Scaled | None:
    """The product of values in 32 bits, in 32 bits."""
    if any(not f.node.is_narrow for f in factors):
        return None
    found = factors[0]
    for f in factors[1:]:
        a, b = filled(found), filled(f)
        found = Scaled(it.mulq(a.node, b.node), a.fraction + b.fraction - 32)
    return found


def plain(number: Fraction) -> int | None:
    """k where the magnitude of a number is 2^k."""
    over, under = abs(number).numerator, number.denominator
    if over & (over - 1) or under & (under - 1):
        return None
    return over.bit_length() - under.bit_length()


def odd_part(number: Fraction) -> Fraction:
    """A positive number over the power of two that brings it into 1..2."""
    scaled = number / Fraction(2) ** (number.numerator.bit_length() - number.denominator.bit_length())
    return scaled * 2 if scaled < 1 else scaled


def settled(term: Term, fraction: int) -> it.Int | None:
    """The integer of a term at a fraction; None where it does not fit a word."""
    x, c = term.value, abs(term.number)
    power = plain(c)
    if power is not None:
        return _kept(at(Scaled(x.node, x.fraction - power), fraction), term.number)
    finest = fraction_of(c, it.NARROW[1])
    up = min(max(32 + fraction - x.fraction - finest, 0), max(FULL - x.node.bits, 0))
    behind = min(32 + fraction - x.fraction - up, finest)
    mantissa = it.const((c * Fraction(2) ** behind * 2 + 1) // 2)
    made = Scaled(it.mulq(it.shl(x.node, up), mantissa), x.fraction + up + behind - 32)
    return _kept(at(made, fraction), term.number)


def _kept(node: it.Int, number: Fraction) -> it.Int | None:
    if not node.is_narrow or (number < 0 and node.lo == it.NARROW[0]):
        return None
    return it.neg(node) if number < 0 else node


def total(
    terms: Sequence[Term], rest: Fraction, fraction: int | None, share: Callable[[Term, int], Term]
) -> Scaled | None:
    """The sum of terms and a number at a fraction, the best one where None is given.

    ``share`` replaces a term by one whose product was already taken.
    """
    bound = sum((t.magnitude for t in terms), abs(rest))
    most = fraction_of(bound, it.NARROW[1] // 2)
    if fraction is None:
        fraction = fraction_of(bound, SLIM)
        if all(plain(t.number) is not None for t in terms):
            fraction = min(fraction, max(t.value.fraction - plain(t.number) for t in terms))
    fraction = min(fraction, most)
    parts = [settled(share(t, fraction), fraction) for t in terms]
    if any(p is None for p in parts):
        return None
    parts.sort(key=lambda p: p.kind == "neg")
    node = parts[0]
    for p in parts[1:]:
        node = it.sub(node, p.args[0]) if p.kind == "neg" else it.add(node, p)
    number = (rest * Fraction(2) ** fraction * 2 + 1) // 2
    node = it.add(node, it.const(number)) if number else node
    return Scaled(node, fraction) if node.is_narrow else None
