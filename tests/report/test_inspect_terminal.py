"""The terminal page of a look: 80 columns, every part, and names of a user's shown as they are."""

import pathlib
from io import StringIO

import pytest
from rich.console import Console

from similitude.inspection.inspection import inspect_log
from similitude.report.inspect_terminal import MOST_COLUMNS, print_inspection
from similitude.vehicle_file import read_vehicle

from ..log_text import csv_text, drive, write

DATA = pathlib.Path(__file__).parents[2] / "data"


def shown(look, width=80):
    out = StringIO()
    print_inspection(look, Console(file=out, width=width, highlight=False))
    return out.getvalue()


@pytest.mark.parametrize(
    "log, car",
    [
        ("f1tenth_ds2.csv", "f1tenth.toml"),
        ("rav4_straight.csv", "rav4.toml"),
        ("bmw_m8_double_lane_change.csv", None),
        ("lvipd_204.csv", None),
    ],
)
def test_the_page_fits_80_columns(log, car):
    page = shown(inspect_log(DATA / log, vehicle=read_vehicle(DATA / car) if car else None))

    assert max(map(len, page.splitlines())) <= 80
    assert log in page and "Columns" in page and "nan" not in page.lower().replace("finance", "")


def test_every_part_is_on_the_page_of_a_log_with_a_vehicle():
    page = shown(inspect_log(DATA / "rav4_straight.csv", vehicle=read_vehicle(DATA / "rav4.toml")))

    for part in ("nothing to learn", "Clock", "Relations", "The drive", "What it can show", "± 50 %"):
        assert part in page
    assert "Left unsaid" not in page


def test_a_refused_log_says_so_first():
    lines = shown(inspect_log(DATA / "opendbc_specs.csv")).splitlines()

    assert "refused by identify" in lines[2]
    assert any(line.lstrip().startswith("refuses") for line in lines)


def test_headers_are_text_and_not_markup(tmp_path):
    table = drive(300)
    headers = ("t [s]", "delta [rad]", "r [rad/s]", "[red]U[/red] [m/s]")

    assert "[red]U[/red]" in shown(inspect_log(write(tmp_path, csv_text(table, headers=headers))))


def test_a_file_of_many_columns_is_cut_and_says_so(tmp_path):
    count = MOST_COLUMNS + 7
    rows = [",".join(f"c{i} [1]" for i in range(count))] + [",".join(["1"] * count)] * 5

    assert "and 7 more, in --json" in shown(inspect_log(write(tmp_path, "\n".join(rows))))


def test_what_makes_a_sharp_stiffness_doubtful_stands_in_the_headline():
    look = inspect_log(DATA / "bmw_m8_double_lane_change.csv", vehicle=read_vehicle(DATA / "bmw_m8.toml"))
    top = shown(look).split("Findings")[0]
    assert "in doubt" in top and "scale of steer" in top


def test_long_ranges_are_whole_at_80_columns(tmp_path):
    rows = [(1.7327e9 + 0.02 * i, 1e5 * i - 123456.789) for i in range(100)]
    text = "t [s],torque of the engine [mNm]\n" + "\n".join(f"{t:.3f},{x:.3f}" for t, x in rows)
    page = shown(inspect_log(write(tmp_path, text)))
    assert "1.7e9 + 2.0" in page
    assert "−1.2e5 … 9.8e6" in page
