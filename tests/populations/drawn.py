"""Tables drawn from a known population of cars, for tests and for the measurements in scripts/."""

from fractions import Fraction

import numpy as np

from similitude.populations.table import PopulationTable
from similitude.systems.bicycle import BICYCLE

PARAMETERS = ("m", "L", "a", "Iz", "Caf", "Car")


def independent(n, seed):
    """Raw parameters of n cars, independent of one another but for a being a share of L; (n, 6) SI."""
    rng = np.random.default_rng(seed)
    L = np.exp(rng.normal(1.0, 0.1, n))
    return np.column_stack([
        np.exp(rng.normal(7.3, 0.25, n)), L, L * rng.normal(0.44, 0.03, n),
        np.exp(rng.normal(7.8, 0.3, n)), np.exp(rng.normal(11.4, 0.3, n)), np.exp(rng.normal(11.5, 0.3, n)),
    ])  # fmt: skip


def planted(n, seed, *, slope=1.0977, scatter=0.03, outliers=0.1):
    """The same with pi4 = slope pi3, scattered, and a share of rows where it does not hold at all."""
    rng = np.random.default_rng(seed + 10_000)
    values = independent(n, seed)
    wild = rng.random(n) < outliers
    tied = slope * values[:, 4] * np.exp(scatter * rng.standard_normal(n))
    values[:, 5] = np.where(wild, tied * np.exp(rng.normal(0, 0.7, n)), tied)
    return values


def axles(n, seed, *, scatter=0.05):
    """Cars whose axles share one cornering coefficient ratio eta = 1.5, and Iz = 1.02 m a b."""
    rng = np.random.default_rng(seed + 20_000)
    values = independent(n, seed)
    m, L, a, _, Caf, _ = values.T
    values[:, 5] = 1.5 * Caf * a / (L - a) * np.exp(scatter * rng.standard_normal(n))
    values[:, 3] = 1.02 * m * a * (L - a) * np.exp(scatter * rng.standard_normal(n))
    return values


def table_of(values, parameters=PARAMETERS, **more):
    """A table of the bicycle's parameters, or of products of them given as mappings."""
    products = [{p: Fraction(1)} if isinstance(p, str) else p for p in parameters]
    n = len(values)
    return PopulationTable(
        "drawn", BICYCLE, tuple(products), values, np.full(values.shape, np.nan), np.ones(n),
        tuple(f"row {i + 1}" for i in range(n)), ("drawn",) * n, **more,
    )  # fmt: skip
