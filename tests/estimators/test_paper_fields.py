"""One loop runs both estimators: same samples, and outputs that begin alike."""

from similitude.estimators import filter_fields, paper_fields
from similitude.estimators.paper_model import regression
from similitude.program.library import shipped
from similitude.systems.bicycle import bicycle_reduction


def test_outputs_begin_as_those_of_the_population_filter():
    r = regression(bicycle_reduction())
    alike = filter_fields.estimate_fields(r.layout)

    assert paper_fields.output_fields(r)[: len(alike)] == alike
    assert [f.name for f in paper_fields.output_fields(r)[len(alike) :]] == ["pi3"]


def test_shipped_layouts_agree():
    paper, population = shipped("bicycle_paper"), shipped("bicycle_population")

    assert paper.layout.SAMPLE == population.layout.SAMPLE
    assert paper.layout.OUTPUT[:5] == population.layout.OUTPUT[:5]
    assert paper.layout.STATUS == population.layout.STATUS


def test_every_real_has_a_unit_and_a_meaning():
    r = regression(bicycle_reduction())
    fields = (*paper_fields.config_fields(r), *paper_fields.state_fields(r))

    assert all(f.unit and f.meaning for f in fields)
    assert [f.size for f in fields if f.name.startswith("poles")] == [2, 2]
