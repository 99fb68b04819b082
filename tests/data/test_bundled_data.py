"""The bundled data keep their promises: units in every header, a source and a licence for each."""

import csv
import pathlib
import re

import pytest

from similitude.log import read_log
from similitude.vehicle_file import read_vehicle

DATA = pathlib.Path(__file__).parents[2] / "data"
README = (DATA / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("path", sorted(DATA.glob("*.toml")), ids=lambda path: path.name)
def test_a_vehicle_file_is_readable_and_is_of_a_known_population(path):
    vehicle = read_vehicle(path)

    assert vehicle.L is not None
    assert not vehicle.origins["population"].startswith("assumed")


def test_the_wheelbase_of_the_bmw_is_the_sum_of_its_axle_distances():
    assert read_vehicle(DATA / "bmw_m8.toml").L.value == pytest.approx(1.331 + 1.496, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "vehicle", "rate"),
    [
        ("rav4_straight", "rav4", 50),
        ("bmw_m8_double_lane_change", "bmw_m8", 100),
        *((f"f1tenth_ds{i}", "f1tenth", 50) for i in range(1, 6)),
    ],
)
def test_a_log_is_read_whole_and_at_the_rate_the_page_states(name, vehicle, rate):
    log = read_log(DATA / f"{name}.csv", vehicle=read_vehicle(DATA / f"{vehicle}.toml"))
    with open(DATA / f"{name}.csv", encoding="utf-8") as file:
        rows = sum(1 for _ in file) - 1

    assert log.samples == rows
    assert log.rate == pytest.approx(rate, rel=1e-6)


@pytest.mark.parametrize("path", sorted(DATA.glob("*.csv")), ids=lambda path: path.name)
def test_every_row_has_a_cell_for_every_column(path):
    with open(path, newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)

    assert rows and {len(row) for row in rows} == {len(header)}


@pytest.mark.parametrize("path", sorted(DATA.glob("*.csv")), ids=lambda path: path.name)
def test_the_page_names_every_file(path):
    # The F1/10 logs are one row of the page: f1tenth_ds*.csv.
    assert path.name in README or re.sub(r"\d+\.csv$", "*.csv", path.name) in README


def test_every_licence_is_named_and_every_named_one_is_there():
    named = set(re.findall(r"licenses/([\w.-]+\.txt)", README))

    assert named == {path.name for path in (DATA / "licenses").iterdir()}
