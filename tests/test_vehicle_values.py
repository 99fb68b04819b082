"""From text to values: lines are found and keys are suggested."""

from pathlib import Path

import pytest

from similitude.errors import VehicleError
from similitude.vehicle_values import KEYS, SENSOR_KEYS, line_of, read_values, unknown_key


@pytest.mark.parametrize(
    ("key", "line"), [("L", " line 2"), ("sensor", " line 4"), ("noise", " line 5"), ("x", "")]
)
def test_a_key_is_found_on_its_line(key, line):
    text = '# L = 3\nL = "2 m"\n\n[sensor]\n "noise" = 1\n'

    assert line_of(key, text) == line


@pytest.mark.parametrize(
    ("key", "meant"),
    [("mass", "m"), ("Wheelbase", "L"), ("wheel_base", "L"), ("IZ", "Iz"), ("caf", "Caf"),
     ("steer_ratio", "steering_ratio"), ("steerlag", "steer_lag"), ("populaton", "population")],
)  # fmt: skip
def test_a_key_by_another_name_is_understood(key, meant):
    error = unknown_key(Path("car.toml"), key, KEYS, "")

    assert f"did you mean '{meant}'?" in error.what


def test_every_example_line_is_one_line():
    for key in (*KEYS, *SENSOR_KEYS):
        assert "\n" not in unknown_key(Path("car.toml"), key, {}, "").paste


def test_a_wheelbase_without_a_unit_is_offered_the_one_it_must_be_in(tmp_path):
    for number, unit in (("2690", "mm"), ("2.69", "m")):
        with pytest.raises(VehicleError) as caught:
            read_values(tmp_path / "car.toml", {"L": float(number)}, KEYS, f"L = {number}")
        assert caught.value.paste.endswith(f' {unit}"')
