"""The bound: never above the prior, less with more data, and met by least squares where that is linear."""

import numpy as np

from similitude.paper.claims_figure_5 import CHANGES, least_sd
from similitude.paper.drives import prior_of, square


def test_the_bound_begins_below_the_prior_and_falls_while_the_stiffness_stays():
    sd, drive = least_sd(), square()
    assert sd[0] <= prior_of(drive.scenario.name).std[0]
    for first, last in zip((0.0, *CHANGES), (*CHANGES, 60.0), strict=True):
        within = sd[drive.during(first, last)]
        assert np.all(np.diff(within) <= 1e-12)


def test_a_new_stiffness_is_new():
    sd, drive = least_sd(), square()
    for at in CHANGES[2:]:
        i = int(np.searchsorted(drive.t, at))
        assert sd[i] >= sd[i - 1] * 0.9


def test_the_bound_at_the_end_is_small_but_not_nothing():
    assert 1e-3 < least_sd()[-1] < 0.02
