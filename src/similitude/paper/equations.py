"""Every equation of the paper, 1 to 32: where the code implements it, and a check that runs that code.

Invariant: a check calls the code that is named and returns by how much the equation fails [-]; the
printed form is checked where it can hold, the corrected one where it cannot (see `errata`).
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from similitude.paper import equations_control, equations_discrete, equations_model
from similitude.paper.claim import NOTHING


@dataclass(frozen=True)
class Equation:
    """One equation.

    Parameters
    ----------
    number : int       as printed
    says : str         what it says, in our letters
    code : str         dotted name of what implements it
    check : function   () -> residual [-]
    tolerance : float  of the residual
    """

    number: int
    says: str
    code: str
    check: Callable[[], float]
    tolerance: float = NOTHING

    @property
    def holder(self) -> Any:
        """What implements it, imported."""
        module, _, name = self.code.rpartition(".")
        return getattr(importlib.import_module(module), name)


_SECTIONS = (equations_model.TABLE, equations_discrete.TABLE, equations_control.TABLE)
EQUATIONS = tuple(Equation(*row) for table in _SECTIONS for row in table)


def residuals() -> dict[int, float]:
    """Number -> residual of every equation [-]."""
    return {equation.number: float(equation.check()) for equation in EQUATIONS}
