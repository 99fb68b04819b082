"""The printed numbers agree among themselves, and with the shipped scenario."""

import pytest

from similitude.paper import printed
from similitude.paper.claims_controller import car_and_driver


def test_the_wheelbase_is_the_sum_of_its_parts():
    assert printed.TEST_VEHICLE["a"] + printed.TEST_VEHICLE["b"] == pytest.approx(
        printed.WHEELBASE, abs=1e-12
    )


def test_the_shipped_scenario_drives_the_printed_vehicle():
    car, driver = car_and_driver()
    for name in ("m", "Iz", "a", "b", "Caf", "Car"):
        assert getattr(car, name) == printed.TEST_VEHICLE[name]
    assert driver.weights == printed.WEIGHTS and driver.design_speed == printed.DESIGN_SPEED


def test_a_vehicle_of_groups_has_them():
    groups = printed.groups_of(printed.of_groups(0.4, 0.3, 1.5, 0.2))
    assert groups == pytest.approx({"pi1": 0.4, "pi2": 0.6, "pi3": 0.3, "pi4": 0.45, "pi5": 0.2})
