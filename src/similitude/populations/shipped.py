"""The populations that travel with the package: who they are, and the prior of one of their systems.

Built from tables by `similitude.populations.building` and kept as numbers, so that whoever identifies
a car loads neither SymPy nor SciPy nor a table.

Invariant: what is loaded was built by the script of this repository; a test builds it anew.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from similitude.errors import UsageError, shown
from similitude.population import Prior

FILE = "shipped.json"
GRAVITY = 9.80665  # m/s^2


@dataclass(frozen=True, eq=False)
class ShippedPopulation:
    """One population.

    Parameters
    ----------
    name : str
    prior : Prior            of m, L and the unknowns K, pi1, eta, rho; K of a car of length L where
                             `per_length` is given
    per_length : float       mean K/(g L) [-], or None
    tables : mapping         unknown -> what the tables say: mean, sd, systems, intervals
    rows : int               rows of the tables; sources : where they come from
    """

    name: str
    prior: Prior
    per_length: float | None
    tables: Mapping[str, Mapping[str, Any]]
    rows: int
    sources: tuple[str, ...]

    def of_length(self, L: float) -> Prior:
        """Prior of a car of wheelbase L [m]."""
        if self.per_length is None:
            return self.prior
        mean = self.prior.mean.copy()
        mean[self.prior.names.index("K")] = self.per_length * GRAVITY * L
        return Prior(self.prior.names, self.prior.kinds, mean, self.prior.covariance, self.prior.origins)


def shipped_population(name: str) -> ShippedPopulation:
    """Load a population that travels with the package.

    Parameters
    ----------
    name : one of `shipped_names`.

    Returns
    -------
    ShippedPopulation

    Raises
    ------
    UsageError    there is none of that name.
    """
    if name not in _loaded():
        raise UsageError(
            f"population {shown(name)} is not known; there are {', '.join(_loaded())}",
            usually="it is a matter of spelling.",
            paste='population = "passenger_cars"',
            read='docs/populations.md, "Shipped populations"',
        )
    one = _loaded()[name]
    sd, correlation = np.array(one["sd"]), np.array(one["correlation"])
    prior = Prior(
        tuple(one["names"]),
        tuple(one["kinds"]),
        np.array(one["mean"]),
        correlation * np.outer(sd, sd),
        dict.fromkeys(one["names"], f"population {name}"),
    )
    return ShippedPopulation(name, prior, one["K_per_gL"], one["tables"], one["rows"], tuple(one["sources"]))


def shipped_names() -> tuple[str, ...]:
    """Names of the populations that travel with the package."""
    return tuple(_loaded())


@cache
def _loaded() -> dict[str, Any]:
    return json.loads(resources.files("similitude.populations").joinpath(FILE).read_text(encoding="utf-8"))
