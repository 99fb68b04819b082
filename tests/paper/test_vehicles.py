"""The packaged tables are those of data/, and say what the documentation of the tables says."""

from pathlib import Path

import numpy as np
import pytest

from similitude.paper.vehicles import TABLES, axles, inertias

DATA = Path(__file__).parents[2] / "data"


@pytest.mark.parametrize("name", ["lvipd_204.csv", "vehicles_literature.csv"])
def test_the_packaged_table_is_the_bundled_one(name):
    assert TABLES.joinpath(name).read_bytes() == (DATA / name).read_bytes()


def test_204_inertias_of_reasonable_cars():
    table = inertias()
    assert table.Iz.size == 204
    assert table.rho.mean() == pytest.approx(1.034, abs=0.001) and table.rho.std() == pytest.approx(
        0.093, abs=0.001
    )
    assert table.pi5(0.5) == pytest.approx(table.rho / 4)


def test_the_cars_of_the_literature_are_full_size():
    cars = axles()
    assert cars.mass.min() > 500 and cars.with_stiffness.sum() == 5
    assert np.all((cars.pi1 > 0.3) & (cars.pi1 < 0.6))
    k = cars.Car[cars.with_stiffness] / cars.Caf[cars.with_stiffness]
    assert k.mean() == pytest.approx(1.29, abs=0.005)
