"""Figures 2 to 4 draw the tables and the lines."""

import numpy as np
import pytest

from similitude.paper.pictures_data import figure_2, figure_3, figure_4, seven_picture


@pytest.mark.parametrize("figure", [figure_2, figure_3])
def test_relative_frequencies_add_up_to_one(figure):
    (axes,) = figure().axes
    heights = np.array([bar.get_height() for bar in axes.patches if hasattr(bar, "get_height")])
    half = heights.size // 2

    assert heights[:half].sum() == pytest.approx(1, abs=0.01)  # the 204; every one has its class
    assert heights[half:].sum() == pytest.approx(1, abs=0.01)


def test_figure_4_spans_the_range_of_the_paper():
    top, _ = figure_4().axes
    x = top.lines[0].get_xdata()
    assert x[0] == pytest.approx(0.1) and x[-1] == pytest.approx(1.4)


def test_three_directions_have_no_end():
    left, _ = seven_picture().axes
    assert [text.get_text() for text in left.texts].count("∞") == 3
