"""The population filter for small parts: the same derivation with fewer coordinates carried.

Of the unknowns it carries the one to identify and the first of those that are learnt at every sample; the
others are taken for the population's average, as the paper freezes its groups. Of the sensor errors it carries
the output's bias: an input's offset is left to the disturbance. Sensitivities are taken along the
estimate, and a sample is one whole step. What that loses is measured (docs/embedded.md, "A small filter").

Invariant: there is no second filter; every statement is one of the population filter's.
"""

from __future__ import annotations

from dataclasses import replace

from similitude.estimators.filter_fields import BIAS, Layout
from similitude.estimators.population_filter import filter_program
from similitude.program.ir import Program
from similitude.reduction import Reduction


def small_layout(reduction: Reduction) -> Layout:
    """What the small filter carries of a reduced model."""
    first, *others = reduction.unknowns
    learnt = [u.name for u in others if u.role == "estimate"][:1]
    unknowns = (first, *(u if u.name in learnt else replace(u, role="fix") for u in others))
    small = replace(reduction, unknowns=unknowns)
    return Layout(small, errors=(BIAS,), monitored=False, followed=False, fine=False)


def small_population_filter(reduction: Reduction) -> Program:
    """Derive the small filter's step program from a reduced model.

    Parameters
    ----------
    reduction : Reduction    one input, one output, any number of states and unknowns.

    Returns
    -------
    Program    ``<model>_small_population``; sample and the first six outputs are the population filter's.

    References
    ----------
    Brennan & Alleyne 2004, section 5, for the frozen groups.
    """
    return filter_program(small_layout(reduction), "small_population", "Small population filter")
