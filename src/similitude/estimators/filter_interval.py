"""The variance the population filter hands out: its own, and more where it leans on constants it learnt.

The filter takes the model's error for noise that is forgotten in a moment. So with time it becomes surer of
the constants beside the first unknown than it is right: on simulated drives of 80 s their errors are two to
three times their standard deviations (scripts/consistency.py). How far the first unknown leans on them stands
in the covariance, and that part of its variance counts for more.

Invariant: what is handed out is between the filter's own variance and ``1 + slow_doubt`` times that.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.estimators.filter_fields import INPUT_SCALE, Layout
from similitude.program.ir import Assign

LEAST_PIVOT = sp.Float(1e-6)  # of a variance: what rounding leaves of it where two unknowns are one
LEAST_VARIANCE = sp.Float(1e-24)  # of a constant that is known; its reciprocal fits into single precision


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def leant_on(layout: Layout) -> tuple[str, ...]:
    """Coordinates that are constant and learnt from every sample."""
    learnt = tuple(u.name for u in layout.reduction.unknowns if u.role in ("estimate", "beyond"))
    return (*learnt, INPUT_SCALE) if INPUT_SCALE in layout.errors else learnt


def interval(layout: Layout) -> list[Assign]:
    """``variance`` = P_tt + slow_doubt b' S^-1 b; S is the constants' covariance, b theirs with unknown t.

    b' S^-1 b is the variance that would go if the constants were known; S = L D L' is eliminated row by row.
    A small filter hands out its own.
    """
    P, t = layout.covariance, layout.coordinates.index(layout.target)
    if layout.lean:
        return [Assign("variance", P[t, t])]
    at = [layout.coordinates.index(name) for name in leant_on(layout)]
    lines = [line for k in range(len(at)) for line in _eliminate(layout, at, k)]
    leant = sp.Add(*(S(f"lean_{i}") ** 2 * S(f"inv_pivot_{i}") for i in at))
    return [
        Assign("own_variance", P[t, t]),
        *lines,
        Assign("leant", leant, "of it, what would go if the constants were known"),
        Assign("variance", P[t, t] + S("slow_doubt") * sp.Min(S("leant"), P[t, t])),
    ]


def _eliminate(layout: Layout, at: Sequence[int], k: int) -> list[Assign]:
    """Row k of D, L' and b, each less what the rows before it hold."""
    P, t, i = layout.covariance, layout.coordinates.index(layout.target), at[k]
    before = at[:k]
    rest = P[i, i] - sp.Add(*(S(f"ratio_{j}_{i}") * S(f"row_{j}_{i}") for j in before))
    least = LEAST_PIVOT * P[i, i] + LEAST_VARIANCE
    lines = [
        Assign(f"pivot_{i}", rest),
        Assign(f"inv_pivot_{i}", 1 / sp.Max(S(f"pivot_{i}"), least)),
        Assign(f"lean_{i}", P[t, i] - sp.Add(*(S(f"ratio_{j}_{i}") * S(f"lean_{j}") for j in before))),
    ]
    for m in at[k + 1 :]:
        row = P[i, m] - sp.Add(*(S(f"ratio_{j}_{i}") * S(f"row_{j}_{m}") for j in before))
        lines.append(Assign(f"row_{i}_{m}", row))
        lines.append(Assign(f"ratio_{i}_{m}", S(f"row_{i}_{m}") * S(f"inv_pivot_{i}")))
    return lines
