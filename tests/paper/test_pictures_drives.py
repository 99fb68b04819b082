"""Figures 5 and today's: drawn from the drive."""

import numpy as np

from similitude.paper.drives import square
from similitude.paper.pictures_drives import THIN, figure_5, today_5


def test_figure_5_shows_the_driven_place_and_every_change():
    top, middle, bottom = figure_5().axes
    drawn = next(line for line in top.lines if line.get_label() == "driven")
    assert np.array_equal(drawn.get_ydata(), square().y[THIN])
    for axes in (top, middle, bottom):
        upright = [line for line in axes.lines if len(set(line.get_xdata())) == 1]
        assert len(upright) == 5


def test_today_shows_the_bound():
    _, bottom = today_5().axes
    assert any("bound" in line.get_label() for line in bottom.lines)
