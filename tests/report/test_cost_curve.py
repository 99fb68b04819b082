"""The steering lag in one line, and its cost curve as bars."""

import numpy as np

from similitude.report.cost_curve import BARS, cost_curve
from similitude.steer_lag import LagScan


def scan(lags, cost, chosen, origin="found in the log"):
    return LagScan(np.asarray(lags, float), np.asarray(cost, float), chosen, origin)


def test_a_known_lag_is_one_line_without_bars():
    text = cost_curve(scan([], [], 0.05, "vehicle file")).plain
    assert text == "50 ms   vehicle file"


def test_the_lowest_bar_stands_at_the_best_lag():
    lags = np.arange(0, 0.251, 0.01)
    text = cost_curve(scan(lags, 40 * (lags - 0.07) ** 2 / 0.01, 0.07)).plain
    bars = [c for c in text.splitlines()[1] if c in BARS]
    assert len(bars) == len(lags)
    assert bars[7] == BARS[0]
    assert bars[-1] == BARS[-1]


def test_a_flat_curve_says_that_the_log_cannot_tell():
    assert "cannot tell" in cost_curve(scan([0, 0.1, 0.2], [0.0, 0.2, 0.1], 0.0)).plain


def test_a_sharp_curve_says_that_others_fit_worse():
    assert "clearly worse" in cost_curve(scan([0, 0.1, 0.2], [30.0, 0.0, 30.0], 0.1)).plain


def test_costs_that_are_not_finite_are_left_out():
    text = cost_curve(scan([0, 0.1, 0.2, 0.3], [np.inf, 0.0, 9.0, 9.0], 0.1)).plain
    assert sum(c in BARS for c in text) == 3
