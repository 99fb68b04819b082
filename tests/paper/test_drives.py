"""The drives behind the figures, and the filter that runs beside a drive."""

import numpy as np
import pytest

from similitude.paper.drives import NOISE, RunningFilter, population_reads, prior_of, regression_reads, square
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


def test_the_filter_beside_a_drive_says_what_it_says_of_the_log():
    drive = square()
    rows = slice(0, 3000)
    beside = RunningFilter(drive.scenario)
    said = [
        beside(*row)
        for row in zip(drive.t[rows], drive.delta[rows], drive.r_gyro[rows], drive.U[rows], strict=True)
    ]
    K, _ = population_reads(drive, drive.r_gyro)

    assert np.array(beside.heard) == pytest.approx(K[rows], rel=1e-12)
    assert said[-1] == pytest.approx(K[rows][-1] / 16)


def test_the_regression_starts_where_it_is_told():
    drive = square()
    assert regression_reads(drive, drive.r, pi3_start=0.3)[0] == pytest.approx(0.3)


@pytest.mark.parametrize("name", ["square_closed_loop", "treadmill_hydroplaning", "wet_lane"])
def test_the_scenarios_tell_the_same_of_the_vehicle(name):
    scenario = read_scenario(name)
    assert scenario.vehicle.nominal() == square().scenario.vehicle.nominal()
    assert prior_of(name).mean == pytest.approx(prior_of("square_closed_loop").mean)
