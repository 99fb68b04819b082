"""Integer expressions that know their range: what a fixed-point step is made of.

    shr(x, n)      x/2^n to the nearest, halves up
    shl(x, n)      x 2^n
    mul(a, b)      two values of 32 bits, exact
    mulq(a, b)     the same without its last 32 bits: (a b) >> 32
    mulx(a, b)     a of 64 bits and b so few that both fit 62: exact
    mulw(a, b)     a of 64, b of 32 bits: about (a b) >> 32
    mulh(a, b)     both of 64 bits: about (a b) >> 64
    clamp(x, l, h) the nearest in l..h
    quotient(n, d, up, lo, hi)    n 2^up/d to 28 bits, kept in lo..hi; d > 0

Invariant: an expression whose value could leave 63 bits cannot be made, so nothing that is printed wraps.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from similitude.errors import ProgramError

NARROW = (-(2**31), 2**31 - 1)
MOST = 2**62  # magnitude of an intermediate; the 64-bit word has room for a rounding on top


@dataclass(frozen=True)
class Int:
    """An integer expression: what it does, on what, and the least and greatest value it can take."""

    kind: str
    args: tuple[Any, ...]
    lo: int
    hi: int

    @property
    def is_narrow(self) -> bool:
        """Whether every value fits 32 bits."""
        return NARROW[0] <= self.lo and self.hi <= NARROW[1]

    @property
    def bits(self) -> int:
        """Bits of the largest magnitude."""
        return max(abs(self.lo), abs(self.hi)).bit_length()


def _made(kind: str, args: tuple, lo: int, hi: int) -> Int:
    if lo > hi or max(abs(lo), abs(hi)) > MOST:
        raise ProgramError(
            f"{kind} of {len(args)} values can reach {max(abs(lo), abs(hi)):.3g}: more than 62 bits",
            usually="A range that was stated for a state or a sample is far beyond what can occur.",
            paste="stated={'K': (17.0, 1200.0)}   # what the population allows",
            read="docs/embedded.md, 'Fixed point'",
        )
    return Int(kind, args, lo, hi)


def const(value: int) -> Int:
    """A number."""
    return _made("const", (value,), value, value)


def name(text: str, lo: int, hi: int, *, wide: bool = False) -> Int:
    """A variable of 32 bits, or of 64 where ``wide``, that is known to lie in lo..hi."""
    return _made("name", (text, wide), lo, hi)


def add(a: Int, b: Int) -> Int:
    """a + b."""
    return _made("add", (a, b), a.lo + b.lo, a.hi + b.hi)


def sub(a: Int, b: Int) -> Int:
    """a - b."""
    return _made("sub", (a, b), a.lo - b.hi, a.hi - b.lo)


def fade(a: Int, n: int) -> Int:
    """a less its own 2^-n, rounded: what forgetting keeps."""
    kept = sub(a, shr(a, n))
    half = 1 << (n - 1)
    return Int(kept.kind, kept.args, a.lo - ((a.lo + half) >> n), a.hi - ((a.hi + half) >> n))


def neg(a: Int) -> Int:
    """-a."""
    if a.kind == "const":
        return const(-a.lo)
    return _made("neg", (a,), -a.hi, -a.lo)


def _corners(a: Int, b: Int) -> tuple[int, int]:
    products = [x * y for x in (a.lo, a.hi) for y in (b.lo, b.hi)]
    least = 0 if a == b and a.lo <= 0 <= a.hi else min(products)
    return least, max(products)


def mul(a: Int, b: Int) -> Int:
    """The exact product of two values of 32 bits."""
    assert a.is_narrow and b.is_narrow
    return _made("mul", (a, b), *_corners(a, b))


def mulq(a: Int, b: Int) -> Int:
    """The upper half of the product of two values of 32 bits, rounded down."""
    assert a.is_narrow and b.is_narrow
    lo, hi = _corners(a, b)
    return _made("mulq", (a, b), lo >> 32, hi >> 32)


def mulx(a: Int, b: Int) -> Int:
    """The exact product of a wide and a small value."""
    return _made("mulx", (a, b), *_corners(a, b))


def mulw(a: Int, b: Int) -> Int:
    """The product of a wide and a narrow value without its last 32 bits, three units off at most."""
    assert b.is_narrow
    lo, hi = _corners(a, b)
    return _made("mulw", (a, b), (lo >> 32) - 3, (hi >> 32) + 3)


def mulh(a: Int, b: Int) -> Int:
    """The product of two wide values without its last 64 bits, six units off at most."""
    lo, hi = _corners(a, b)
    return _made("mulh", (a, b), (lo >> 64) - 6, (hi >> 64) + 6)


def shl(a: Int, n: int) -> Int:
    """a 2^n."""
    if not n:
        return a
    if a.kind == "const":
        return const(a.lo << n)
    return _made("shl", (a, n), a.lo << n, a.hi << n)


def shr(a: Int, n: int) -> Int:
    """a/2^n to the nearest integer, halves up."""
    if not n:
        return a
    half = 1 << (n - 1)
    if a.kind == "const":
        return const((a.lo + half) >> n)
    return _made("shr", (a, n), (a.lo + half) >> n, (a.hi + half) >> n)


def clamp(a: Int, lo: int, hi: int) -> Int:
    """The value of lo..hi that is nearest to a; a itself where it cannot leave them."""
    if lo <= a.lo and a.hi <= hi:
        return a
    return _made("clamp", (a, lo, hi), min(max(a.lo, lo), hi), max(min(a.hi, hi), lo))


def quotient(n: Int, d: Int, up: int, lo: int, hi: int) -> Int:
    """n 2^up/d to 28 bits, kept in lo..hi of 32 bits; a divisor below one counts as one."""
    assert NARROW[0] < lo <= hi <= NARROW[1]
    return _made("quotient", (n, d, up, lo, hi), lo if n.lo < 0 else max(lo, min(0, hi)), hi)


def choose(c: Cond, a: Int, b: Int) -> Int:
    """a where c holds, else b."""
    if c.kind in ("true", "false"):
        return a if c.kind == "true" else b
    return _made("choose", (c, a, b), min(a.lo, b.lo), max(a.hi, b.hi))


@dataclass(frozen=True)
class Cond:
    """A condition on integers: ``lt``, ``le``, ``and``, ``or``, ``not``, ``true``, ``false``."""

    kind: str
    args: tuple[Any, ...] = ()


TRUE, FALSE = Cond("true"), Cond("false")


def less(a: Int, b: Int, *, equal: bool) -> Cond:
    """a < b, or a <= b; decided at once where the ranges leave no doubt."""
    if a.hi < b.lo or (equal and a.hi <= b.lo):
        return TRUE
    if a.lo > b.hi or (not equal and a.lo >= b.hi):
        return FALSE
    return Cond("le" if equal else "lt", (a, b))


def every(parts: list[Cond]) -> Cond:
    """All of them."""
    if FALSE in parts:
        return FALSE
    left = tuple(p for p in parts if p != TRUE)
    return TRUE if not left else left[0] if len(left) == 1 else Cond("and", left)


def some(parts: list[Cond]) -> Cond:
    """One of them at least."""
    if TRUE in parts:
        return TRUE
    left = tuple(p for p in parts if p != FALSE)
    return FALSE if not left else left[0] if len(left) == 1 else Cond("or", left)


def opposite(c: Cond) -> Cond:
    """Not c."""
    plain = {"true": FALSE, "false": TRUE}
    return plain[c.kind] if c.kind in plain else Cond("not", (c,))
