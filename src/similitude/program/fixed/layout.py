"""The structs of a fixed-point step: words of 32 bits, a 64-bit state as two of them.

Invariant: high 2^32 + low is the state, low between -2^31 and 2^31 - 1: both are plain signed words.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from similitude.program.fixed.formats import Format
from similitude.program.fixed.integer import NARROW
from similitude.program.fixed.lower import FixedProgram, Held


def split(value: int) -> tuple[int, int]:
    """Upper and lower word of a 64-bit value."""
    high = (value + 2**31) >> 32
    return high, value - (high << 32)


def halves(fields: Iterable[Held]) -> list[Held]:
    """Every word of a struct as a field of its own."""
    rows: list[Held] = []
    for f in fields:
        if not f.format.wide:
            rows.append(f)
            continue
        upper = Format(f.format.fraction - 32, f.format.lo >> 32, (f.format.hi >> 32) + 1)
        lower = Format(f.format.fraction, *NARROW)
        rows.append(replace(f, name=f"{f.name}_high", meaning=f"{f.meaning}, upper word", format=upper))
        rows.append(replace(f, name=f"{f.name}_low", meaning="the same, lower word", format=lower))
    return rows


def words(fixed: FixedProgram) -> dict[str, int]:
    """Name and value before the first sample of every word of the state."""
    values: list[int] = []
    for f, value in zip(fixed.state, fixed.start, strict=True):
        values += split(value) if f.format.wide else [value]
    return dict(zip([f.name for f in halves(fixed.state)], values, strict=True))


def resolution(f: Held) -> str:
    """Format, range and step of a field, for people."""
    if f.format.fraction == 0:
        return f"{f.format.lo} to {f.format.hi}"
    low, high = f.format.span
    return f"Q{f.format.fraction}: {low:.5g} to {high:.5g} in steps of {f.format.step:.2g}"
