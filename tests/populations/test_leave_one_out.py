"""Systems left out of a Gaussian population are where it says, 95 times in a hundred."""

import numpy as np
import pytest

from similitude.populations.building import PI1, PRODUCTS
from similitude.populations.leave_one_out import leave_one_out
from similitude.populations.population import populate
from similitude.systems.bicycle import bicycle_groups

from .drawn import axles, table_of


@pytest.fixture(scope="module")
def result():
    values = axles(60, 0, scatter=0.1)
    values[30:, 4:] = np.nan
    return leave_one_out(
        populate(bicycle_groups(), table_of(values), products=PRODUCTS), {"pi1": PI1, **PRODUCTS}
    )


def test_predictions_cover(result):
    """180 predictions at 95 %: 90 % is three sds below."""
    assert 0.9 <= result.share <= 1.0
    assert {name: said for name, (_, said) in result.inside.items()} == {
        "pi1": 60,
        "K": 30,
        "eta": 30,
        "rho": 60,
    }


def test_distances_are_those_of_a_normal_distribution(result):
    known = result.away[np.isfinite(result.away)]
    assert abs(known.mean()) < 0.25 and known.std() == pytest.approx(1.0, abs=0.2)


def test_a_car_that_is_unlike_the_others_is_outside():
    values = axles(40, 1)
    values[7, 3] *= 3.0
    population = populate(bicycle_groups(), table_of(values), products=PRODUCTS)
    result = leave_one_out(population, {"rho": PRODUCTS["rho"]}, rows=[7, 8])
    assert abs(result.away[0, 0]) > 6 > 4 > abs(result.away[1, 0])
