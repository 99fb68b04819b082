"""A wrong unit is refused with the guess; spikes and real cars are not."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.errors import LogError
from similitude.log_columns import choose_columns
from similitude.log_plausibility import check_against_steer, check_units, speed_warnings

from .log_text import HEADERS, drive


def values_of(factors=(1, 1, 1, 1), samples=300):
    columns = drive(samples) * factors
    return dict(zip(("t", "delta", "r", "U"), columns.T, strict=True))


def columns_of(*headers):
    return choose_columns(headers or HEADERS, file="drive.csv", mapping={})


DEG = 180 / np.pi
WRONG = {
    "yaw rate in deg/s": ((1, 1, 5 * DEG, 1), HEADERS, "r [deg/s]"),
    "yaw rate in deg/s, |r| U alone": ((1, 1, DEG, 1), HEADERS, "r [deg/s]"),
    "yaw rate in mrad/s": ((1, 1, 1e3, 1), HEADERS, "r [deg/s]"),
    "steer in deg": ((1, 10 * DEG, 1, 1), HEADERS, "delta [deg]"),
    "speed in mm/s": ((1, 1, 1, 1e3), HEADERS, "U [mm/s]"),
    "speed of a fast car in km/h": ((1, 1, 1, 9), HEADERS, "U [km/h]"),
}


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_unit_is_refused_with_the_header_to_write(case):
    factors, headers, paste = WRONG[case]

    with pytest.raises(LogError, match=r"data row [0-9]+: .* cannot be") as caught:
        check_units(values_of(factors), columns_of(*headers), file="drive.csv")

    assert caught.value.paste == paste
    assert f"look like {paste.split('[')[1][:-1]}" in caught.value.usually


def test_a_guess_that_would_not_help_is_not_made():
    with pytest.raises(LogError, match="raw counts"):
        check_units(values_of((1, 1, 1e9, 1)), columns_of(), file="drive.csv")


def test_a_lateral_acceleration_in_another_unit_is_refused():
    values = values_of() | {"ay": np.sin(np.arange(300)) * 8 * 9.80665}
    columns = columns_of(*HEADERS, "ay [g]")

    with pytest.raises(LogError, match="look like m/s\\^2"):
        check_units(values, columns, file="drive.csv")


@given(st.lists(st.integers(0, 999), max_size=9, unique=True), st.floats(20, 1e6))
def test_spikes_in_less_than_one_percent_of_the_rows_are_left_to_the_estimator(rows, size):
    values = values_of(samples=1000)
    values["r"][rows] = size

    check_units(values, columns_of(), file="drive.csv")


@given(st.floats(0.05, 1.2), st.floats(1, 60))
def test_no_drive_within_the_limits_of_tyres_is_refused(share, speed):
    rate = share * min(6 * 9.80665 / speed, 12.0) / 1.2 * np.sin(np.arange(300.0))

    check_units({"r": rate, "U": np.full(300, speed), "delta": rate * 0.1}, columns_of(), file="drive.csv")


def against_steer(factors, headers=HEADERS):
    return check_against_steer(values_of(factors), columns_of(*headers), wheelbase=2.7, file="drive.csv")


def test_a_quiet_log_in_degrees_is_found_by_its_steer():
    with pytest.raises(LogError, match="times U delta / L") as caught:
        against_steer((1, 1, DEG, 1))

    assert caught.value.paste == "r [deg/s]"


def test_a_steer_in_radians_that_claims_degrees_is_found():
    with pytest.raises(LogError) as caught:
        against_steer((1, 1 / DEG, 1, 1), ("t [s]", "delta [deg]", "r [deg/s]", "U [m/s]"))

    assert caught.value.paste == "delta [rad]"


@given(st.floats(0.2, 3.0))
def test_any_car_is_believed(gain):
    assert against_steer((1, 1, gain / 0.6, 1)) == ()


def test_opposite_signs_and_a_steering_wheel_are_said():
    assert "opposite signs" in against_steer((1, -1, 1, 1))[0]
    assert "steering wheel" in against_steer((1, 16, 0.9, 1))[0]


def test_standstill_and_reverse_are_said():
    speed = np.r_[np.zeros(25), np.full(25, -2.0), np.full(50, 5.0), np.nan]

    still, back = speed_warnings(speed)

    assert "stands (below 0.5 m/s) in 25 %" in still
    assert "negative in 25 %" in back
    assert speed_warnings(np.full(9, 5.0)) == ()
