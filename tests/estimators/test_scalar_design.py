"""What holding the other groups at their averages costs K."""

from dataclasses import replace

import numpy as np
import pytest
from tests.montecarlo.experiment import drawn_prior

from similitude.estimators.scalar_design import STEERING, frozen_variance, response, scalar_config
from similitude.program.library import shipped

PRIOR = drawn_prior()


def test_it_is_of_the_size_that_freezing_was_found_to_cost():
    assert 0.05 < np.sqrt(frozen_variance(PRIOR, 2.7)) < 0.2  # 11 to 12 % rms in the reference experiment


def test_it_goes_with_the_square_of_the_spread_and_vanishes_without():
    narrow = PRIOR.covariance.copy()
    narrow[1:, 1:] *= 0.25

    assert frozen_variance(replace(PRIOR, covariance=narrow), 2.7) == pytest.approx(
        frozen_variance(PRIOR, 2.7) / 4, rel=1e-9
    )


def test_the_response_at_rest_is_the_steady_turn():
    point = np.array([np.log(146.0), 0.4431, 1.38, 1.017])
    slow = response(point, 2.7)[0]

    assert abs(slow.imag) < 0.5 * slow.real
    assert 2 < slow.real < 25 / 2.7  # below the neutral car's U/L
    assert len(response(point, 2.7)) == len(STEERING)


def test_the_configuration_is_complete():
    library = shipped("bicycle_scalar_population")
    config = scalar_config(library, PRIOR, sample_time=0.01, L=2.7, noise_std=0.0026)

    assert config[library.index("config", "start_variance")] == pytest.approx(PRIOR.covariance[0, 0])
    assert np.isfinite(config).all()
