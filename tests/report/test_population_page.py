"""The page of a population: strict HTML, every text escaped, the same bytes twice."""

import dataclasses
import io

import pytest
from rich.console import Console

from similitude.populations.population import populate
from similitude.populations.portrait import portray
from similitude.report.population_page import population_html, print_population
from similitude.systems.bicycle import bicycle_groups

from ..populations.drawn import planted, table_of


@pytest.fixture(scope="module")
def portrait():
    table = dataclasses.replace(table_of(planted(40, 0)), name="<b>cars</b>")
    return portray(populate(bicycle_groups(), table), draws=0)


def test_the_page_holds_groups_relations_and_pictures(portrait):
    page = population_html(portrait)

    assert "pi1 + pi2 = 1" in page and page.count("data:image/png;base64,") >= 4
    assert "<b>cars</b>" not in page and "&lt;b&gt;cars" in page


def test_the_terminal_says_the_same(portrait):
    said = io.StringIO()
    print_population(portrait, Console(file=said, width=100))

    assert "pi1 + pi2 = 1" in said.getvalue() and "relations were tried" in said.getvalue()
