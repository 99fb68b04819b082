"""The cells: complete, different from each other in one thing, and drivable."""

import pytest

from similitude.benchmark.cells import (
    FAULT_MANOEUVRES,
    FAULT_PLANTS,
    FAULTS,
    MANOEUVRES,
    NOT_ON_LINEAR,
    TABLE_PLANTS,
    cells,
)
from similitude.benchmark.drives import scenario


def test_every_manoeuvre_meets_every_plant_once_and_every_fault_its_four_cells():
    every = cells(quick=False, foreign=True)
    table = {(c.manoeuvre, c.plant) for c in every if c.fault == "none"}
    faults = [c for c in every if c.fault != "none"]

    assert table == {(m, p) for m in MANOEUVRES for p in TABLE_PLANTS}
    assert len(set(every)) == len(every)
    expected = len(FAULTS) * len(FAULT_MANOEUVRES) * len(FAULT_PLANTS)
    assert len(faults) == expected - len(NOT_ON_LINEAR) * len(FAULT_MANOEUVRES)


def test_own_plants_have_twenty_seeds_and_foreign_ones_five():
    every = cells(quick=False, foreign=True)

    assert {c.seeds for c in every if not c.is_foreign} == {20}
    assert {c.seeds for c in every if c.is_foreign} == {5}
    assert not any(c.is_foreign for c in cells(quick=False, foreign=False))


@pytest.mark.parametrize("cell", cells(quick=False, foreign=True), ids=lambda c: c.name)
def test_every_cell_is_a_scenario_that_can_be_read(cell):
    if cell.is_foreign:
        pytest.importorskip("vehiclemodels")
    read = scenario(cell, "bmw_320i" if cell.is_foreign else "")

    assert read.timing.ticks * read.timing.step == pytest.approx(80, abs=0.02)


def test_the_parts_together_are_the_whole():
    table, faults, every = (cells(quick=False, foreign=True, part=p) for p in ("table", "faults", "all"))

    assert not set(table) & set(faults) and set(table) | set(faults) == set(every)


def test_making_a_scenario_leaves_the_tables_of_the_cells_as_they_were():
    one = cells(quick=True, foreign=False)[0]
    before = one.changes
    scenario(one)

    assert one.changes == before
