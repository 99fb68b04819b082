"""Every system of a table predicted from the others: are its groups where the population says?

Invariant: a system has no part in the population that predicts it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from similitude.populations.coordinates import Product
from similitude.populations.population import Population, refit

WIDE = 1.959964  # sds of a 95 % interval


@dataclass(frozen=True, eq=False)
class LeftOut:
    """What each system was against its prediction.

    Parameters
    ----------
    names : (q,) products.    rows : (k,) places of the systems that give at least one of them.
    away : (k, q) ln value minus prediction, over the sd of both; NaN where a system does not say.
    """

    names: tuple[str, ...]
    rows: NDArray[np.int64]
    away: NDArray[np.float64]

    @property
    def inside(self) -> dict[str, tuple[int, int]]:
        """Product -> systems inside their 95 % interval, systems that say."""
        known = np.isfinite(self.away)
        hit = known & (np.abs(np.where(known, self.away, 0)) <= WIDE)
        return {n: (int(hit[:, j].sum()), int(known[:, j].sum())) for j, n in enumerate(self.names)}

    @property
    def share(self) -> float:
        """Share of all predictions inside their 95 % intervals."""
        hits, said = np.array(list(self.inside.values())).sum(axis=0)
        return float(hits / said)


def leave_one_out(
    population: Population, products: Mapping[str, Product], *, rows: Sequence[int] | None = None
) -> LeftOut:
    """Predict each row from a population that never saw it, and knows nothing of it.

    Parameters
    ----------
    population : Population
    products : name -> product of parameters, to be predicted.
    rows : places of the rows; all where left out.

    Returns
    -------
    LeftOut
    """
    wanted = list(products.values())
    logs, noise = population.logs_of(wanted), _noise(population, wanted)
    chosen = [i for i in (range(len(logs)) if rows is None else rows) if np.isfinite(logs[i]).any()]
    away = np.full((len(chosen), len(wanted)), np.nan)
    for k, i in enumerate(chosen):
        weight = population.table.weight.copy()
        weight[i] = 0.0
        others = refit(population, replace(population.table, weight=weight))
        mean, covariance = others.moments(wanted, predictive=True)
        away[k] = (logs[i] - mean) / np.sqrt(np.diag(covariance) + noise[i])
    return LeftOut(tuple(products), np.array(chosen), away)


def _noise(population: Population, wanted: list[Product]) -> NDArray:
    """Variance (n, q) that the stated sds of a row's values put into the logs of products."""
    table = population.table
    with np.errstate(invalid="ignore"):
        relative = np.where(np.isfinite(table.sd), table.sd / table.value, 0.0)
    result = np.zeros((len(table), len(wanted)))
    for j, column in enumerate(table.products):
        if len(column) == 1:
            (name,) = column
            powers = np.array([float(one.get(name, 0)) for one in wanted])
            result += relative[:, j : j + 1] ** 2 * powers**2
    return result
