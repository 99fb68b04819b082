"""Counts what a fixed-point step does.

Invariant: shifts, clamps and products of more than 32 bits count as one operation each, a division too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from similitude.program.fixed import integer as it
from similitude.program.fixed.lower import If, Put


def nodes(thing: it.Int | it.Cond) -> Iterator[it.Int | it.Cond]:
    """An expression or condition and all below it."""
    yield thing
    for part in thing.args:
        if isinstance(part, it.Int | it.Cond):
            yield from nodes(part)


def used(body: Iterable[Put | If]) -> set[str]:
    """Kinds of operations that occur; ``clamp_wide`` where a clamp has 64 bits."""
    kinds: set[str] = set()
    for s in body:
        if isinstance(s, If):
            kinds |= {n.kind for n in nodes(s.condition)} | used(s.body) | used(s.otherwise)
            continue
        for n in nodes(s.node):
            is_wide = n.kind == "clamp" and not n.is_narrow
            kinds.add("clamp_wide" if is_wide else n.kind)
    return kinds


def operations(body: Iterable[Put | If], *, most: bool) -> int:
    """Operations along the longest (or shortest) way through the guards."""
    total = 0
    for s in body:
        if isinstance(s, If):
            ways = [operations(s.body, most=most), operations(s.otherwise, most=most)]
            total += _count(s.condition) + (max(ways) if most else min(ways))
        else:
            total += _count(s.node)
    return total


def _count(thing: it.Int | it.Cond) -> int:
    return sum(n.kind not in ("const", "name", "and", "or", "not", "true", "false") for n in nodes(thing))
