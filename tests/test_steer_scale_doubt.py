"""Whoever identifies at once is told of a steer or a speed of another scale, and of a steer cut off."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.identification import identify
from similitude.steer_scale_doubt import steer_scale_doubts
from similitude.vehicle_file import Vehicle

from .simulated_drive import drive, vehicle


@pytest.fixture(scope="module")
def town():
    """Between 4 and 14 m/s, with corners."""
    return drive(seconds=60, rms=0.03, U=lambda t: 9 + 5 * np.sin(t / 4), rate=50, lag=0.02, band=(0.05, 0.4))


def test_a_sound_drive_is_not_doubted(town):
    assert steer_scale_doubts(town, vehicle()) == ()


@pytest.mark.parametrize("factor", [3.6, 2.237])
def test_a_speed_in_other_units_is_doubted_though_another_car_would_explain_it(town, factor):
    (said,) = steer_scale_doubts(replace(town, U=town.U * factor), vehicle())
    assert "turns the car" in said and ("km/h" in said) == (factor == 3.6)


def test_the_doubt_reaches_the_warnings_of_a_run(town):
    run = identify(replace(town, U=town.U * 3.6), vehicle())
    assert any("turns the car" in line for line in run.warnings)


def test_a_cut_and_a_coarse_steer_are_said(town):
    cut = np.clip(town.delta, -0.03, 0.03)
    assert any("is held at" in line for line in steer_scale_doubts(replace(town, delta=cut), vehicle()))
    step = 0.2 * town.delta.std()
    coarse = np.round(town.delta / step) * step
    assert any("in steps of" in line for line in steer_scale_doubts(replace(town, delta=coarse), vehicle()))


def test_without_a_wheelbase_only_the_steer_itself_is_judged(town):
    assert steer_scale_doubts(replace(town, U=town.U * 3.6), Vehicle("car")) == ()


def test_a_log_without_a_number_says_nothing(town):
    nothing = np.full(town.samples, np.nan)
    assert steer_scale_doubts(replace(town, delta=nothing), vehicle()) == ()
