"""The systems that come with the package, by name; a file is imported when its system is asked for.

Invariant: the name of a system is that of its file and of its model.
"""

from __future__ import annotations

import difflib
import importlib
from typing import TYPE_CHECKING

from similitude.errors import UsageError, shown

if TYPE_CHECKING:
    from similitude.systems.system import System

SHIPPED = (
    "bicycle",
    "saturating_bicycle",
    "dc_motor",
    "overhead_crane",
    "aircraft_short_period",
    "quarter_car",
    "rlc_circuit",
    "michaelis_menten",
    "predator_prey",
    "heat_exchanger",
)


def shipped_system(name: str) -> System:
    """A system that comes with the package.

    Parameters
    ----------
    name : one of `SHIPPED`.

    Raises
    ------
    UsageError    there is no such system.
    """
    if name not in SHIPPED:
        near = difflib.get_close_matches(str(name), SHIPPED, n=1, cutoff=0.4) or SHIPPED[:1]
        raise UsageError(
            f"there is no shipped system {shown(name)} (there are {', '.join(SHIPPED)})",
            usually="the name was misspelt, or the system is one of your own: import its file.",
            paste=f"shipped_system({near[0]!r})",
            read='docs/systems.md, "Systems that come with the package"',
        )
    return importlib.import_module(f"similitude.systems.{name}").SYSTEM
