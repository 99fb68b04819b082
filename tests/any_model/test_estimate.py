"""Intervals, parameters and verdicts that follow from a log."""

import numpy as np
import pytest

from .gallery import made


@pytest.fixture(scope="module")
def log():
    return made("dc_motor").simulate(seed=4)


def test_intervals_hold_the_truth_and_parameters_follow(log):
    estimator = made("dc_motor")
    found, truth = estimator.run(log), estimator.drawn(4)

    assert found.verdict == "identified"
    for name in ("J", "b"):
        one = found.parameters[name]
        assert one.low < truth[name] < one.high and one.sd < 0.1 * one.prior_sd
    assert 0.5 < found.consistency < 1.2  # below one: this plant has none of the doubts that were taken
    assert (found.low < found.value).all() and (found.value < found.high).all()


def test_a_log_in_pieces_says_bad_data(log):
    y = log["w"].copy()
    y[::3] = np.nan
    found = made("dc_motor").run({**log, "w": y})

    assert found.verdict == "bad_data" and "33 %" in found.reason


def test_much_more_noise_than_stated_is_said(log):
    y = log["w"] + 0.05 * np.random.default_rng(0).standard_normal(len(log["w"]))

    assert made("dc_motor").run({**log, "w": y}).verdict == "outside_model"


def test_a_resting_input_tells_nothing(log):
    quiet = made("dc_motor").simulate(np.zeros(1500), seed=4)
    found = made("dc_motor").run(quiet)

    assert found.verdict == "not_excited"
    assert found.unknowns["time_ratio"].sd == pytest.approx(0.5, rel=0.2)
