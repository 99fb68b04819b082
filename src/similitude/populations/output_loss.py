"""What a relation costs in the output: how far it moves if the relation is imposed on a system that scatters.

    loss = scatter * rms(dy/d ln g) / rms(y)    g the last group of the relation, replaced by what it says

Invariant: only the output of the model is judged, along one stated input and at stated scales.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.groups import Groups
from similitude.output_sensitivity import output_sensitivity, sampled_response
from similitude.populations.population import Population
from similitude.populations.relations import Relation, Relations
from similitude.reduction import Reduction, Unknown


def output_losses(
    relations: Relations, population: Population, u: NDArray, step: float, *, scales: Mapping[str, float]
) -> Relations:
    """The same relations, each with the loss it causes in the output.

    Parameters
    ----------
    relations, population : from `relate` of the population; its groups are taken at their means.
    u : (n,) input of a manoeuvre or a log [SI].    step : sample time [s].
    scales : name -> value [SI] of the base, signals at the value that the population states.

    Returns
    -------
    Relations     ``loss`` filled in [-]; None where a group has no mean.
    """
    groups = population.groups
    mean, _ = population.group_moments
    if not np.isfinite(mean).all():
        return relations
    values = {**scales, **dict(zip(population.names, map(float, np.exp(mean)), strict=True))}
    plain = _groups_as_unknowns(groups)
    y = sampled_response(plain, values, u, step)(values)
    slopes = output_sensitivity(plain, values, u, step)
    size = np.sqrt((slopes**2).mean(axis=0) / max(float((y**2).mean()), 1e-300))
    moves = {one.name: float(x) for one, x in zip(plain.unknowns, size, strict=True)}

    def lossy(one: Relation) -> Relation:
        return replace(one, loss=one.scatter * moves.get(one.groups[-1], 0.0))

    parts = (relations.constraints, relations.discoveries, relations.candidates)
    return replace(
        relations,
        **dict(zip(("constraints", "discoveries", "candidates"), (tuple(map(lossy, p)) for p in parts),
                   strict=True)),
    )  # fmt: skip


def _groups_as_unknowns(groups: Groups) -> Reduction:
    """Every group its own unknown; one that a constraint gives follows from the others."""
    free = [g for g in groups.groups if g.name not in groups.constraints]
    unknowns = tuple(Unknown(g.name, "-", "log", "estimate", g.parameter) for g in free)
    substitution = {g.name: g.symbol for g in free} | dict(groups.constraints)
    return Reduction(groups, unknowns, substitution, sp.true)
