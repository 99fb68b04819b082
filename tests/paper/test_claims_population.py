"""Claims of eq 18 and Figures 2 and 3, several of them by another route."""

import csv
import math
from pathlib import Path

import numpy as np
import pytest

from similitude.paper import printed
from similitude.paper.claims_population import (
    moved,
    origin_slopes,
    poles,
    population_claims,
    share_below_zero,
)

from .pinned import check

DATA = Path(__file__).parents[2] / "data"


def test_claims_are_the_pinned_ones():
    check("Populations", population_claims())


def test_the_share_below_zero_by_drawing():
    Iz = np.array([float(row["Izz [kg m^2]"]) for row in csv.DictReader(open(DATA / "lvipd_204.csv"))])
    drawn = np.random.default_rng(0).normal(Iz.mean(), Iz.std(ddof=1), 200_000)

    assert share_below_zero(Iz) == pytest.approx(np.mean(drawn < 0), rel=0.1)


def test_slopes_through_the_origin():
    x = np.array([1.0, 2.0, 3.0])
    exact = origin_slopes(x, 1.1 * x)
    assert exact["ols"] == pytest.approx(1.1) == exact["tls"] and exact["sd"] == pytest.approx(0, abs=1e-12)
    noisy = origin_slopes(x, np.array([1.3, 2.0, 3.4]))
    grid = np.linspace(0.8, 1.5, 70001)
    across = ((grid[:, None] * x - [1.3, 2.0, 3.4]) ** 2).sum(axis=1) / (1 + grid**2)
    assert noisy["tls"] == pytest.approx(grid[across.argmin()], abs=2e-5)


def test_poles_are_those_of_the_state_matrix():
    v = printed.TEST_VEHICLE
    m, Iz, U, a, b, Cf, Cr = (v[n] for n in ("m", "Iz", "U", "a", "b", "Caf", "Car"))
    A = [
        [-(Cf + Cr) / (m * U), (b * Cr - a * Cf) / (m * U) - U],
        [(b * Cr - a * Cf) / (Iz * U), -(a * a * Cf + b * b * Cr) / (Iz * U)],
    ]

    assert np.sort_complex(poles(v)) == pytest.approx(np.sort_complex(np.linalg.eigvals(A)))


def test_the_average_slope_is_that_of_five_cars():
    rows = [
        r
        for r in csv.DictReader(open(DATA / "vehicles_literature.csv"))
        if r["Caf [N/rad]"] and float(r["m [kg]"]) > 500
    ]
    k = [float(r["Car [N/rad]"]) / float(r["Caf [N/rad]"]) for r in rows]
    found = {c.id: c for c in population_claims()}

    assert found["sec4-scatter"].ours == pytest.approx(np.std(np.log(k), ddof=1), abs=0.01)
    assert math.isclose(found["eq18-slope"].printed, 1.0977)


def test_the_average_of_the_first_thirty_moves_as_said():
    """By drawing fleets of 700 and comparing the mean of their first 30 with that of all."""
    fleets = np.random.default_rng(1).normal(1.0, 0.1, (20_000, 700))

    assert moved(0.1) == pytest.approx(np.std(fleets[:, :30].mean(axis=1) - fleets.mean(axis=1)), rel=0.02)
