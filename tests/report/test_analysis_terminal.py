"""The page of an analysis shows each part, on a narrow terminal too."""

import io

import pytest
from rich.console import Console

from similitude.report.analysis_terminal import print_analysis

from .analysis_case import analysed, decay


def printed(found, width=80):
    console = Console(file=io.StringIO(), width=width, highlight=False)
    print_analysis(found, console)
    return console.file.getvalue()


def test_every_part_of_a_bicycle_is_there():
    text = printed(analysed("bicycle"))

    for part in (
        "Caf L/(m U²)",
        "dv*/dt*",
        "-S_U - 2 S_Caf - 2 S_Car + S_t = -1",
        "0, proven",
        "After the rewrite every row is empty",
        "4 in all, 3 of them units; checked at random points.",
        "v, r, δ",
        "m, Caf, Car, Iz scaled together",
        "r = r* · U/L",
    ):
        assert part in text


@pytest.mark.parametrize("width", [60, 80, 120])
def test_no_line_is_wider_than_the_terminal(width):
    assert max(map(len, printed(analysed("bicycle"), width).splitlines())) <= width


def test_a_model_without_a_base_is_shown_with_the_reason():
    text = " ".join(printed(decay()).split())

    assert "No base of parameters: " in text
    assert "x [m]" in text
    assert "what is added along a - b" in text
    assert "decay · one state, one output, two parameters" in text


def test_a_scale_that_divides_is_written_as_a_quotient():
    assert "t = t*/kcat" in " ".join(printed(analysed("michaelis_menten"), 200).split())
