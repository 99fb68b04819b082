"""Every field of the configuration has a value; doubts that nobody stated are listed as taken."""

import numpy as np
import pytest

from similitude.bespoke.filter_numbers import Doubts, filter_numbers

from .gallery import made


def test_what_was_taken_says_so_and_what_was_stated_too():
    estimator = made("dc_motor")
    own = Doubts(estimator.doubts.noise, output_bias=0.01)
    config, assumed = filter_numbers(
        estimator.library, estimator.fewest, estimator.prior, estimator.trial, own
    )

    assert np.isfinite(config).all() and len(config) == len(estimator.library.names("config"))
    assert assumed["noise"][2] == assumed["output_bias"][2] == "stated"
    assert assumed["drift"][2].startswith("taken")
    assert config[estimator.library.index("config", "output_bias_sd")] == 0.01


def test_a_drift_lets_the_unknown_move():
    estimator = made("dc_motor")
    numbers = [
        filter_numbers(estimator.library, estimator.fewest, estimator.prior, estimator.trial,
                       Doubts(estimator.doubts.noise, drift=d))[0] for d in (None, 0.01)
    ]  # fmt: skip
    at = estimator.library.index("config", "drift")

    assert [c[at] for c in numbers] == pytest.approx([0.0, 1e-4])
