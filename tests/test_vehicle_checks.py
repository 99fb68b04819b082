"""Impossible vehicles are found; real ones never are."""

import csv
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.units import parse_uncertain
from similitude.vehicle_checks import find_fault

DATA = Path(__file__).parents[1] / "data"


def rows(name):
    with open(DATA / name, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def of(**texts):
    return {name: parse_uncertain(text) for name, text in texts.items()}


@pytest.mark.parametrize("row", rows("vehicles_literature.csv"), ids=lambda row: row["vehicle"])
def test_no_vehicle_of_the_literature_is_refused(row):
    texts = {
        header.split(" [")[0]: f"{value} {header.split('[')[1][:-1]}"
        for header, value in row.items()
        if "[" in header and value
    }
    values = of(**texts)
    small = values["m"].value < 100

    population = "small_cars_1to10" if small else "passenger_cars"
    assert find_fault(values, population=population) is None


def test_no_production_car_is_refused():
    for row in rows("opendbc_specs.csv"):
        names = {"L": "L [m]", "m": "m [kg]", "steering_ratio": "steer_ratio [-]"}
        units = {"L": "m", "m": "kg", "steering_ratio": "1"}
        values = of(**{name: f"{row[names[name]]} {units[name]}" for name in names if row[names[name]]})
        assert find_fault(values, population="passenger_cars") is None, row


def test_no_measured_inertia_is_refused():
    for row in rows("lvipd_204.csv"):
        # a b = L^2 / 4 or less, so this is the shortest wheelbase the row allows
        length = 2 * float(row["ab [m^2]"]) ** 0.5
        values = of(L=f"{length} m", m=f"{row['m [kg]']} kg", Iz=f"{row['Izz [kg m^2]']} kg m^2")
        assert find_fault(values, population="passenger_cars") is None, row


@given(st.floats(min_value=0.02, max_value=1.0))
def test_lengths_that_miss_their_sum_by_more_than_rounding_are_found(excess):
    values = of(L="2.7 m", a="1.2 m", b=f"{1.5 + excess} m")

    fault = find_fault(values, population="passenger_cars")

    assert fault is not None
    assert fault.key == "L"


def test_lengths_within_their_deviations_are_fine():
    values = of(L="2.70 ± 0.05 m", a="1.20 ± 0.05 m", b="1.60 ± 0.05 m")

    assert find_fault(values, population="passenger_cars") is None


@pytest.mark.parametrize(
    ("lines", "key"),
    [
        ({"L": "2.7 m", "a": "1 mm"}, "a"),
        ({"L": "2.7 m", "b": "0.3 m"}, "b"),
        ({"a": "0.2 m", "b": "2.5 m"}, "a"),
        (
            {"L": "2.7 m", "a": "1.2 m", "b": "1.5 m", "m": "1500 kg", "Caf": "90 kN/rad", "Car": "9 kN/rad"},
            "Car",
        ),
        ({"L": "2.7 m", "a": "1.2 m", "b": "1.5 m", "Caf": "1 N/rad", "Car": "1e9 N/rad"}, "Car"),
    ],
)
def test_a_centre_of_gravity_or_a_balance_no_car_has(lines, key):
    fault = find_fault(of(**lines), population="passenger_cars")
    assert fault is not None and fault.key == key


def test_no_line_to_paste_holds_what_is_refused_again():
    for lines in ({"L": "1e300 m"}, {"m": "0 kg", "L": "2.7 m"}, {"yaw_rate_noise": "0 rad/s"}):
        fault = find_fault(of(**lines), population="passenger_cars")
        assert "inf" not in fault.paste and '"1 ' not in fault.paste


@pytest.mark.parametrize(
    ("typed", "unit"), [("2690 m", "mm"), ("269 m", "cm"), ("106 m", "in"), ("2.69 mm", "mm")]
)
def test_a_wheelbase_in_another_unit_is_refused_with_the_length_meant(typed, unit):
    fault = find_fault(of(L=typed), population="passenger_cars")

    assert fault.key == "L"
    assert f"m and {unit} were exchanged" in fault.usually
    assert fault.paste == f'L = "{2.6924 if unit == "in" else 2.69:.6g} m"'
