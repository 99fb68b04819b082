"""On a banked, gusty road the accelerometer keeps the interval honest and makes it narrower."""

import pytest

from .banked_fleet import banked_scores

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
