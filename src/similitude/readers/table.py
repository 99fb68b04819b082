"""A table on its way from a file: headers first, columns when asked for.

Invariant: a loaded column is float64 with one entry a row; what is missing is NaN. Readers know
nothing of vehicles, units or plausibility.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

READ = 'docs/logs.md, "Files"'


@dataclass(frozen=True)
class Loaded:
    """Columns of a file, in the order asked for, and what had to be said about them."""

    columns: tuple[np.ndarray, ...]  # each (n,) float64
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True)
class Table:
    """An opened file.

    Parameters
    ----------
    headers : tuple of str   as written, such as ``"r [deg/s]"``, in file order
    load : callable          positions (sequence of int) -> Loaded; raises LogError
    warnings : tuple of str  what was noticed while opening
    """

    headers: tuple[str, ...]
    load: Callable[[Sequence[int]], Loaded]
    warnings: tuple[str, ...] = ()
