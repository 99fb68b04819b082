"""Sums, products and ratios of scaled integers: where the point stands after each.

Invariant: value = integer 2^-fraction; an operation is exact unless its result would leave 62 bits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from similitude.program.fixed import integer as it
from similitude.program.fixed.formats import WIDE_ROOM, Format, fraction_of

MANTISSA = 30  # bits of a literal
FEW = 4  # bits over 32 that are rounded away before a product


@dataclass(frozen=True)
class Scaled:
    """An integer expression and the bits behind its point."""

    node: it.Int
    fraction: int

    @property
    def magnitude(self) -> Fraction:
        """The greatest magnitude of the value."""
        return Fraction(max(abs(self.node.lo), abs(self.node.hi))) / Fraction(2) ** self.fraction


Value = Fraction | Scaled


def literal(value: Fraction, fraction: int) -> it.Int:
    """A number at a fraction, to the nearest."""
    return it.const((value * Fraction(2) ** fraction * 2 + 1) // 2)


def at(value: Value, fraction: int) -> it.Int:
    """The integer of a value at another fraction: shifted left exactly, or right with one rounding."""
    if isinstance(value, Fraction):
        return literal(value, fraction)
    if value.node.kind == "neg":
        return it.neg(at(Scaled(value.node.args[0], value.fraction), fraction))
    more = fraction - value.fraction
    return it.shl(value.node, more) if more >= 0 else it.shr(value.node, -more)


def fit(value: Value, target: Format) -> it.Int:
    """The integer of a value in a format, clamped where it could leave it."""
    if isinstance(value, Scaled) and value.fraction < target.fraction:
        more = target.fraction - value.fraction
        held = it.clamp(value.node, -((-target.lo) >> more) - 1, (target.hi >> more) + 1)
        value = Scaled(held, value.fraction)
    return it.clamp(at(value, target.fraction), target.lo, target.hi)


def thin(value: Scaled) -> Scaled:
    """The same in 32 bits; its last digits rounded away where it had more."""
    if value.node.is_narrow:
        return value
    drop = max(value.node.bits - 31, 1)
    thinner = it.shr(value.node, drop)
    if not thinner.is_narrow:
        drop += 1
        thinner = it.shr(value.node, drop)
    return Scaled(thinner, value.fraction - drop)


def total(parts: Sequence[Value], most: int | None = None) -> Value:
    """The sum, with the digits of its finest term as far as 62 bits hold them, or ``most`` of them."""
    plain = sum((p for p in parts if isinstance(p, Fraction)), Fraction(0))
    scaled = [p for p in parts if isinstance(p, Scaled)]
    if not scaled:
        return plain
    largest = sum((p.magnitude for p in scaled), abs(plain))
    fraction = min(max(p.fraction for p in scaled), fraction_of(largest, WIDE_ROOM))
    fraction = fraction if most is None else min(fraction, most)
    terms = sorted((at(p, fraction) for p in scaled), key=lambda term: term.kind == "neg")
    node = terms[0]
    for term in terms[1:]:
        node = it.sub(node, term.args[0]) if term.kind == "neg" else it.add(node, term)
    rest = literal(plain, fraction)
    return Scaled(it.add(node, rest) if rest.lo else node, fraction)


def times(a: Value, b: Value) -> Value:
    """The product of two values."""
    if isinstance(a, Fraction) and isinstance(b, Fraction):
        return a * b
    if isinstance(a, Fraction):
        return by_number(b, a)
    if isinstance(b, Fraction):
        return by_number(a, b)
    a, b = _thinned(a), _thinned(b)
    if a.node.bits < b.node.bits:
        a, b = b, a
    if a.node.is_narrow and b.node.is_narrow:
        return Scaled(it.mul(a.node, b.node), a.fraction + b.fraction)
    if a.node.bits + b.node.bits <= 62:
        return Scaled(it.mulx(a.node, b.node), a.fraction + b.fraction)
    if b.node.is_narrow:
        b = filled(b)
        return Scaled(it.mulw(a.node, b.node), a.fraction + b.fraction - 32)
    return Scaled(it.mulh(a.node, b.node), a.fraction + b.fraction - 64)


def filled(x: Scaled) -> Scaled:
    """The same with every bit of the word in use."""
    up = 31 - x.node.bits
    return Scaled(it.shl(x.node, up), x.fraction + up) if up > 0 else x


def _thinned(a: Scaled) -> Scaled:
    """A sum a little over 32 bits, in 32: a product of 64 bits would cost more than its last digits."""
    return thin(a) if 31 < a.node.bits <= 31 + FEW else a


def by_number(a: Scaled, c: Fraction) -> Value:
    """A value times a number: a power of two moves the point, 1 - 2^-k takes a part away."""
    if not c:
        return Fraction(0)
    if c < 0:
        flipped = by_number(a, -c)
        return Scaled(it.neg(flipped.node), flipped.fraction)
    power = c.denominator.bit_length() - 1
    if c.numerator == 1 and c.denominator == 1 << power:
        return Scaled(a.node, a.fraction + power)
    if c.denominator == 1 and c.numerator & (c.numerator - 1) == 0:
        return Scaled(a.node, a.fraction - (c.numerator.bit_length() - 1))
    if c.denominator == 1 << power and c.numerator == c.denominator - 1 and not a.node.is_narrow:
        return Scaled(it.fade(a.node, power), a.fraction)
    a, fraction = _thinned(a), fraction_of(c, 2**MANTISSA - 1)
    mantissa = literal(c, fraction)
    if a.node.is_narrow:
        return Scaled(it.mul(a.node, mantissa), a.fraction + fraction)
    return Scaled(it.mulw(a.node, mantissa), a.fraction + fraction - 32)


def ratio(over: Value, under: Scaled, target: Format) -> Scaled:
    """over/under in a narrow format, saturated; ``under`` is positive."""
    if isinstance(over, Fraction):
        fraction = fraction_of(abs(over) or Fraction(1), 2**MANTISSA - 1)
        over = Scaled(literal(over, fraction), fraction)
    up = target.fraction + under.fraction - over.fraction
    return Scaled(it.quotient(over.node, under.node, up, target.lo, target.hi), target.fraction)


def narrowed(
    env: Mapping[str, tuple[int, int]], condition: it.Cond, holds: bool
) -> dict[str, tuple[int, int]]:
    """Ranges where a condition is known to hold, or not to."""
    new = dict(env)
    for name, low, high in _bounds(condition, holds):
        if name in new:
            a, b = max(new[name][0], low), min(new[name][1], high)
            new[name] = (a, b) if a <= b else (a, a)
    return new


def _bounds(c: it.Cond, holds: bool):
    if c.kind == "not":
        yield from _bounds(c.args[0], not holds)
    elif c.kind == ("and" if holds else "or"):
        for part in c.args:
            yield from _bounds(part, holds)
    elif c.kind in ("lt", "le"):
        a, b = c.args
        strict = (c.kind == "lt") == holds
        below, above = (a, b) if holds else (b, a)
        if below.kind == "name":
            yield below.args[0], -(2**63), above.hi - strict
        if above.kind == "name":
            yield above.args[0], below.lo + strict, 2**63
