"""The one call of the library reaches every estimator, and each says who it is."""

import pytest

import similitude
from similitude.identification import identify

from .simulated_drive import drive, vehicle


@pytest.mark.parametrize("estimator", ["population", "paper", "band", "output_error", "robust"])
def test_every_estimator_answers_through_the_same_call(estimator):
    run = identify(drive(seconds=20), vehicle(), estimator=estimator)
    assert run.estimator == estimator
    assert len(run.trace.K) == run.log.samples
    assert run.K.lo < run.K.value < run.K.hi


def test_the_public_name_is_the_call_and_not_the_file():
    assert similitude.identify is identify


def test_population_is_the_default():
    assert identify(drive(seconds=5), vehicle()).estimator == "population"
