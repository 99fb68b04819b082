"""The speed's own changes tell its unit, its wheel and the place where two drives meet."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.log import read_log
from similitude.log_columns import choose_columns
from similitude.log_speed import check_speed_signal

from .test_log import DATA, REAL

T = np.arange(6000) * 0.01
COLUMNS, _ = choose_columns(("t [s]", "delta [rad]", "r [rad/s]", "U [m/s]"), file="drive.csv", mapping={})


def check(speed, rate=None, *, wheelbase=2.7):
    values = {"t": T, "U": speed} | ({} if rate is None else {"r": rate})
    return check_speed_signal(values, COLUMNS, wheelbase=wheelbase)


def town(seed=0, *, least=3.0):
    """Speed between stops and 60 km/h, changing by 2 to 4 m/s^2, with 0.05 m/s of noise."""
    rng = np.random.default_rng(seed)
    speed = least + (17 - least) * (0.5 - 0.5 * np.cos(2 * np.pi * T / 20))
    return speed + 0.05 * rng.standard_normal(T.size)


def turns(size=0.3):
    return size * np.sin(2 * np.pi * T / 7) * (np.sin(2 * np.pi * T / 31) > -0.3)


@pytest.mark.parametrize("name", REAL)
def test_real_logs_are_believed(name):
    log = read_log(DATA / f"{name}.csv")

    assert not {one.fault for one in log.findings} & {"speed_unit", "drives_joined", "speed_of_one_wheel"}


def test_a_drive_in_town_is_believed_though_its_driver_brakes_for_turns():
    assert check(town(), turns()) == []
    assert check(town() - 2 * np.abs(turns()), turns()) == []


def test_a_speed_too_lively_or_too_fast_for_a_car_is_said():
    braking = 28 - 5 * np.abs(T % 10 - 5)  # 5 m/s^2 up and down

    assert check(braking) == []
    (lively,) = check(3.6 * braking)
    (fast,) = check(np.full(T.size, 3.6 * 30.0))
    assert (lively.fault, lively.fix) == (fast.fault, fast.fix) == ("speed_unit", "speed_is_kmh")
    assert fast.value == pytest.approx(108)


def test_an_acceleration_of_a_second_that_no_road_car_has_is_said():
    quick = 5 + 6 * np.abs(T % 6 - 3)  # 6 m/s^2 up and down
    assert check(quick) == []
    (forward,) = check(1.5 * quick)
    assert forward.fault == "speed_unit" and forward.value == pytest.approx(9, rel=0.05)

    corner = np.where((T > 20) & (T < 25), 0.5, 0.0)
    assert check(np.full(T.size, 20.0), corner) == []
    (side,) = check(np.full(T.size, 36.0), corner)
    assert side.fault == "speed_unit" and side.value == pytest.approx(18)


@settings(max_examples=30, deadline=None)
@given(st.floats(0.65, 0.9), st.sampled_from([-1, 1]), st.integers(0, 99))
def test_the_speed_of_one_wheel_is_found_with_half_the_track(half, side, seed):
    (found,) = check(town(seed, least=16.5) + side * half * turns(), turns())

    assert found.fault == "speed_of_one_wheel"
    assert found.value == pytest.approx(side * half, rel=0.1)


@settings(max_examples=30, deadline=None)
@given(st.integers(500, 5500), st.floats(5, 15), st.sampled_from([1, 10]))
def test_the_row_where_two_drives_meet_is_found_in_a_fast_and_a_slow_signal(row, jump, every):
    speed = town(least=14) + np.where(T >= T[row], jump, 0.0)
    speed = speed[(np.arange(T.size) // every) * every]

    (found,) = [one for one in check(speed) if one.fault == "drives_joined"]

    assert abs(found.rows[1] - 1 - row) <= every


def test_wheels_that_lock_for_a_moment_are_no_join():
    speed = town(least=14)
    speed[3000:3001] -= 8

    assert check(speed) == []


def test_a_hole_in_the_yaw_rate_says_nothing_about_the_speed():
    turned = turns()
    turned[2000:3000] = np.nan
    assert check(town(), turned) == []
