"""The page and the terminal: every estimator and cell on them, strange names escaped, eighty characters."""

import io

from rich.console import Console

from similitude.benchmark.page import cell_name, page_of, print_result

from .small_result import small_result


def test_the_page_has_every_cell_and_no_foreign_markup():
    html = page_of(small_result())

    assert html.count("slalom, linear, bias") == 2
    assert "<b>mine</b>" not in html and "&lt;b&gt;mine&lt;/b&gt;" in html
    assert "left out" in html and "2 cells, 2 drives" in html


def test_equal_results_give_equal_pages():
    assert page_of(small_result()) == page_of(small_result())


def test_a_terminal_of_eighty_characters_holds_the_tables():
    out = io.StringIO()
    print_result(small_result(), Console(file=out, width=80, highlight=False))
    printed = out.getvalue()

    assert "…" not in printed and "never" in printed
    assert "slalom, linear, bias" in printed and "2 cells" in printed


def test_a_cell_is_named_in_words():
    row = {"manoeuvre": "double_lane_change", "plant": "multi_body", "fault": "none"}

    assert cell_name(row) == "double lane change, multi body"
