"""The drives behind the figures, and the filter that runs beside a drive."""

import numpy as np
import pytest

from similitude.paper.drives import NOISE, drive_of, prior_of, regression_reads, square
from similitude.simulation.scenario import read_scenario


def test_the_gyro_adds_noise_and_nothing_else():
    drive = square()
    error = drive.r_gyro - drive.r

    assert error.std() == pytest.approx(NOISE, rel=0.02) and abs(error.mean()) < 4 * NOISE / np.sqrt(
        error.size
    )


def test_stiffness_is_halved_every_other_ten_seconds():
    drive = square()
    assert np.unique(np.round(drive.pi3, 5)).tolist() == [0.13609, 0.27217]
    assert drive.pi3[drive.during(10, 20)].max() < 0.14 and drive.pi3[drive.during(0, 10)].min() > 0.27


def test_the_gain_that_follows_drives_otherwise():
    changes = {"run.duration": "14 s"}
    fixed = drive_of(read_scenario("wet_lane", changes=changes))
    follows = drive_of(read_scenario("wet_lane", changes=changes | {"driver.schedule": "estimate"}))

    assert np.array_equal(fixed.wanted, follows.wanted) and not np.array_equal(fixed.y, follows.y)


def test_the_regression_starts_where_it_is_told():
    drive = square()
    started = regression_reads(drive, drive.r, K_start=0.3 * drive.U[0] ** 2)
    assert started[0] == pytest.approx(0.3)


@pytest.mark.parametrize("name", ["square_closed_loop", "treadmill_hydroplaning", "wet_lane"])
def test_the_scenarios_tell_the_same_of_the_vehicle(name):
    scenario = read_scenario(name)
    assert scenario.vehicle.nominal() == square().scenario.vehicle.nominal()
    assert prior_of(name).mean == pytest.approx(prior_of("square_closed_loop").mean)
