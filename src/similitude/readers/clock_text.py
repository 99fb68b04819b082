"""Dates with a time of day (ISO 8601), and times of day alone, as seconds.

Invariant: a column is read in one way; a date without a zone counts as UTC, because only differences
matter. A date whose order of day and month is a country's is read only where all cells have the same.

    2024-05-01T12:00:00.25+02:00   seconds since 1970
    12:00:00.25   1:02:03 PM   25.10.2026 12:00:00.25   seconds since midnight
    3:07.25   minutes and seconds, told from hours and minutes by the fraction
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

_CLOCK = re.compile(r"(\d{4}-\d\d-\d\d)[T ](\d\d:\d\d:\d\d)(?:[.,](\d{1,9}))?\s?(Z|[+-]\d\d(?::?\d\d)?)?")
_DAY = r"(?:(\d{1,4}[./-]\d{1,2}[./-]\d{1,4})[T ]\s?)?"
_TIME = re.compile(_DAY + r"(\d{1,2}):(\d\d):(\d\d)(?:[.,:](\d{1,9}))?(?:\s?([AaPp])[Mm])?")
_MINUTES = re.compile(r"(\d{1,4}):(\d\d)[.,](\d{1,9})")
_NOON = 12


def looks_like_clock(cell: str) -> bool:
    """Return whether a cell is a date with a time of day, or a time of day with seconds."""
    cell = cell.strip()
    return any(form.fullmatch(cell) for form in (_CLOCK, _TIME, _MINUTES))


def days_of(cells: Sequence[str]) -> list[str]:
    """Return the different dates of a column whose order of day and month nobody can tell, sorted."""
    found = (_TIME.fullmatch(cell.strip()) for cell in cells if not _CLOCK.fullmatch(cell.strip()))
    return sorted({one.group(1) for one in found if one is not None and one.group(1)})


def clock_seconds(cells: Sequence[str]) -> np.ndarray:
    """Return seconds since 1970, or since midnight where cells hold no ISO date, (n,) float64; else NaN."""
    import numpy as np

    return np.array([_seconds(cell.strip()) for cell in cells], dtype=np.float64)


def _seconds(cell: str) -> float:
    found = _CLOCK.fullmatch(cell)
    if found is not None:
        return _since_1970(found)
    found = _TIME.fullmatch(cell)
    if found is not None:
        _, hours, minutes, seconds, fraction, half = found.groups()
        hour = int(hours)
        if half is not None:
            hour = hour % _NOON + (_NOON if half in "Pp" else 0)
        return 3600 * hour + 60 * int(minutes) + int(seconds) + _fraction(fraction)
    found = _MINUTES.fullmatch(cell)
    if found is not None:
        minutes, seconds, fraction = found.groups()
        return 60 * int(minutes) + int(seconds) + _fraction(fraction)
    return float("nan")


def _since_1970(found: re.Match) -> float:
    import numpy as np

    day, clock, fraction, zone = found.groups()
    try:
        whole = int(np.datetime64(f"{day}T{clock}", "s").astype(np.int64))
    except ValueError:  # a 13th month
        return float("nan")
    return whole - _offset(zone) + _fraction(fraction)


def _fraction(digits: str | None) -> float:
    return float(f"0.{digits}") if digits else 0.0


def _offset(zone: str | None) -> int:
    """Seconds by which a zone such as ``+02:00`` is ahead."""
    if zone in (None, "Z"):
        return 0
    digits = zone[1:].replace(":", "").ljust(4, "0")
    return (-1 if zone[0] == "-" else 1) * (int(digits[:2]) * 3600 + int(digits[2:]) * 60)
