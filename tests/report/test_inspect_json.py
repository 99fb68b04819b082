"""The JSON of a look: strict, on one line, and complete."""

import json
import pathlib

import pytest

from similitude.inspection.inspection import inspect_log
from similitude.report.inspect_json import MOST_PAUSES, inspect_line, inspect_record
from similitude.vehicle_file import read_vehicle

from ..log_text import csv_text, drive, write

DATA = pathlib.Path(__file__).parents[2] / "data"
PAIRS = [
    ("f1tenth_ds1.csv", "f1tenth.toml"),
    ("rav4_straight.csv", "rav4.toml"),
    ("bmw_m8_double_lane_change.csv", None),
    ("opendbc_specs.csv", None),
]


@pytest.mark.parametrize("log, car", PAIRS)
def test_the_record_is_strict_json_on_one_line(log, car):
    look = inspect_log(DATA / log, vehicle=read_vehicle(DATA / car) if car else None)
    line = inspect_line(look)

    record = json.loads(line, parse_constant=pytest.fail)
    assert "\n" not in line and line.isascii()
    assert record["schema"] == 1 and record["log"].endswith(log)
    assert record["usable"] == (log != "opendbc_specs.csv")
    assert record == inspect_record(look)
    assert len(record["columns"]) == len(look.channels)
    assert sum(record["faults"].values()) == len(record["findings"])
    for one in record["findings"]:
        assert all(one[part] for part in ("fault", "what", "usually", "paste", "read"))


def test_numbers_stand_under_the_names_of_the_docs():
    record = inspect_record(
        inspect_log(DATA / "f1tenth_ds1.csv", vehicle=read_vehicle(DATA / "f1tenth.toml"))
    )

    relations, prospects = record["relations"], record["prospects"]
    assert relations["yaw_behind_steer"]["sign"] == 1
    assert relations["yaw_bias"]["unit"] == "rad/s" and relations["steer_when_straight"]["unit"] == "rad"
    assert prospects["steer_lag"]["from"] == "scanned" and prospects["in_words"]
    assert set(prospects["unknowns"]) == {"K", "pi1", "eta", "rho", "input_offset", "output_bias"}
    assert sum(record["seconds"].values()) == pytest.approx(2.0 * len(record["windows"]))


def test_a_torn_clock_does_not_make_an_endless_line(tmp_path):
    table = drive(900)
    table[:, 0] += 5.0 * (table[:, 0] * 100 // 3)

    record = inspect_record(inspect_log(write(tmp_path, csv_text(table))))

    assert record["clock"]["gaps_in_all"] > MOST_PAUSES == len(record["clock"]["gaps"])
