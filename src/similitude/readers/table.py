"""A table on its way from a file: headers first, columns when asked for.

Invariant: a loaded column is float64 with one entry a row; what is missing is NaN. Readers know
nothing of vehicles, units or plausibility.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from similitude.finding import Finding

if TYPE_CHECKING:
    import numpy as np

READ = 'docs/logs.md, "Files"'


@dataclass(frozen=True)
class Loaded:
    """Columns of a file, in the order asked for, and what had to be said about them."""

    columns: tuple[np.ndarray, ...]  # each (n,) float64; seconds since 1970 where it is a clock
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True)
class Table:
    """An opened file.

    Parameters
    ----------
    headers : tuple of str        as written, such as ``"r [deg/s]"``, in file order
    load : callable               (positions, blanked=()) -> Loaded; raises LogError. `blanked` names
                                  faults of cells ("text_in_cell", "header_again") that are to
                                  count as missing instead
    is_clock : callable           position -> whether its cells are dates with a time of day
    findings : tuple of Finding   what was noticed while opening
    """

    headers: tuple[str, ...]
    load: Callable[..., Loaded]
    is_clock: Callable[[int], bool]
    findings: tuple[Finding, ...] = ()


def noted(fault: str, what: str, usually: str, paste: str) -> Finding:
    """Return a finding that is said and refuses nothing."""
    return Finding(fault, certain=False, what=what, usually=usually, paste=paste, read=READ)
