"""Population: a table of similar systems, its groups, and the Gaussian they are drawn from.

Invariant: a group of a row is a number only where the row's own values give it; where they do not,
the Gaussian knows more, and `gaussian.rows` says it with its uncertainty.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.groups import Groups
from similitude.populations.coordinates import Coordinates, Product, coordinates_of
from similitude.populations.distribution import Distribution, describe
from similitude.populations.gaussian import FEWEST, Gaussian, fit_gaussian
from similitude.populations.table import PopulationTable, joined, read_population_table

BOOTSTRAP_PASSES = 60  # of a fit that begins at that of all rows


@dataclass(frozen=True, eq=False)
class Population:
    """A table, the model and base it is read in, and what it says.

    Parameters
    ----------
    groups : Groups             model and base.
    table : PopulationTable     n rows.
    at : signal -> value [SI] at which groups are stated.
    space, gaussian             coordinates and their distribution.
    """

    groups: Groups
    table: PopulationTable
    at: Mapping[str, float]
    space: Coordinates
    gaussian: Gaussian

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the groups."""
        return tuple(g.name for g in self.groups.groups)

    def product(self, name: str) -> Product:
        """Exponents of a group over the parameters."""
        return {g.name: g.exponents for g in self.groups.groups}[name]

    @cached_property
    def logs(self) -> NDArray[np.float64]:
        """Logarithms (n, groups) that the rows' own values give, NaN elsewhere."""
        return self.logs_of([g.exponents for g in self.groups.groups])

    def logs_of(self, products: list[Product]) -> NDArray[np.float64]:
        """Logarithms (n, q) of products of parameters, NaN where a row does not know enough."""
        wanted, extra = self.space.exponents(products)
        exponents, fixed = self.space.exponents(self.table.products)
        values = np.log(self.table.value) - fixed
        result = np.full((len(self.table), len(products)), np.nan)
        known = np.isfinite(values)
        for pattern in np.unique(known, axis=0):
            index = np.flatnonzero((known == pattern).all(axis=1))
            E, y = exponents[pattern], values[np.ix_(index, pattern)]
            E, y = self._completed(E, y)
            if not len(E):
                continue
            combination, *_ = np.linalg.lstsq(E.T, wanted.T, rcond=None)  # (k, q)
            told = np.abs(E.T @ combination - wanted.T).max(axis=0) < 1e-9
            result[np.ix_(index, told)] = (y @ combination + extra)[:, told]
        return result

    def _completed(self, E: NDArray, y: NDArray) -> tuple[NDArray, NDArray]:
        """What is known, with the third of whole, part and rest where two of them are."""
        parameters = self.space.parameters
        for whole, part, rest in self.space.triples:
            one = np.eye(len(parameters))[[parameters.index(n) for n in (whole, part, rest)]]
            combination, *_ = np.linalg.lstsq(E.T, one.T, rcond=None) if len(E) else (np.zeros((0, 3)),)
            told = np.abs(E.T @ combination - one.T).max(axis=0) < 1e-9 if len(E) else np.zeros(3, bool)
            if told.sum() != 2:
                continue
            w, p, r = (np.exp(y @ combination)).T
            third = [p + r, w - r, w - p][int(np.flatnonzero(~told)[0])]
            with np.errstate(invalid="ignore", divide="ignore"):
                y = np.column_stack([y, np.log(third)])
            E = np.vstack([E, one[~told]])
        return E, y

    @cached_property
    def distributions(self) -> dict[str, Distribution]:
        """Of each group that two rows or more know, raw and in logarithms, and of each raw column."""
        found = {n: describe(n, np.exp(self.logs[:, j]), self.table.weight) for j, n in enumerate(self.names)}
        for j, name in enumerate(self.table.names):
            found.setdefault(name, describe(name, self.table.value[:, j], self.table.weight))
        return {name: one for name, one in found.items() if one is not None}

    def moments(self, products: list[Product], *, predictive: bool = False) -> tuple[NDArray, NDArray]:
        """Mean (q,) and covariance (q, q) of the logarithms of products; NaN where no row teaches one.

        ``predictive``: of the next system, wider by what few rows leave open.
        """
        wanted, extra = self.space.exponents(products)
        slopes = wanted @ self.space.slopes(self.gaussian.mean)
        mean = wanted @ self.space.logs(self.gaussian.mean) + extra
        own = self.gaussian.predictive if predictive else self.gaussian.covariance
        covariance = slopes @ own @ slopes.T
        unknown = self.gaussian.count < FEWEST
        lost = (np.abs(slopes[:, unknown]) > 1e-9).any(axis=1)
        mean[lost] = np.nan
        covariance[lost, :] = covariance[:, lost] = np.nan
        return mean, covariance

    @cached_property
    def group_moments(self) -> tuple[NDArray, NDArray]:
        """Mean (q,) and covariance (q, q) of ln groups."""
        return self.moments([g.exponents for g in self.groups.groups])

    def resampled(self, seed: int) -> Population:
        """The same from as many rows, drawn with replacement among rows that know the same."""
        known, rng = np.isfinite(self.table.value), np.random.default_rng(seed)
        kinds = known if self.table.stratum is None else np.column_stack([known, self.table.stratum])
        _, kind = np.unique(kinds, axis=0, return_inverse=True)
        kind = kind.ravel()
        alike = [np.flatnonzero(kind == k) for k in range(kind.max() + 1)]
        draw = np.concatenate([rng.choice(rows, len(rows)) for rows in alike])
        return refit(self, self.table.rows(np.sort(draw)))

    def intervals(
        self, draws: int = 100, *, seed: int = 0, products: list[Product] | None = None
    ) -> tuple[NDArray, NDArray]:
        """95 % bootstrap intervals of mean (q, 2) and sd (q, 2) of ln groups, or of other products."""
        wanted = products or [g.exponents for g in self.groups.groups]
        drawn = [self.resampled(seed + i).moments(wanted) for i in range(draws)]
        means = np.array([mean for mean, _ in drawn])
        sds = np.array([np.sqrt(np.diag(covariance)) for _, covariance in drawn])
        own = np.sqrt(np.diag(self.moments(wanted)[1]))
        with np.errstate(divide="ignore"):
            # Reflected in the logarithm: an sd of resampled rows is low as that of the rows is.
            reflected = 2 * np.log(own) - np.log(sds)
        return _percentiles(means), np.exp(_percentiles(reflected))


def _percentiles(drawn: NDArray) -> NDArray:
    """2.5 and 97.5 % of each column, (q, 2), NaN where a column has no numbers."""
    ends = np.full((drawn.shape[1], 2), np.nan)
    taught = np.isfinite(drawn).any(axis=0)
    ends[taught] = np.nanpercentile(drawn[:, taught], (2.5, 97.5), axis=0).T
    return ends


def populate(
    groups: Groups,
    table: PopulationTable,
    *,
    at: Mapping[str, float] | None = None,
    products: Mapping[str, Product] | None = None,
) -> Population:
    """Make a population of a table.

    Parameters
    ----------
    groups : Groups    model and base, from `reparameterize`.
    table : PopulationTable
    at : signal -> value [SI] at which groups are stated; 1 where left out.
    products : name -> product, coordinates towards whose independence the covariance is drawn;
        the base and the groups where left out.

    Returns
    -------
    Population
    """
    space = coordinates_of(groups, at=at, products=products)
    stated = {n: float(np.exp(v)) for n, v in space.signals.items()}
    return Population(groups, table, stated, space, fit_gaussian(table, space))


def refit(population: Population, table: PopulationTable) -> Population:
    """The population of other rows, begun where this one ended."""
    fit = fit_gaussian(table, population.space, start=population.gaussian, passes=BOOTSTRAP_PASSES)
    return replace(population, table=table, gaussian=fit)


def read_population(
    path: str | Path | list[str | Path],
    groups: Groups,
    *,
    columns: Mapping[str, str] | None = None,
    at: Mapping[str, float] | None = None,
    products: Mapping[str, Product] | None = None,
) -> Population:
    """Read tables of similar systems and fit their population.

    Parameters
    ----------
    path : CSV or Parquet file, or several.
    groups : Groups     model and base, from `reparameterize`.
    columns, at, products : as in `read_population_table` and `populate`.

    Returns
    -------
    Population

    Raises
    ------
    LogError, UnitError, UsageError    as `read_population_table`.
    """
    paths = list(path) if isinstance(path, (list, tuple)) else [path]
    tables = [read_population_table(p, groups.model, columns=columns) for p in paths]
    table = tables[0] if len(tables) == 1 else joined(tables, name=" + ".join(t.name for t in tables))
    return populate(groups, table, at=at, products=products)
