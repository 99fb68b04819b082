"""The two drives of the paper from their scenario files: what its figures show."""

import numpy as np
import pytest

from similitude.simulation.recording import run_scenario
from similitude.simulation.scenario import read_scenario


@pytest.mark.slow
def test_figure_5_overshoots_more_where_the_stiffness_is_halved():
    truth = run_scenario(read_scenario("square_closed_loop"), [0])[0].truth
    t, y, soft = truth["t [s]"], np.abs(truth["y [m]"]), truth["stiffness [-]"] < 1

    np.testing.assert_array_equal(soft, np.mod(t, 20) >= 10)
    assert truth["pi3 [-]"].max() == pytest.approx(0.27217, abs=5e-6)
    settled = t > 5
    assert y[settled & soft].max() > 1.2 * y[settled & ~soft].max() > 0.06


@pytest.mark.slow
def test_figure_7_changes_lanes_and_fish_tails_on_the_way_back():
    truth = run_scenario(read_scenario("treadmill"), [0])[0].truth
    t, y, r = truth["t [s]"], truth["y [m]"], np.abs(truth["r [rad/s]"])

    def during(first, last):
        return (t >= first) & (t < last)

    assert np.abs(y[during(0, 60)]).max() < 0.25  # the square of 15 cm, on the dry half
    assert np.abs(y[during(70, 85)] - 0.45).max() < 0.1  # on the wet half, held
    assert np.median(truth["friction [-]"][during(70, 85)]) == 0.06
    quiet = r[during(70, 85)].max()
    assert r[during(85, 88)].max() > 2 * quiet  # the tail swings as it comes back
    assert np.abs(y[during(95, 110)]).max() < 0.05 and truth["friction [-]"][-1] == 0.8
