"""Pictures of a population are drawn from little and from much, and hold what they say."""

import numpy as np
import pytest

from similitude.report.population_pictures import (
    distribution_picture,
    pairs_picture,
    png,
    running_average_picture,
)

X = np.exp(np.random.default_rng(0).normal(0.0, 0.5, (60, 3)))


def test_a_distribution_shows_both_spaces_and_what_a_symmetric_fit_puts_below_zero():
    figure = distribution_picture(X[:, 0], "pi5")
    left, right = figure.axes

    assert "skewness" in left.get_title(loc="left") and right.get_xlabel() == "ln π5"
    assert left.get_xlim()[0] < 0 and len(left.collections) == 1
    assert png(figure).startswith(b"\x89PNG")


def test_two_values_are_enough_for_a_picture():
    assert distribution_picture(np.array([1.0, 2.0, np.nan]), "m").axes[0].get_title(loc="left") == "n = 2"


def test_every_pair_is_drawn_once_and_rows_that_know_one_are_left_out():
    logs = np.log(X)
    logs[5:, 2] = np.nan
    figure = pairs_picture(logs, ("pi1", "pi2", "pi3"))
    drawn = [axes for axes in figure.axes if axes.get_visible()]

    assert len(drawn) == 3 and sorted(len(axes.lines[0].get_xdata()) for axes in drawn) == [5, 5, 60]
    assert pairs_picture(np.full((4, 2), np.nan), ("a", "b")) is None


def test_a_running_average_ends_at_the_average():
    (axes,) = running_average_picture({"K": X[:, 1]}).axes
    assert axes.lines[0].get_ydata()[-1] == pytest.approx(1.0)
