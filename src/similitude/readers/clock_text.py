"""Dates with a time of day (ISO 8601) as seconds since 1970.

Invariant: a column of dates is read as one, with or without a zone for all its cells; a date
without a zone counts as UTC, because only differences matter.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

_CLOCK = re.compile(r"(\d{4}-\d\d-\d\d)[T ](\d\d:\d\d:\d\d)(?:[.,](\d{1,9}))?\s?(Z|[+-]\d\d(?::?\d\d)?)?")


def looks_like_clock(cell: str) -> bool:
    """Return whether a cell is written ``2024-05-01T12:00:00.25``, with or without a zone."""
    return _CLOCK.fullmatch(cell.strip()) is not None


def clock_seconds(cells: Sequence[str]) -> np.ndarray:
    """Return seconds since 1970, (n,) float64; NaN where a cell is no date."""
    import numpy as np

    return np.array([_seconds(_CLOCK.fullmatch(cell.strip())) for cell in cells], dtype=np.float64)


def _seconds(found: re.Match | None) -> float:
    import numpy as np

    if found is None:
        return float("nan")
    day, clock, fraction, zone = found.groups()
    try:
        whole = int(np.datetime64(f"{day}T{clock}", "s").astype(np.int64))
    except ValueError:  # a 13th month
        return float("nan")
    return whole - _offset(zone) + (float(f"0.{fraction}") if fraction else 0.0)


def _offset(zone: str | None) -> int:
    """Seconds by which a zone such as ``+02:00`` is ahead."""
    if zone in (None, "Z"):
        return 0
    digits = zone[1:].replace(":", "").ljust(4, "0")
    return (-1 if zone[0] == "-" else 1) * (int(digits[:2]) * 3600 + int(digits[2:]) * 60)
