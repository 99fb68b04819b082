"""A vehicle file is read strictly; what follows from what is written is said."""

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from similitude.errors import SimilitudeError, VehicleError
from similitude.vehicle_file import NEW_VEHICLE, read_vehicle


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("vehicles")


def read(folder, text):
    path = folder / "car.toml"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_vehicle(path)


def test_the_new_vehicle_file_is_readable_as_printed(folder):
    vehicle = read(folder, NEW_VEHICLE)

    assert vehicle.L.value == 2.69
    assert vehicle.m is None
    assert vehicle.name == "my car"


def test_the_new_vehicle_file_is_readable_with_every_line_filled_in(folder):
    every = re.sub(r"(?m)^# (?=\w+ = |\[)", "", NEW_VEHICLE)

    vehicle = read(folder, every)

    names = ("L", "a", "b", "m", "Iz", "Caf", "Car", "steering_ratio", "steer_lag")
    assert all(getattr(vehicle, name) is not None for name in (*names, "yaw_rate_noise"))
    assert vehicle.steer == "command" and read(folder, NEW_VEHICLE).steer is None
    assert vehicle.yaw_rate_noise.value == pytest.approx(math.radians(0.15), rel=1e-15)
    assert set(vehicle.origins.values()) == {"vehicle file car.toml"}


@pytest.mark.parametrize(
    ("lines", "derived", "origin"),
    [
        ('a = "1.2 ± 0.03 m"\nb = "1.5 ± 0.04 m"', "L", "a + b"),
        ('L = "2.7 ± 0.03 m"\na = "1.2 ± 0.04 m"', "b", "L - a"),
        ('L = "2.7 ± 0.03 m"\nb = "1.5 ± 0.04 m"', "a", "L - b"),
    ],
)
def test_two_lengths_give_the_third_with_its_deviation_and_its_origin(folder, lines, derived, origin):
    vehicle = read(folder, lines)

    assert vehicle.L.value == pytest.approx(vehicle.a.value + vehicle.b.value, rel=1e-15)
    assert vehicle.L.value == pytest.approx(2.7, rel=1e-15)
    assert getattr(vehicle, derived).sd == pytest.approx(0.05, rel=1e-12)
    assert vehicle.origins[derived] == origin


def test_a_population_that_is_not_named_is_called_assumed(folder):
    vehicle = read(folder, 'L = "2.7 m"')

    assert vehicle.population == "passenger_cars"
    assert vehicle.origins["population"].startswith("assumed")


def test_windows_line_ends_a_byte_order_mark_and_a_bare_ratio_are_fine(folder):
    vehicle = read(folder, '\ufeffL = "2.7 m"\r\nsteering_ratio = 15.3\r\n')

    assert vehicle.steering_ratio.value == 15.3


def test_a_deviation_may_stand_beside_its_value(folder):
    vehicle = read(folder, 'L = "2.7 m"\nm = { value = "2.01 t", sd = "50 kg" }')

    assert vehicle.m.value == pytest.approx(2010.0, rel=1e-15)
    assert vehicle.m.sd == 50.0


L = 'L = "2.7 m"\n'
REFUSED = {
    "no unit": ("L = 2.7", "line 1: L = 2.7 has no unit", 'L = "2.7 m"'),
    "no quotes": ("L = 2.7 m", "is not TOML", 'L = "2.7 m"'),
    "decimal comma": ('L = "2,7 m"', "'2,7 m'", 'L = "2.7 m"'),
    "synonym": ('wheelbase = "2.7 m"', "did you mean 'L'", 'L = "2.69 m"'),
    "lower case": (L + 'iz = "3000 kg m^2"', "did you mean 'Iz'", 'Iz = "3000 kg m^2"'),
    "misspelt": (L + "steering_rato = 15", "did you mean 'steering_ratio'", "steering_ratio"),
    "noise misplaced": (L + 'yaw_rate_noise = "1 deg/s"', "under \\[sensor\\]", "sensor.yaw"),
    "mass misplaced": (L + '[sensor]\nm = "1 kg"', "above the line \\[sensor\\]", "m ="),
    "b negative": (L + 'b = "-1.2 m"', "line 2: b = -1.2 m is not positive", 'b = "1.2 m"'),
    "lengths": (L + 'a = "1.2 m"\nb = "1.4 m"', "L = 2.7 m is not a \\+ b", 'L = "2.6 m"'),
    "a longer than L": (L + 'a = "3 m"', "a = 3 m is not shorter than L", 'a = "'),
    "mass in tonnes": (L + 'm = "2.01 kg"', "m = 2.01 kg cannot be", 'm = "2010 kg"'),
    "mass too large": (L + 'm = "2010 t"', "cannot be one of population", 'm = "2010 kg"'),
    "length in mm": ('L = "2700 m"', "L = 2700 m cannot be", 'L = "2.7 m"'),
    "model car": ('L = "0.32 m"\nm = "3.3 kg"', "cannot be", 'population = "small_cars_1to10"'),
    "ratio negative": (L + "steering_ratio = -15", "not positive", "steering_ratio = 15"),
    "ratio inverted": (L + "steering_ratio = 0.065", "outside 1 to 60", "steering_ratio"),
    "ratio not finite": (L + "steering_ratio = nan", "'nan'", "steering_ratio"),
    "lag in ms": (L + 'steer_lag = "20 s"', "steer_lag = 20 s lies outside", '"20 ms"'),
    "sd negative": (L + 'm = "2010 ± -5 kg"', "'-5 kg'.*not positive", 'm = "2010 kg"'),
    "sd too large": (L + 'm = "50 ± 2010 kg"', "as large as its value", 'm = "2010 ± 50 kg"'),
    "dimension": ('L = "2.7 kg"', "'kg' has the dimension 'kg', but 'm'", 'L = "'),
    "inertia": (L + 'm = "2 t"\nIz = "3 kg m^2"', "of m L\\^2", "Iz ="),
    "per degree": (L + 'm = "2 t"\nCaf = "1500 N/rad"', "weight", 'Caf = "1500 N/deg"'),
    "population": (L + 'population = "cars"', "there are 'passenger_cars', ", "population ="),
    "steer": (L + 'steer = "comand"', "line 2: steer 'comand' is not known; there are", 'steer = "command"'),
    "steer is a number": (L + "steer = 15.3", "there are 'measured', 'command'", "steer ="),
    "no wheelbase": ('m = "2010 kg"', "neither 'L' nor both 'a' and 'b'", 'L = "2.69 m"'),
    "empty": ("", "neither 'L'", 'L = "2.69 m"'),
    "name is a number": (L + "name = 3", "name = '3' is not text", 'name = "3"'),
    "twice": (L + L, "Cannot overwrite", "L ="),
    "a truth value": ("L = true", "is no value with a unit", 'L = "2.69 m"'),
    "no text": (b"\xff\xfe\x00L", "not UTF-8", "similitude vehicle --new"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_is_refused_with_the_line_to_write(folder, case):
    text, what, paste = REFUSED[case]

    with pytest.raises(VehicleError, match=what) as caught:
        read(folder, text)

    error = caught.value
    assert "car.toml" in error.what
    assert error.paste.startswith(paste) or paste in error.paste
    assert all([error.what, error.usually, error.paste, error.read])
    assert "\n" not in error.paste


@pytest.mark.parametrize(
    "case", [case for case in REFUSED if "=" in REFUSED[case][2] and "L = 2.7 m" not in case]
)
def test_the_line_to_paste_is_itself_a_good_line(folder, case):
    with pytest.raises(VehicleError) as caught:
        read(folder, REFUSED[case][0])
    line = caught.value.paste
    key = re.match(r"[\w.]+", line).group()
    small = "small" in line
    frame = {"L": "0.32 m" if small else "2.7 m", "m": "3.3 kg" if small else "2000 kg"}
    lines = [f'{name} = "{value}"' for name, value in frame.items() if name != key]

    read(folder, "\n".join([*lines, line]))


def test_a_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(VehicleError, match=r"none\.toml' cannot be opened"):
        read_vehicle(tmp_path / "none.toml")


@given(st.binary(max_size=80))
def test_any_damage_is_a_vehicle_or_a_refusal(folder, tail):
    try:
        read(folder, b'L = "2.7 m"\nm = "20' + tail)
    except SimilitudeError as error:
        assert all([error.what, error.usually, error.paste, error.read])


@pytest.mark.parametrize("line", ['population = ["passenger_cars"]', "[population]", "population = 3"])
def test_a_population_that_is_no_text_is_refused(tmp_path, line):
    path = tmp_path / "car.toml"
    path.write_text(f'L = "2.7 m"\n{line}\n')
    with pytest.raises(VehicleError, match="is not known"):
        read_vehicle(path)
