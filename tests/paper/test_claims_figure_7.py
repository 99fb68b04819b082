"""Figure 7 and the scheduled gain: pinned, and what the two belts share."""

import numpy as np
import pytest

from similitude.paper.claims_figure_7 import excursions, figure_7_claims
from similitude.paper.drives import belt, belt_scheduled

from .pinned import DRIVEN, check


@pytest.mark.slow
def test_claims_are_the_pinned_ones():
    check("Figure 7 and the scheduled gain", figure_7_claims(), relative=DRIVEN)


@pytest.mark.slow
def test_both_vehicles_come_back_and_meet_the_same_belt():
    for drive in (belt(), belt_scheduled()):
        assert excursions(drive, 95.0, 110.0)["most"] < 0.05
    assert np.array_equal(belt().wanted, belt_scheduled().wanted)
    assert not np.array_equal(belt().delta, belt_scheduled().delta)
