"""Figure 5: pinned, and the lag by simulation."""

import numpy as np
import pytest

from similitude.paper.claims_discrete import recursion
from similitude.paper.claims_figure_5 import figure_5_claims, tracking, updates_to_cover
from similitude.paper.drives import square

from .pinned import DRIVEN, check


def test_claims_are_the_pinned_ones():
    check("Figure 5", figure_5_claims(), relative=DRIVEN)


@pytest.mark.parametrize("forgetting", [0.99, 0.999])
def test_the_lag_of_forgetting_by_simulation(forgetting):
    n = round(updates_to_cover(0.9, forgetting))
    before = 20_000
    y = np.append(np.zeros(before), np.ones(n))

    assert recursion(y, np.ones(y.size), forgetting=forgetting)[0] == pytest.approx(0.9, abs=0.01)


def test_a_perfect_reader_tracks_perfectly():
    drive = square()
    found = tracking(drive.K, np.full(drive.t.size, 0.1))

    assert found["rms"] == 0 and found["coverage"] == 1 and found["half_way"] == 0
