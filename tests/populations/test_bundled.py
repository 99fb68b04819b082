"""The bundled tables are sorted whole: nothing twice, nothing lost without a reason."""

import pathlib

import numpy as np
import pytest

from similitude.populations.bundled import LEFT_OUT, bundled_tables
from similitude.systems.bicycle import BICYCLE

DATA = pathlib.Path(__file__).parents[2] / "data"
ROWS = 204 + 199 + 13


@pytest.fixture(scope="module")
def tables():
    return bundled_tables(DATA, BICYCLE)


def test_every_row_is_in_one_population_or_left_out_by_name(tables):
    assert sum(map(len, tables.values())) == ROWS - len(LEFT_OUT)
    labels = [label for table in tables.values() for label in table.labels]
    assert not set(labels) & set(LEFT_OUT)


def test_pickups_and_vans_are_trucks_and_sedans_are_cars(tables):
    trucks, cars = " ".join(tables["light_trucks"].labels), " ".join(tables["passenger_cars"].labels)
    assert all(name in trucks for name in ("FORD_F_150_MK14", "Caravan", "VW Vanagon", "pickup"))
    assert all(name in cars for name in ("TOYOTA_RAV4", "Taurus", "BMW M8", "HONDA_CIVIC"))


def test_copies_count_once_together(tables):
    table = tables["passenger_cars"]
    share = table.value[:, table.names.index("a/L")]
    gm = [i for i, label in enumerate(table.labels) if label.startswith("gm ") and share[i] == 0.4]

    assert len(gm) > 5 and table.weight[gm].sum() <= 1.0 + 1e-9
    assert np.all(table.weight <= 1.0)


def test_every_row_has_a_source(tables):
    assert all(source for table in tables.values() for source in table.sources)
