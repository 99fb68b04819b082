"""The lag scan finds what was planted, and finds nothing where there is nothing to find."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.filter_config import COMMANDED_STEER_SD
from similitude.steer_lag import COMMAND, CONVINCING, LONGEST, LagScan, find_lag, is_command
from similitude.units import Uncertain
from similitude.vehicle_prior import vehicle_prior

from .simulated_drive import CAR, NOISE, drive, spoilt, vehicle
from .test_filter_run import setup_of

PLANTED = (0.0, 0.020, 0.050, 0.100)


def scan(log, car=None):
    car = car or vehicle()
    return find_lag(setup_of(log, vehicle_prior(car)), car)


@pytest.mark.parametrize("lag", PLANTED)
@pytest.mark.parametrize(("rms", "seed"), [(0.003, 0), (0.010, 1)])
def test_a_planted_lag_is_found_within_a_step_of_the_scan(lag, rms, seed):
    found = scan(drive(seconds=60, rms=rms, lag=lag, seed=seed))
    assert found.chosen == pytest.approx(lag, abs=0.010)
    assert found.origin == ("scanned" if lag else "assumed")
    assert found.cost.min() == 0
    assert found.lags[0] == 0 and found.lags[-1] == pytest.approx(LONGEST)


@pytest.mark.parametrize("lag", PLANTED)
def test_missing_steer_cells_do_not_bend_the_scan(lag):
    """One cell in seven missing; a lag must not win or lose by how many rows it can use."""
    log = drive(seconds=60, rms=0.004, lag=lag, seed=2)
    holes = np.random.default_rng(7).random(log.samples) < 1 / 7
    assert scan(spoilt(log, delta=holes)).chosen == pytest.approx(lag, abs=0.010)


def test_missing_yaw_rates_and_a_long_hole_in_the_steer_do_not_either():
    log = drive(seconds=60, lag=0.05, seed=3)
    holed = spoilt(log, delta=slice(1000, 1300), r=np.random.default_rng(1).random(log.samples) < 0.1)
    assert scan(holed).chosen == pytest.approx(0.05, abs=0.010)


@pytest.mark.parametrize("rate", [20, 50, 1000])
def test_a_lag_shorter_than_a_row_is_found_at_other_rates(rate):
    seconds = 60 if rate < 1000 else 20
    found = scan(drive(seconds=seconds, rms=0.01, lag=0.035, rate=rate, seed=4))
    # at 20 Hz the steer between rows is a guess: half a row is what can be known
    assert found.chosen == pytest.approx(0.035, abs=max(0.010, 0.5 / rate))


@pytest.mark.parametrize("planted", [0.0, 0.1])
@pytest.mark.parametrize("seed", range(3))
def test_on_a_straight_road_the_lag_is_that_of_measured_angles_and_stays_open(planted, seed):
    found = scan(drive(seconds=60, rms=1e-4, lag=planted, seed=seed))
    assert 0.003 < found.chosen < 0.025
    assert 0.5 * found.chosen < found.std < found.chosen
    assert found.origin == "assumed"
    assert found.cost[0] < CONVINCING


def test_the_curve_is_lowest_at_the_truth_and_rises_on_both_sides():
    found = scan(drive(seconds=60, rms=0.01, lag=0.08, seed=5))
    best = int(np.argmin(found.cost))
    assert found.lags[best] == pytest.approx(0.08)
    near = found.cost[best - 3 : best + 4]
    assert np.all(np.diff(near[:4]) < 0) and np.all(np.diff(near[3:]) > 0)
    far = np.abs(np.arange(found.lags.size) - best) > 1
    assert np.all(found.cost[far] > CONVINCING)


def test_the_vehicle_file_is_believed_unseen():
    car = vehicle(steer_lag=Uncertain(0.012, None, "s"))
    found = scan(drive(seconds=10, lag=0.1), car)
    assert (found.chosen, found.origin) == (0.012, "vehicle file")
    assert found.lags.size == found.cost.size == 0


def test_a_late_steer_is_taken_for_a_command():
    empty = np.empty(0)
    late, early = (LagScan(empty, empty, x, "scanned") for x in (COMMAND, np.nextafter(COMMAND, 0)))
    assert is_command(late, vehicle()) and not is_command(early, vehicle())
    assert is_command(early, vehicle(steer="command")) and not is_command(late, vehicle(steer="measured"))
    assert COMMANDED_STEER_SD > 0.1


def test_a_log_without_a_single_usable_row_has_no_lag():
    log = drive(seconds=5)
    found = scan(spoilt(log, r=slice(None)))
    assert found.origin == "assumed"
    # ln(lag + 10 ms) is normal about ln(20 ms) with sd 0.5: mean and sd 20 exp(1/8) - 10 = 12.7 ms and
    # 12.1 ms, less of either since the grid ends at 40 ms
    assert found.chosen == pytest.approx(0.0115, abs=0.001)
    assert found.std == pytest.approx(0.0095, abs=0.0015)
    assert np.all(found.cost == 0)


def test_the_noise_assumed_does_not_decide_the_lag():
    log, car = drive(seconds=60, lag=0.05, seed=6), vehicle()
    for factor in (0.3, 3.0):
        setup = setup_of(log, vehicle_prior(car), L=CAR["L"], noise_std=NOISE * factor)
        assert find_lag(setup, car).chosen == pytest.approx(0.05, abs=0.010)


@pytest.mark.parametrize("early", [0.1, 0.3])
def test_a_yaw_rate_before_its_steer_is_said_and_by_about_how_much(early):
    log = drive(seconds=40, rms=0.006, seed=5)
    late = replace(log, delta=np.interp(log.t - early, log.t, log.delta))
    assert scan(late).early == pytest.approx(early, abs=0.06)
    assert scan(log).early == 0.0
