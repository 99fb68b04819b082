"""One loop runs every estimator: same samples, and outputs that begin alike."""

import pytest

from similitude.estimators import filter_fields, ladder_fields
from similitude.estimators.second_order import second_order
from similitude.program.library import shipped
from similitude.systems.bicycle import bicycle_reduction
from similitude.units import parse_unit

from .ladder_case import LADDER, library


def test_outputs_begin_as_those_of_the_population_filter():
    model = second_order(bicycle_reduction())
    alike = filter_fields.output_fields(model.layout)
    found = ladder_fields.output_fields(model)

    assert found[: len(alike)] == alike
    assert [f.name for f in found[len(alike) :]] == ["unknowns"]


@pytest.mark.parametrize("name", LADDER)
def test_shipped_layouts_agree(name):
    mine, population = library(name).layout, shipped("bicycle_population").layout

    assert mine.SAMPLE == population.SAMPLE
    assert mine.OUTPUT[:6] == population.OUTPUT[:6]
    assert mine.STATUS == population.STATUS


@pytest.mark.parametrize("name", LADDER)
def test_every_real_has_a_unit_that_can_be_read_and_a_meaning(name):
    layout = library(name).layout
    for _, unit, meaning, _ in (*layout.CONFIG, *layout.STATE, *layout.OUTPUT):
        assert meaning
        parse_unit(unit.removeprefix("(").removesuffix(")^2"))
