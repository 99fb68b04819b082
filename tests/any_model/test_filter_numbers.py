"""Every field of the configuration has a value; doubts that nobody stated are listed as taken."""

import pathlib
import runpy

import numpy as np
import pytest

from similitude.any_model.filter_numbers import Doubts, filter_numbers

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


@pytest.mark.slow
def test_the_cars_filter_built_by_reduce_is_no_worse_than_that_of_identify():
    """On the same 30 cars; half a standard error of an rms over 30 cars is 6 % of it."""
    script = pathlib.Path(__file__).parents[2] / "scripts" / "reduced_car.py"
    scores = runpy.run_path(str(script))["compare"](0.003, 30)

    assert scores["reduce"].rms <= 1.06 * scores["identify"].rms
    assert scores["reduce"].covered >= 0.89
