"""What halves an interval: from the equation V' = q - I V^2, integrated a second way."""

import numpy as np
import pytest

from similitude.filter_config import DESIGN
from similitude.information_meter import information


def straight(rate, seconds=120.0):
    t = np.linspace(0, seconds, 1201)
    return t, rate * t


@pytest.mark.parametrize(("rate", "std"), [(5.0, 0.3), (50.0, 0.1), (1.0, 0.5)])
def test_the_time_told_halves_the_sd_when_the_equation_is_integrated(rate, std):
    told = information(*straight(rate), std)
    variance, dt = std**2, 1e-3
    for _ in range(round(told.seconds / dt)):
        variance += dt * (DESIGN["drift"] - rate * variance**2)

    assert np.sqrt(variance) == pytest.approx(std / 2, rel=2e-3)
    assert told.rate == pytest.approx(rate)


def test_where_drift_wins_more_steer_is_named():
    told = information(*straight(1.0), 0.12)  # rests at (1e-4)^(1/4) = 0.1: half of 0.12 is below

    assert told.seconds is None and told.steer is not None
    assert "will not halve" in told.text and "times the steer" in told.text


def test_a_minute_that_said_nothing_promises_nothing():
    told = information(*straight(0.0), 0.5)

    assert told.seconds is None and told.steer is None
    assert "said nothing" in told.text


def test_only_the_last_minute_counts():
    t = np.linspace(0, 600, 6001)
    told = information(t, np.minimum(t, 300.0), 0.3)

    assert told.rate == 0.0
