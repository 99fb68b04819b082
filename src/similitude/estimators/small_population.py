"""The population filter for small parts: the same derivation with fewer coordinates carried.

The paper's "average frozen" idea, applied where the population leaves little open: unknowns that the
full filter learns seldom, or only considers, stay at the population's value, and the scale of the input
is taken for known. What that costs in accuracy is measured (docs/embedded.md, "The small filter").

Invariant: there is no second filter; statements are those of the population filter.
"""

from __future__ import annotations

from dataclasses import replace

from similitude.estimators.filter_fields import BIAS, OFFSET, Layout
from similitude.estimators.population_filter import filter_program
from similitude.program.ir import Program
from similitude.reduction import Reduction


def small_population_filter(reduction: Reduction, fixed=("pi1",), errors=(OFFSET, BIAS)) -> Program:
    small = replace(
        reduction,
        unknowns=tuple(replace(u, role="fix") if u.name in fixed else u for u in reduction.unknowns),
    )
    return filter_program(Layout(small, errors, monitored=False), "small_population", "Small population filter")
