"""With a fixed drift of K the filter's error stays near the least that its own assumptions allow."""

import numpy as np
import pytest

from .drift_bound import rms_and_bound
from .experiment import fleet

MOST = 1.25  # of the bound


@pytest.mark.slow
@pytest.mark.parametrize("steer_rms", [3e-3, 10e-3])
def test_rms_is_within_a_quarter_of_the_bound(steer_rms):
    rms, bound = rms_and_bound(fleet(2, cars=24, steer_rms=steer_rms))
    assert np.sqrt(np.mean(rms**2)) < MOST * np.sqrt(np.mean(bound**2))
    assert np.median(rms) < MOST * np.median(bound)
