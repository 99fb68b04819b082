"""The HTML of a look: well formed, escaped, the same every time, with charts of the signals."""

import json
import pathlib
import re

import pytest

from similitude.inspection.inspection import inspect_log
from similitude.report.inspect_html import inspect_html
from similitude.vehicle_file import read_vehicle

from ..log_text import csv_text, drive, write

DATA = pathlib.Path(__file__).parents[2] / "data"


@pytest.mark.parametrize(
    "log, car", [("f1tenth_ds2.csv", "f1tenth.toml"), ("rav4_straight.csv", None), ("lvipd_204.csv", None)]
)
def test_the_page_is_well_formed_and_the_same_every_time(log, car, strict_html):
    look = inspect_log(DATA / log, vehicle=read_vehicle(DATA / car) if car else None)

    page = inspect_html(look)

    strict_html(page)
    assert page == inspect_html(look)


def test_signals_and_excitation_are_drawn_and_tinted():
    page = inspect_html(inspect_log(DATA / "f1tenth_ds2.csv", vehicle=read_vehicle(DATA / "f1tenth.toml")))

    drawn = set(re.findall(r'id="chart-([a-z-]+)"', page))
    assert drawn == {"steer", "yaw-rate", "speed", "ay", "steer-rms", "sideways", "learnt"}
    data = json.loads(
        re.search(r"<script[^>]*application/json[^>]*>(.*?)</script>", page, re.DOTALL).group(1)
    )
    colours = {span[2] for group in data["spans"] for span in group}
    assert {"outside_linear", "gained", "not_excited", "no_measurement"} <= colours


def test_headers_of_the_file_are_escaped(tmp_path):
    headers = ("t [s]", "delta [rad]", "r [rad/s]", "<script>alert(1)</script> [m/s]")
    path = write(tmp_path, csv_text(drive(300), headers=headers))

    page = inspect_html(inspect_log(path))

    assert "<script>alert" not in page and "&lt;script&gt;alert(1)" in page


def test_a_table_without_a_clock_has_no_charts():
    assert 'id="chart-' not in inspect_html(inspect_log(DATA / "opendbc_specs.csv"))
