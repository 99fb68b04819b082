"""Directions of the unknowns that a drive does not tell, and the unknowns that carry them.

A filter that learns every unknown of such a direction gains information along it from nothing: the direction
bends, the filter's straight lines turn as its estimate moves, and each turn looks like a measurement. So one
unknown for each untold direction stays at its prior, its uncertainty carried along.

Invariant: as many unknowns are learnt as the drive tells directions, at most.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from similitude.directions import Reduced, rank
from similitude.population import Prior
from similitude.reduction import Reduction

TOLD = 1.5  # move of the output over noise, for one sd: a direction then keeps 55 % of its sd


def rank_told(
    reduction: Reduction, prior: Prior, slopes: NDArray, *, roles: Mapping[str, str] | None = None
) -> Reduced:
    """Choose roles as `rank` does, with one unknown considered for each direction that is not told.

    Parameters
    ----------
    reduction, prior, slopes, roles : as `rank` takes them.

    Returns
    -------
    Reduced
    """
    given = dict(roles or {})
    names = [one.name for one in reduction.unknowns]
    held = [names[i] for i in _carriers(prior.of(tuple(names)).covariance, slopes)]
    own = {n: "consider" for n in held if n not in given}
    if len(own) == len(names):
        own.popitem()
    ranked = rank(reduction, prior, slopes, roles={**own, **given})
    relabelled = tuple(replace(one, chosen="rule") if one.name in own else one for one in ranked.roles)
    return replace(ranked, roles=relabelled)


def _carriers(S: NDArray, slopes: NDArray) -> list[int]:
    """Unknowns in which the untold directions lie most, one each."""
    sd = np.sqrt(np.diag(S))
    values, vectors = np.linalg.eigh(S)
    root = (vectors * np.sqrt(np.maximum(values, 0))) @ vectors.T
    sizes, axes = np.linalg.eigh(root @ slopes.T @ slopes @ root)
    untold = (root @ axes[:, sizes < TOLD**2]) / sd[:, None]  # (unknowns, directions), in sds
    chosen: list[int] = []
    for _ in range(untold.shape[1]):
        loads = (untold**2).sum(axis=1)
        loads[chosen] = -1.0
        best = int(np.argmax(loads))
        chosen.append(best)
        row = untold[best] / max(float(np.linalg.norm(untold[best])), 1e-300)
        untold = untold - np.outer(untold @ row, row)
    return chosen
