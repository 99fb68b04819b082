"""An accelerometer is used where its place is stated and its readings go with U r, else why not is said."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.accelerometer import BEHIND_SD, QUIETEST, find_accelerometer

from .banked_drive import BEHIND, banked_drive, with_place, without_ay
from .banked_fleet import banked_scores
from .simulated_drive import vehicle


@pytest.fixture(scope="module")
def log():
    return banked_drive(seconds=40, bank=0.2, gust=0.05)[0]


def test_a_stated_place_and_a_column_that_goes_with_the_turn(log):
    found, why = find_accelerometer(log, with_place(0.1))
    assert (found.behind, found.behind_sd, why) == (BEHIND, 0.1, "")
    assert found.noise == pytest.approx(0.1, rel=0.1)  # m/s^2: put in by the drive


def test_a_place_without_an_uncertainty_is_one_read_off_a_drawing(log):
    found, _ = find_accelerometer(log, with_place(None))
    assert found.behind_sd == BEHIND_SD


def test_without_a_place_nothing_is_used_and_nothing_said(log):
    assert find_accelerometer(log, vehicle()) == (None, "")


def test_a_place_without_a_column_is_said(log):
    found, why = find_accelerometer(without_ay(log), with_place())
    assert found is None and "no column ay" in why


@pytest.mark.parametrize(
    "spoil",
    [
        lambda log: -log.ay,  # another sign
        lambda log: log.ay / 9.80665,  # in g
        lambda log: 0.3 * np.random.default_rng(0).standard_normal(log.samples),  # another axis
        lambda log: np.zeros(log.samples),  # dead
    ],
)
def test_readings_that_do_not_go_with_the_turn_are_refused_with_the_slope(log, spoil):
    found, why = find_accelerometer(replace(log, ay=spoil(log)), with_place())
    assert found is None and "of U r where" in why


def test_where_the_car_hardly_turned_the_file_is_believed(log):
    still = replace(log, r=0.001 * log.r, ay=0.001 * log.ay)
    found, why = find_accelerometer(still, with_place())
    assert found.noise == QUIETEST and why == ""


def test_missing_readings_do_not_matter(log):
    ay = log.ay.copy()
    ay[::3] = np.nan
    found, _ = find_accelerometer(replace(log, ay=ay), with_place())
    assert found is not None


CARS = 16
# Share of time covered, averaged over cars: a car is inside or outside for most of a drive, so about
# CARS independent trials; three sd below 95 %:
LEAST = 0.95 - 3 * (0.95 * 0.05 / CARS) ** 0.5


@pytest.mark.slow
def test_bank_and_gusts_seen_by_the_accelerometer():
    score = banked_scores(cars=CARS, rms=3e-3, bank=0.3, gust=0.1)
    assert score["with"].covered > LEAST
    assert score["with"].claimed < score["without"].claimed
    assert score["with"].rms < score["without"].rms
