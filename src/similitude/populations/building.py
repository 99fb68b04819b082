"""Builds the shipped populations from the bundled tables.

    K = Caf L/m [m^2/s^2]    pi1 = a/L    eta = Car b/(Caf a)    rho = Iz/(m a b)

Coordinates are ln m, ln L, ln K, logit pi1, ln eta, ln rho: the ones that the tables themselves show to
cluster (`similitude.relate`). Where the hand-set prior of the science page is kept, the tables' own
value stands beside it, and `origin` says why.

Invariant: equal tables give equal numbers, digit for digit.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from similitude.groups import Groups
from similitude.populations.bundled import SOURCES, bundled_tables
from similitude.populations.coordinates import Product
from similitude.populations.population import Population, populate
from similitude.populations.table import PopulationTable, joined

NAMES = ("m", "L", "K", "pi1", "eta", "rho")
KINDS = ("log", "log", "log", "linear", "log", "log")
PRODUCTS: dict[str, Product] = {
    "K": {"Caf": Fraction(1), "L": Fraction(1), "m": Fraction(-1)},
    "eta": {"Car": Fraction(1), "b": Fraction(1), "Caf": Fraction(-1), "a": Fraction(-1)},
    "rho": {"Iz": Fraction(1), "m": Fraction(-1), "a": Fraction(-1), "b": Fraction(-1)},
}
PI1: Product = {"a": Fraction(1), "L": Fraction(-1)}
DRAWS = 60  # of the bootstrap
FEWEST = 4.0  # systems that must teach an unknown; below, it is everybody's
UNKNOWN_SIZE = 1.0  # sd of ln m and ln L of a population of fewer
DIGITS = 5  # of every number that is kept

# What identify rests on: means, and sds of the coordinates. The tables' own values stand beside them.
PAGE = {
    "passenger_cars": {"K": (145.68, 0.5), "pi1": (0.4431, 0.03), "eta": (1.42, 0.13), "rho": (1.017, 0.09)},
    "small_cars_1to10": {"K": (None, 0.7), "pi1": (0.45, 0.04), "eta": (1.6, 0.30), "rho": (0.95, 0.15)},
}
SMALL_K_PER_GL = 1.22  # K/(g L) of the paper's test vehicle [-]
PAPER = {"K": 145.68, "pi1": 0.4431, "k": 1.0977, "pi5": 0.2510}  # Brennan & Alleyne 2004, eq 18

PAPER_SOURCE = (
    "Brennan & Alleyne 2004, eq 18: averages of more than 700 vehicles; the paper prints no spread, so the "
    "spreads are those of passenger_cars"
)


def build_populations(data: Path, groups: Groups, *, draws: int = DRAWS) -> dict[str, dict[str, Any]]:
    """Build all shipped populations.

    Parameters
    ----------
    data : Path       folder of the bundled tables.
    groups : Groups   of the bicycle, base m, L, U.
    draws : of the bootstrap; 0 leaves intervals out.

    Returns
    -------
    dict              name -> what `shipped.json` keeps of it.
    """
    tables = bundled_tables(data, groups.model)
    big = joined([tables["passenger_cars"], tables["light_trucks"]], name="all_vehicles")
    everything = _say(groups, big)
    built = {"all_vehicles": _of_tables(everything, everything, big, draws)}
    for name, table in tables.items():
        said = _say(groups, table)
        if name in PAGE:
            built[name] = _of_page(name, said, table, draws)
        else:
            built[name] = _of_tables(said, everything, table, draws)
    paper = _of_page("passenger_cars", everything, big, 0)
    pi1 = PAPER["pi1"]
    paper["mean"][2:] = [
        PAPER["K"], pi1, _digits(PAPER["k"] * (1 - pi1) / pi1), _digits(PAPER["pi5"] / (pi1 * (1 - pi1)))
    ]  # fmt: skip
    paper |= {"rows": 0, "sources": [PAPER_SOURCE], "tables": {}}
    built["brennan_2004"] = paper
    order = ("passenger_cars", "light_trucks", "all_vehicles", "small_cars_1to10", "brennan_2004")
    return {name: built[name] for name in order}


def page_of(built: Mapping[str, Any]) -> str:
    """The text of `shipped.json`."""
    return json.dumps(built, indent=1, ensure_ascii=False) + "\n"


def bundled_population(groups: Groups, table: PopulationTable) -> Population:
    """The population of a bundled table, drawn towards independence of m, L, K, a/L, eta and rho."""
    return populate(groups, table, products=PRODUCTS)


def _say(groups: Groups, table: PopulationTable) -> Population:
    return bundled_population(groups, table)


def _of_tables(
    said: Population, everything: Population, table: PopulationTable, draws: int
) -> dict[str, Any]:
    """Means and predictive covariance as the tables have them; what they do not teach is everybody's."""
    own, other = _moments(said), _moments(everything)
    taught = _counts(said) > FEWEST
    mean = np.where(taught, own[0], other[0])
    sd = np.sqrt(np.where(taught, np.diag(own[1]), np.diag(other[1])))
    correlation = own[1] / np.outer(np.sqrt(np.diag(own[1])), np.sqrt(np.diag(own[1])))
    correlation = np.where(np.outer(taught, taught), correlation, np.eye(len(NAMES)))
    return _record(said, table, mean, sd, correlation, draws)


def _of_page(name: str, said: Population, table: PopulationTable, draws: int) -> dict[str, Any]:
    """The hand-set means and sds of the unknowns, no correlation; mass and wheelbase of the tables."""
    mean, covariance = _moments(said)
    sd = np.where(_counts(said) > FEWEST, np.sqrt(np.diag(covariance)), UNKNOWN_SIZE)
    for i, unknown in enumerate(NAMES[2:], start=2):
        value, sd[i] = PAGE[name][unknown]
        mean[i] = SMALL_K_PER_GL * 9.80665 * mean[1] if value is None else value
    record = _record(said, table, mean, sd, np.eye(len(NAMES)), draws)
    record["K_per_gL"] = SMALL_K_PER_GL if PAGE[name]["K"][0] is None else None
    return record


def _record(
    said: Population,
    table: PopulationTable,
    mean: np.ndarray,
    sd: np.ndarray,
    correlation: np.ndarray,
    draws: int,
) -> dict[str, Any]:
    own, counts = _moments(said), _counts(said)
    means, sds = _intervals(said, draws)
    tables = {
        name: {
            "mean": _digits(own[0][i]),
            "sd": _digits(np.sqrt(said_covariance(said)[i, i])),
            "predictive_sd": _digits(np.sqrt(own[1][i, i])),
            "systems": round(float(counts[i]), 1),
            "mean_interval": means[i],
            "predictive_sd_interval": sds[i],
        }
        for i, name in enumerate(NAMES)
        if counts[i] >= 2
    }
    return {
        "names": list(NAMES),
        "kinds": list(KINDS),
        "mean": [_digits(x) for x in mean],
        "sd": [_digits(x) for x in sd],
        "correlation": [[round(float(x), 3) for x in row] for row in correlation],
        "K_per_gL": None,
        "tables": tables,
        "rows": len(table),
        "sources": [SOURCES[name] for name in sorted(set(table.sources) & SOURCES.keys())],
    }


def _intervals(said: Population, draws: int) -> tuple[list, list]:
    """95 % bootstrap intervals of means and predictive sds, (6, 2) each."""
    if not draws:
        return [None] * len(NAMES), [None] * len(NAMES)
    ends = [_moments(said.resampled(i)) for i in range(draws)]
    both = ([m for m, _ in ends], [np.sqrt(np.diag(c)) for _, c in ends])
    return tuple(
        [[_digits(x) for x in pair] for pair in np.percentile(x, (2.5, 97.5), axis=0).T] for x in both
    )


def _counts(said: Population) -> np.ndarray:
    return said.gaussian.count[_places(said)]


def _places(said: Population) -> list[int]:
    names = said.space.names
    return [names.index(n) for n in ("ln m", "ln L", "ln K", "logit a/L", "ln eta", "ln rho")]


def said_covariance(said: Population, *, predictive: bool = False) -> np.ndarray:
    """Covariance (6, 6) of the kept coordinates: of the systems seen, or of the next one."""
    places, pi1 = _places(said), _share(said)
    covariance = said.gaussian.predictive if predictive else said.gaussian.covariance
    scale = np.array([1, 1, 1, pi1 * (1 - pi1), 1, 1])  # d(a/L)/d(logit)
    return covariance[np.ix_(places, places)] * np.outer(scale, scale)


def _share(said: Population) -> float:
    return float(1 / (1 + np.exp(-said.gaussian.mean[said.space.names.index("logit a/L")])))


def _moments(said: Population) -> tuple[np.ndarray, np.ndarray]:
    """Mean values (6,) and predictive covariance (6, 6) of the kept coordinates."""
    mean = np.exp(said.gaussian.mean[_places(said)])
    mean[3] = _share(said)
    return mean, said_covariance(said, predictive=True)


def _digits(x: float) -> float:
    return float(f"{x:.{DIGITS}g}")


def without(table: PopulationTable, row: int) -> PopulationTable:
    """The table with one row counting nothing."""
    weight = table.weight.copy()
    weight[row] = 0.0
    return replace(table, weight=weight)
