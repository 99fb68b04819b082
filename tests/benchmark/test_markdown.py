"""The tables of docs/benchmark.md are those of the committed result, and every number in it is there."""

import pathlib

import pytest

from similitude.benchmark.cells import cells
from similitude.benchmark.markdown import markdown, table
from similitude.benchmark.result_files import read_result

from .small_result import small_result

DOCS = pathlib.Path(__file__).parents[2] / "docs"


def test_the_page_holds_the_committed_result():
    result = read_result(DOCS / "benchmark.json")
    page = (DOCS / "benchmark.md").read_text(encoding="utf-8")

    assert markdown(result) in page


def test_the_committed_result_has_its_seed_and_every_cell_of_its_part():
    record = read_result(DOCS / "benchmark.json").record
    wanted = cells(quick=False, foreign=record["foreign"] is not None, part=record["part"])
    found = {(r["manoeuvre"], r["plant"], r["fault"]) for r in record["rows"]}

    assert isinstance(record["seed"], int) and not record["quick"]
    assert found == {(c.manoeuvre, c.plant, c.fault) for c in wanted}


def test_a_table_has_a_line_a_row():
    text = table([{"a": "x", "n": 1}, {"a": "y", "n": 2}], "a", {"twice": lambda row: str(2 * row["n"])})

    assert text.splitlines() == ["| a | twice |", "| --- | --- |", "| x | 2 |", "| y | 4 |"]


def test_every_estimator_is_in_the_tables():
    text = markdown(small_result())

    assert text.count("| population |") == 3 and "slalom, linear, bias" in text


@pytest.mark.parametrize("name", ["benchmark.json", "benchmark.md"])
def test_the_files_are_there(name):
    assert (DOCS / name).is_file()
