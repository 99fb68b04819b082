"""The four panels draw what the run holds."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from similitude.report import panels

from .example_run import example_run


@pytest.fixture
def axes():
    return Figure().add_subplot()


@pytest.mark.parametrize(
    "panel", [panels.estimate_panel, panels.yaw_panel, panels.innovation_panel, panels.information_panel]
)
def test_every_panel_draws_and_names_its_unit(axes, panel):
    run = example_run(400)
    panel(axes, run, run.trace.t - run.trace.t[0])
    assert axes.lines or axes.collections
    assert "[" in axes.get_ylabel()


def test_the_estimate_drawn_is_the_estimate(axes):
    run = example_run(400)
    panels.estimate_panel(axes, run, run.trace.t - run.trace.t[0])
    drawn = np.concatenate([np.asarray(line.get_ydata(), float) for line in axes.lines])
    assert np.isin(run.trace.K, drawn).mean() > 0.99


def test_the_prior_is_the_first_row_and_left_out_where_nothing_is_known():
    run = example_run(50)
    factor = np.exp(1.96 * run.trace.ln_K_std[0])
    assert panels.prior_of_K(run) == pytest.approx((run.trace.K[0] / factor, run.trace.K[0] * factor))


def test_faults_are_shaded_only_where_they_are(axes):
    t = np.arange(100) / 10
    panels.shade_faults(axes, t, np.zeros(100, int))
    assert not axes.patches and not axes.collections
