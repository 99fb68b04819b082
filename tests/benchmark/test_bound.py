"""The bound: the prior's sd at first, less with more steer, and what a batch fit scatters by."""

import numpy as np

from similitude.benchmark.bound import bound_score, least_sd
from similitude.vehicle_prior import vehicle_prior

from .linear_drive import linear_drive


def test_before_anything_is_seen_the_bound_is_the_prior():
    drive, truth = linear_drive()

    assert np.isclose(least_sd(drive, truth)[0], vehicle_prior(drive.vehicle).std[0], rtol=1e-3)


def test_information_only_grows_until_the_change_and_again_after_it():
    drive, truth = linear_drive()
    sd = least_sd(drive, truth)

    assert (np.diff(sd[drive.t < 50.0]) <= 1e-12).all() and (np.diff(sd[drive.t > 50.05]) <= 1e-12).all()


def test_more_steer_tells_more_and_more_noise_less():
    small, large = (least_sd(*linear_drive(amplitude=a))[-1] for a in (0.001, 0.01))

    assert large < small


def test_the_score_holds_the_bound_and_claims_nothing():
    drive, truth = linear_drive()
    found = bound_score(drive, truth)
    sd = least_sd(drive, truth)

    assert sd.min() < found.rms < sd.max() and not found.identified and np.isnan(found.coverage)
