"""Looking at whole files: the traps of the bundled logs, planted faults, and files nobody can use."""

import json
import pathlib

import numpy as np
import pytest

from similitude.errors import LogError
from similitude.inspection.inspection import inspect_log
from similitude.vehicle_file import read_vehicle

from ..log_text import csv_text, write
from ..simulated_drive import drive as simulated

DATA = pathlib.Path(__file__).parents[2] / "data"
F1TENTH = [f"f1tenth_ds{i}.csv" for i in range(1, 6)]


def look(log, vehicle=None):
    car = read_vehicle(DATA / vehicle) if vehicle else None
    return inspect_log(DATA / log, vehicle=car)


def faults(found):
    return {one.fault for one in found.findings}


@pytest.mark.parametrize("log", F1TENTH)
def test_f1tenth_steer_is_a_late_command_cut_off_at_its_limit(log):
    found = look(log, "f1tenth.toml")

    assert {"steer_cut", "late_steer", "standstill"} <= faults(found)
    # docs of the recording: 0.04 to 0.14 s, which the whole car's own lag is added to
    assert 0.02 <= found.prospects.scan.total <= 0.14 < found.behind_steer.lag + 0.06
    assert "0.34" in next(one.what for one in found.findings if one.fault == "steer_cut")


@pytest.mark.parametrize("log", F1TENTH)
def test_f1tenth_lateral_acceleration_is_the_one_along_the_car(log):
    found = look(log)

    assert "ay_axis" in faults(found) and found.behind_yaw.sign == 0


def test_interpolated_stretches_are_found_and_not_used():
    found = look("f1tenth_ds2.csv")

    assert "interpolated" in faults(found)
    assert sum(one.kind == "missing" for one in found.windows) * 2.0 == pytest.approx(27, abs=6)
    assert next(one for one in found.channels if one.taken_for == "r").straight > 0.1


def test_the_bmw_has_a_doubtful_steer_scale():
    found = look("bmw_m8_double_lane_change.csv", "bmw_m8.toml")

    assert "steer_scale" in faults(found) and found.behind_yaw.sign == 1


def test_the_rav4_has_nothing_to_teach():
    found = look("rav4_straight.csv", "rav4.toml")

    assert found.prospects.verdict == "not_excited"
    straight = sum(one.kind == "straight" for one in found.windows)
    assert straight > len(found.windows) / 2


def test_without_a_vehicle_it_looks_and_says_what_a_wheelbase_would_add():
    found = look("rav4_straight.csv")

    assert found.prospects is None and found.ratio is None
    assert any("wheelbase" in line for line in found.missing)
    assert found.slow.length is not None


def test_a_table_that_is_no_log_is_described():
    found = look("opendbc_specs.csv")

    assert found.survey.certain and found.clock is None and not found.windows
    assert found.channels[0].header == "brand"
    mass = next(one for one in found.channels if one.header == "m [kg]")
    assert mass.unit == "kg" and mass.taken_for is None and 500 < mass.low < mass.high < 5000


@pytest.mark.parametrize("path", ["no_such_file.csv", "README.md", "licenses"])
def test_what_is_no_table_cannot_be_looked_at(path, tmp_path):
    if path == "README.md":
        write(tmp_path, b"\x89PNG\r\n\x1a\n", "picture.csv")
        path = tmp_path / "picture.csv"
    with pytest.raises(LogError):
        inspect_log(DATA / path)


def columns(log):
    return np.column_stack([log.t, log.delta, log.r, log.U])


def car_file(tmp_path, text='L = "2.65 m"'):
    return read_vehicle(write(tmp_path, text, "car.toml"))


def test_a_steering_wheel_gives_the_ratio_with_its_interval(tmp_path):
    log = simulated(seconds=60, rms=0.006, U=lambda t: 18 + 6 * np.sin(0.15 * t), rate=50, band=(0.05, 1.5))
    table = columns(log)
    table[:, 1] *= 15.3
    heads = ("t [s]", "steering_wheel [rad]", "r [rad/s]", "U [m/s]")
    path = write(tmp_path, csv_text(table, headers=heads))

    found = inspect_log(path, vehicle=car_file(tmp_path))

    value, std = found.ratio
    assert abs(value - 15.3) < 1.96 * std and std < 0.2 * value
    assert found.survey.certain  # identify needs the ratio ...
    assert any("mended" in line for line in found.missing)  # ... and inspect says so


def test_opposite_signs_are_seen_without_a_vehicle(tmp_path):
    table = columns(simulated(seconds=30, rate=50))
    table[:, 1] *= -1

    found = inspect_log(write(tmp_path, csv_text(table)))

    assert found.behind_steer.sign == -1


def test_planted_gaps_are_in_the_clock(tmp_path):
    table = np.delete(columns(simulated(seconds=20, rate=50)), slice(300, 350), axis=0)

    found = inspect_log(write(tmp_path, csv_text(table)))

    assert found.clock.gaps[0].row == 301 and found.clock.gaps[0].length == pytest.approx(51 / 50)


def test_certain_findings_stand_first(tmp_path):
    table = columns(simulated(seconds=20, rate=50))
    table[100:110, 0] = table[100, 0]

    found = inspect_log(write(tmp_path, csv_text(table)))

    order = [one.certain for one in found.findings]
    assert order == sorted(order, reverse=True) and order[0]
    assert found.signals is None and not found.windows


def test_unused_and_textual_columns_are_listed(tmp_path):
    rows = ["t [s],delta [rad],r [rad/s],U [m/s],note,gear"]
    rows += [f"{0.02 * i},{0.01 * np.sin(i / 9)},{0.05 * np.sin(i / 9)},20,ok,{i // 100}" for i in range(400)]

    found = inspect_log(write(tmp_path, "\n".join(rows)))

    note, gear = found.channels[-2:]
    assert note.low is None and note.missing == 1.0 and note.taken_for is None
    assert (gear.low, gear.high, gear.unit) == (0.0, 3.0, None)


def test_a_look_can_be_asked_for_with_other_names(tmp_path):
    table = columns(simulated(seconds=20, rate=50))
    path = write(tmp_path, csv_text(table, headers=("t [s]", "SWA [rad]", "gyro [rad/s]", "U [m/s]")))

    found = inspect_log(path, mapping={"delta": "SWA", "r": "gyro"})

    assert {one.taken_for for one in found.channels} == {"t", "delta", "r", "U"}


@pytest.mark.parametrize("seed", range(30))
def test_whatever_is_in_the_file_the_look_is_complete_and_finite(seed, tmp_path):
    from similitude.report.inspect_json import inspect_line

    path = write(tmp_path, csv_text(_spoilt(np.random.default_rng(seed))))

    found = inspect_log(path, vehicle=car_file(tmp_path) if seed % 2 else None)

    json.loads(inspect_line(found), parse_constant=pytest.fail)
    assert len(found.channels) == 4


def _spoilt(rng):
    """A small log with every column spoilt in one of several ways."""
    n = int(rng.choice([2, 20, 200, 600]))
    table = columns(simulated(seconds=12, rate=50))[:n]
    for column in table.T:
        match rng.integers(8):
            case 0:
                column[:] = 0
            case 1:
                column[rng.integers(n)] = 1e300
            case 2:
                column[:] = column[::-1].copy()
            case 3:
                column[rng.random(n) < 0.4] = np.nan
            case 4:
                column *= -57.3
            case 5:
                column[:] = np.nan
    return table
