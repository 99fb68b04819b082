"""What is stated of a car, what is drawn, and what its vehicle file tells."""

import pytest

from similitude.errors import ScenarioError, VehicleError
from similitude.simulation.scenario import read_scenario
from similitude.vehicle_file import read_vehicle


def changed(**changes):
    return read_scenario("slalom", changes={k.replace("__", "."): v for k, v in changes.items()}).vehicle


def told(vehicle, tmp_path):
    (tmp_path / "car.toml").write_text(vehicle.vehicle_file())
    return read_vehicle(tmp_path / "car.toml")


def test_the_vehicle_file_tells_what_is_known_and_nothing_else(tmp_path):
    car = told(changed(), tmp_path)
    assert car.L.value == 2.7 and car.m is None and car.Caf is None
    assert car.population == "passenger_cars" and car.name == "mid-size car"


def test_uncertain_values_are_told_as_stated_not_as_drawn(tmp_path):
    vehicle = changed(vehicle__known='["L", "a", "m"]')
    car = told(vehicle, tmp_path)
    assert (car.m.value, car.m.sd) == (1500, 100) and car.a.value == 1.2
    assert vehicle.draw([1]).m != 1500 and vehicle.nominal().m == 1500


def test_the_file_can_be_made_to_lie(tmp_path):
    car = told(changed(told__L="3.1 m", told__yaw_rate_noise="0.3 deg/s", told__population="passenger_cars"),
               tmp_path)  # fmt: skip
    assert car.L.value == 3.1 and car.yaw_rate_noise.value == pytest.approx(0.005236, rel=1e-3)
    assert changed(told__L="3.1 m").nominal().L == 2.7


def test_a_ratio_is_told_and_lengths_where_L_follows(tmp_path):
    vehicle = changed(vehicle='{ a = "1.2 m", b = "1.5 m", m = "1500 kg", Iz = "2600 kg m^2", '
                              'Caf = "82 kN/rad", Car = "98 kN/rad", steering_ratio = 15 }')  # fmt: skip
    car = told(vehicle, tmp_path)
    assert car.steering_ratio.value == 15 and car.L.value == pytest.approx(2.7)
    assert vehicle.length.value == pytest.approx(2.7) and vehicle.steering_ratio == 15


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"vehicle": '{ L = "2.7 m", a = "1.2 m", m = "1500 kg", Iz = "2600 kg m^2", Caf = "82 kN/rad" }'},
         "[vehicle] has no Car"),
        ({"vehicle": '{ L = "2.7 m", m = "1500 kg", Iz = "2600 kg m^2", Caf = "82 kN/rad", Car="9 kN/rad"}'},
         "[vehicle] has no a"),
        ({"vehicle.known": '["L", "mass"]'}, "'mass' is no letter"),
        ({"vehicle.known": '"L"'}, "no letter"),
        ({"vehicle.population": "trucks"}, "'trucks' is not known"),
        ({"vehicle.name": "3"}, "no plain text"),
        ({"vehicle.m": "5 kg"}, "m"),
    ],
)  # fmt: skip
def test_a_car_that_cannot_be_driven_is_refused(changes, says):
    with pytest.raises((ScenarioError, VehicleError)) as refused:
        read_scenario("slalom", changes=changes)
    assert says in refused.value.what and refused.value.paste and refused.value.read


def test_unknown_letters_are_refused_as_in_a_vehicle_file():
    with pytest.raises(VehicleError, match="wheelbase"):
        changed(vehicle__wheelbase="2.7 m")
    with pytest.raises(VehicleError, match="mass"):
        changed(told__mass="1500 kg")
