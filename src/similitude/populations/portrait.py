"""Everything a report says of a population: computed once, shown by JSON, terminal and page.

Invariant: values that no row teaches are None, never a number.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.populations.coordinates import Product
from similitude.populations.distribution import Distribution, describe
from similitude.populations.monomial import monomial_text
from similitude.populations.observed import observed_groups
from similitude.populations.population import Population
from similitude.populations.relations import Relation, Relations, relate

DRAWS = 60  # of the bootstrap
FEWEST_TO_TEST = 8  # systems below which chance cannot be excluded whatever they do


@dataclass(frozen=True, eq=False)
class Portrait:
    """A population in numbers.

    Parameters
    ----------
    population, relations
    products : name -> exponents, of the model's groups and of those the columns give instead
    values : name -> (n,) values of each row, NaN where the row does not say
    distributions : name -> Distribution, of `products` and of the raw columns
    mean, sd : (q,) of ln groups from the fitted Gaussian, NaN where not taught; ends (q, 2)
    """

    population: Population
    relations: Relations
    products: Mapping[str, Product]
    values: Mapping[str, NDArray[np.float64]]
    distributions: Mapping[str, Distribution]
    mean: NDArray[np.float64]
    covariance: NDArray[np.float64]
    mean_ends: NDArray[np.float64]
    sd_ends: NDArray[np.float64]

    @property
    def shown_relations(self) -> tuple[Relation, ...]:
        """Constraints, discoveries, and what so few systems show that no test could prove it."""
        few = tuple(one for one in self.relations.candidates if one.n < FEWEST_TO_TEST)
        return (*self.relations, *few)

    @property
    def notes(self) -> list[str]:
        """What a reader must know before believing a number."""
        population = self.population
        names, count = population.space.names, population.gaussian.count
        said = [
            f"{name} is told by no row: held at {'one half' if name.startswith('logit') else 'one'}"
            for name, n in zip(names, count, strict=True) if n == 0
        ]  # fmt: skip
        stated = ", ".join(f"{n} = {v:g} SI" for n, v in population.at.items())
        if stated:
            said.append(f"groups are stated at {stated}; signals are no property of a system")
        if population.table.unused:
            said.append(f"columns not used: {', '.join(population.table.unused)}")
        for name, x in self.values.items():
            known = x[np.isfinite(x)]
            if len(known) >= 10 and (distinct := len(np.unique(np.round(known, 4)))) < 0.5 * len(known):
                said.append(
                    f"{len(known)} values of {name} are {distinct} distinct ones: perhaps typed copies"
                )
        return said


def portray(population: Population, *, draws: int = DRAWS) -> Portrait:
    """Compute everything that is said of a population.

    Parameters
    ----------
    population : Population
    draws : of the bootstrap; 0 for no intervals.
    """
    products = {g.name: g.exponents for g in population.groups.groups} | observed_groups(population)
    logs = population.logs_of(list(products.values()))
    values = {name: np.exp(logs[:, j]) for j, name in enumerate(products)}
    table = population.table
    found = {name: describe(name, x, table.weight) for name, x in values.items()}
    raw = {
        monomial_text(p): describe(monomial_text(p), table.value[:, j], table.weight)
        for j, p in enumerate(table.products)
    }
    mean, covariance = population.moments(list(products.values()))
    nothing = np.full((len(products), 2), np.nan)
    ends = (nothing, nothing)
    if draws:
        ends = population.intervals(draws, products=list(products.values()))
    return Portrait(
        population, relate(population), products, values,
        {n: d for n, d in (found | raw).items() if d is not None}, mean, covariance, *ends,
    )  # fmt: skip


def portrait_record(portrait: Portrait) -> dict[str, Any]:
    """What `similitude population --json` prints.

    Returns
    -------
    dict     schema, rows, weight, sources, at, groups, covariance_log, relations, tried, notes
    """
    names, table = list(portrait.products), portrait.population.table
    return {
        "schema": 1,
        "table": table.name,
        "rows": len(table),
        "weight": float(table.weight.sum()),
        "sources": _counted(table.sources),
        "at": dict(portrait.population.at),
        "groups": {name: _group(portrait, j) for j, name in enumerate(names)},
        "raw": {n: _described(d) for n, d in portrait.distributions.items() if n not in portrait.products},
        "covariance_log": {
            "names": names,
            "matrix": [[_number(x) for x in row] for row in portrait.covariance],
        },
        "relations": [relation_record(one) for one in portrait.shown_relations],
        "relations_tried": portrait.relations.tried,
        "false_discoveries_accepted": portrait.relations.level,
        "notes": portrait.notes,
    }


def relation_record(one: Relation) -> dict[str, Any]:
    """One relation as JSON."""
    return {
        "kind": one.kind,
        "groups": list(one.groups),
        "text": one.text,
        "coefficients": one.coefficients,
        "interval": [_number(x) for x in one.interval],
        "scatter": _number(one.scatter),
        "out_of_sample": _number(one.out_of_sample),
        "n": one.n,
        "p": one.p,
        "q": one.q,
        "given_base": one.given_base,
        "found": one.found,
        "loss": one.loss,
    }


def _group(portrait: Portrait, j: int) -> dict[str, Any]:
    name = list(portrait.products)[j]
    described = portrait.distributions.get(name)
    return {
        "formula": monomial_text(portrait.products[name]),
        "n": 0 if described is None else described.n,
        "mean_log": _number(portrait.mean[j]),
        "sd_log": _number(np.sqrt(portrait.covariance[j, j])),
        "mean_log_interval": [_number(x) for x in portrait.mean_ends[j]],
        "sd_log_interval": [_number(x) for x in portrait.sd_ends[j]],
        **{key: None if described is None else getattr(described, key)
           for key in ("skew_raw", "skew_log", "normal_raw", "normal_log")},
    }  # fmt: skip


def _described(d: Distribution) -> dict[str, Any]:
    keys = ("n", "mean_log", "sd_log", "skew_raw", "skew_log", "normal_raw", "normal_log", "below_zero")
    return {key: getattr(d, key) for key in keys}


def _counted(sources: tuple[str, ...]) -> dict[str, int]:
    return {source: sources.count(source) for source in sorted(set(sources))}


def _number(x: float) -> float | None:
    return float(x) if np.isfinite(x) else None
