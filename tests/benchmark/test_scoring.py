"""Scores of answers that are known in advance."""

import math

import numpy as np
import pytest

from similitude.benchmark.drives import Truth
from similitude.benchmark.entrant import Answer
from similitude.benchmark.scoring import THRESHOLDS, score, steps, unfit

from .linear_drive import K, linear_drive

DRIVE, TRUTH = linear_drive()


def of(K, ln_K_std=0.1, **more):
    return score(DRIVE, TRUTH, Answer(K, ln_K_std, **more), seconds=1.0)


def test_the_truth_itself_has_no_error_and_no_delay():
    found = of(TRUTH.K)

    assert (found.rms, found.bias, found.coverage, found.half_way) == (0, 0, 1, 0)
    assert found.identified and not found.wrong and found.found == math.inf


def test_a_constant_factor_is_rms_and_bias():
    found = of(1.1 * TRUTH.K)

    assert found.rms == pytest.approx(math.log(1.1)) and found.bias == pytest.approx(math.log(1.1))
    assert found.coverage == 1  # 1.96 of 0.1 holds 0.095
    assert of(1.1 * TRUTH.K, 0.04).coverage == 0


def test_one_that_sleeps_through_the_change_is_never_half_way_and_wrong():
    found = of(K)

    assert found.half_way == math.inf and found.identified and found.wrong
    assert found.coverage == pytest.approx(4 / 7, abs=1e-3)  # 10 to 50 s of 10 to 80 s
    assert not of(K, 0.5).wrong


def test_half_way_is_counted_from_the_change():
    late = np.where(DRIVE.t < 53.0, K, K / 2)

    assert of(late).half_way == pytest.approx(3.0, abs=0.011)


def test_an_alarm_within_thirty_seconds_of_a_change_is_true_and_any_other_false():
    found = of(K, alarms=[20.0, 51.5, 60.0])

    assert found.found == pytest.approx(1.5, abs=0.011) and found.false == 1
    assert found.hours == pytest.approx(50 / 3600, rel=1e-3)


def test_without_a_change_every_alarm_is_false():
    still = Truth(np.full(DRIVE.t.size, K), TRUTH.delta, TRUTH.groups)
    found = score(DRIVE, still, Answer(K, 0.1, alarms=[51.0]), seconds=1.0)

    assert found.false == 1 and math.isnan(found.found) and math.isnan(found.half_way)


def test_the_test_of_steps_sees_the_fall_and_its_delay():
    late = np.where(DRIVE.t < 52.0, K, K / 2)
    largest, delays = steps(DRIVE.t, np.log(late), np.array([50.0]))

    assert largest == 0 and delays[0] == pytest.approx(2.0, abs=0.011)
    assert (delays[THRESHOLDS < math.log(2)] < 2.1).all()
    assert np.isinf(delays[THRESHOLDS > math.log(2)]).all()


@pytest.mark.parametrize(
    "answer",
    [None, 3.0, Answer([1.0, 2.0], 0.1), Answer(math.nan, 0.1), Answer(-1.0, 0.1), Answer(K, 0.0),
     Answer(K, math.inf), Answer("K", 0.1)],
)  # fmt: skip
def test_what_is_no_answer_is_a_divergence_with_a_reason(answer):
    assert unfit(answer, DRIVE.t.size)
    assert score(DRIVE, TRUTH, answer, seconds=0.0).fault
