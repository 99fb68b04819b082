"""The population filter for small parts: the same derivation with fewer coordinates and a shorter step.

All unknowns are carried: what is wrongly taken for known ends in the estimate and not in its interval.
Left out is what loses little: scale and offset of the input (the disturbance stands for the offset), the
companion states (sensitivities are taken along the estimate), the second half step and the straight line
between two inputs, and what only a monitor needs. What that loses is printed by scripts/small_filter.py.

Invariant: there is no second filter: the same derivation by another layout, its steps in a shorter order.
"""

from __future__ import annotations

from similitude.estimators.filter_fields import BIAS, Layout
from similitude.estimators.filter_lean import bounded_once
from similitude.estimators.population_filter import filter_program
from similitude.program.ir import Program
from similitude.reduction import Reduction


def small_population_filter(reduction: Reduction) -> Program:
    """Derive the small filter's step program from a reduced model.

    Parameters
    ----------
    reduction : Reduction    one input, any number of states and unknowns; one output, or a second one that is
        a sum of states and rates.

    Returns
    -------
    Program    ``<model>_small_population``; sample and the first six outputs are the population filter's.

    References
    ----------
    docs/embedded.md, "A small filter".
    """
    layout = Layout(reduction, errors=(BIAS,), monitored=False, followed=False, fine=False, lean=True)
    return bounded_once(filter_program(layout, "small_population", "Small population filter"))
