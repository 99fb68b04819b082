"""A wrong unit is refused with the guess; spikes and real cars are not."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.log_columns import choose_columns
from similitude.log_plausibility import check_speed, check_turns, check_units, fill_rows

from .log_text import HEADERS, drive


def values_of(factors=(1, 1, 1, 1), samples=300):
    columns = drive(samples) * factors
    return dict(zip(("t", "delta", "r", "U"), columns.T, strict=True))


def columns_of(*headers):
    return choose_columns(headers or HEADERS, file="drive.csv", mapping={})[0]


DEG = 180 / np.pi
WRONG = {
    "yaw rate in deg/s": ((1, 1, 5 * DEG, 1), HEADERS, "deg/s", "--fix yaw_rate_is_deg_per_s"),
    "yaw rate in deg/s, |r| U alone": ((1, 1, DEG, 1), HEADERS, "deg/s", "--fix yaw_rate_is_deg_per_s"),
    "yaw rate in mrad/s": ((1, 1, 1e3, 1), HEADERS, "deg/s", "--fix yaw_rate_is_deg_per_s"),
    "steer in deg": ((1, 10 * DEG, 1, 1), HEADERS, "deg", "--fix steer_is_deg"),
    "speed in cm/s": ((1, 1, 1, 1e2), HEADERS, "cm/s", "U [cm/s]"),
    "speed of a fast car in km/h": ((1, 1, 1, 9), HEADERS, "km/h", "--fix speed_is_kmh"),
}


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_unit_is_refused_with_the_line_to_paste(case):
    factors, headers, unit, paste = WRONG[case]

    found = check_units(values_of(factors), columns_of(*headers), file="drive.csv")

    assert re.search(r"data row [0-9]+: .* cannot be", found[0].what)
    assert found[0].certain
    assert found[0].paste == paste
    assert f"look like {unit}" in found[0].usually


def test_a_guess_that_would_not_help_is_not_made():
    (found,) = check_units(values_of((1, 1, 1e9, 1)), columns_of(), file="drive.csv")

    assert "raw counts" in found.usually


def test_a_lateral_acceleration_in_another_unit_is_refused():
    values = values_of() | {"ay": np.sin(np.arange(300)) * 8 * 9.80665}
    columns = columns_of(*HEADERS, "ay [g]")

    (found,) = check_units(values, columns, file="drive.csv")

    assert "look like m/s^2" in found.usually


@given(st.lists(st.integers(0, 999), max_size=9, unique=True), st.floats(20, 1e6))
def test_spikes_in_less_than_one_percent_of_the_rows_are_left_to_the_estimator(rows, size):
    values = values_of(samples=1000)
    values["r"][rows] = size * (1 + 0.1 * np.arange(len(rows)))

    assert check_units(values, columns_of(), file="drive.csv") == []


@given(st.floats(0.05, 1.2), st.floats(1, 60))
def test_no_drive_within_the_limits_of_tyres_is_refused(share, speed):
    rate = share * min(6 * 9.80665 / speed, 12.0) / 1.2 * np.sin(np.arange(300.0))

    values = {"r": rate, "U": np.full(300, speed), "delta": rate * 0.1}
    assert check_units(values, columns_of(), file="drive.csv") == []


def test_standstill_and_reverse_are_said():
    speed = np.r_[np.zeros(25), np.full(25, -2.0), np.full(50, 5.0), np.nan]

    still, back = check_speed(speed, header="U [m/s]")

    assert "stands (below 0.5 m/s) in 25 %" in still.what
    assert "negative in 25 %" in back.what
    assert check_speed(np.full(9, 5.0), header="U [m/s]") == []


def test_a_car_that_never_moved_stands_in_100_percent():
    (still,) = check_speed(np.zeros(300), header="U [m/s]")
    assert "in 100 % of the rows" in still.what


@pytest.mark.parametrize("fill", [-9999.0, 99999.0])
def test_a_number_for_a_missing_value_is_named_and_no_unit(fill):
    values = values_of(samples=1000)
    values["r"][::100] = fill

    (found,) = check_units(values, columns_of(), file="drive.csv")

    assert (found.fault, found.fix) == ("fill_value", "drop_fill_values") and f"{fill:g}" in found.what
    assert fill_rows(values["r"], "r").sum() == 10


@pytest.mark.parametrize(("name", "header"), [("delta", "delta [deg]"), ("r", "r [deg/s]")])
def test_an_angle_without_a_sign_is_said_to_be_one(name, header):
    values = values_of(samples=1000)
    headers = [header if one.startswith(name) else one for one in HEADERS]
    values[name] = values[name] % (2 * np.pi)

    found = check_turns(values, columns_of(*headers), file="drive.csv")

    assert list(found) == [name] and "% 360" in found[name].paste
    assert check_turns(values_of(samples=1000), columns_of(), file="drive.csv") == {}
