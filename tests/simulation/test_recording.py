"""Drives as tables: same seed same drive, sensors see what they should, truth is the truth."""

import numpy as np
import pytest

from similitude.simulation.car import GRAVITY, Car
from similitude.simulation.recording import run_scenario
from similitude.simulation.scenario import read_scenario

from .quiet_drive import SATURATING, quiet


def test_the_same_seed_is_the_same_drive_whoever_drives_beside_it():
    scenario = read_scenario("highway", changes={"run.duration": "5 s"})
    one, again = run_scenario(scenario, [3])[0], run_scenario(scenario, [3])[0]
    beside = run_scenario(scenario, [2, 3])[1]
    other = run_scenario(scenario, [2])[0]
    for name in one.log:
        np.testing.assert_array_equal(one.log[name], again.log[name])
        # floats and arrays may round a sine differently, and a rounded cell may then be the next one
        np.testing.assert_allclose(one.log[name], beside.log[name], atol=0.0101)
    assert np.abs(one.truth["r [rad/s]"] - beside.truth["r [rad/s]"]).max() < 1e-12
    assert (one.log["r [rad/s]"] != other.log["r [rad/s]"]).mean() > 0.9


def test_perfect_sensors_write_the_truth():
    drive = run_scenario(quiet(SATURATING), [0])[0]
    for name in ("t [s]", "r [rad/s]", "U [m/s]", "ay [m/s^2]", "delta [rad]"):
        np.testing.assert_allclose(drive.log[name], drive.truth[name], atol=1e-12)
    assert drive.truth["t [s]"].size == 1001 and drive.warnings == ()


def test_lateral_acceleration_is_the_rate_of_lateral_velocity_and_the_turn():
    truth = run_scenario(quiet(SATURATING, run__log_rate="200 Hz"), [0])[0].truth
    U, r = truth["U [m/s]"], truth["r [rad/s]"]
    v = U * np.tan(truth["beta [rad]"])
    by_difference = np.gradient(v, truth["t [s]"]) + U * r
    # central differences over 5 ms of a signal of half a hertz
    assert np.abs(by_difference - truth["ay [m/s^2]"])[2:-2].max() < 1e-2


def test_place_is_the_integral_of_speed_and_heading():
    truth = run_scenario(quiet(SATURATING), [0])[0].truth
    angle = truth["psi [rad]"] + truth["beta [rad]"]
    speed = truth["U [m/s]"] / np.cos(truth["beta [rad]"])
    steps = 0.01 * (speed * np.sin(angle))
    y = np.concatenate([[0], np.cumsum(0.5 * (steps[1:] + steps[:-1]))])
    np.testing.assert_allclose(y, truth["y [m]"], atol=1e-4)


def test_an_accelerometer_does_not_feel_the_bank_pull():
    bank = {"bank": [{"at": "0 s", "angle": "3 deg"}]}
    drive = run_scenario(quiet(SATURATING, road=bank), [0])[0]
    np.testing.assert_allclose(
        drive.truth["ay [m/s^2]"] - drive.log["ay [m/s^2]"], GRAVITY * np.sin(np.deg2rad(3)), atol=1e-9
    )
    np.testing.assert_allclose(drive.truth["bank [rad]"], np.deg2rad(3))


def test_an_accelerometer_away_from_the_centre_of_gravity_feels_the_turn_begin():
    """ahead r', with r' from the yaw rate that is written."""
    behind = 0.5
    drive = run_scenario(
        quiet(SATURATING, sensors={"ay_behind": f"{behind} m"}, run__log_rate="200 Hz"), [0]
    )[0]
    t, r = drive.log["t [s]"], drive.truth["r [rad/s]"]
    a = drive.truth["pi1 [-]"][0] * quiet(SATURATING).vehicle.length.value
    felt = drive.log["ay [m/s^2]"] - drive.truth["ay [m/s^2]"]
    # central differences over 5 ms of a signal of half a hertz
    np.testing.assert_allclose(felt[2:-2], (a - behind) * np.gradient(r, t)[2:-2], atol=1e-2)
    assert np.abs(felt).max() > 0.05


def test_the_vehicle_file_tells_the_place_it_is_told():
    scenario = read_scenario("highway", changes={"told": {"accelerometer": "1.2 ± 0.05 m"}})
    assert 'accelerometer = "1.2 ± 0.05 m"' in scenario.vehicle.vehicle_file().split("[sensor]")[1]


@pytest.mark.parametrize("steer_as", ["road_wheel", "steering_wheel", "command"])
def test_the_steer_that_is_logged(steer_as):
    changes = {"vehicle__steering_ratio": "15", "actuator": {"delay": "50 ms", "scale": 1.1}}
    drive = run_scenario(quiet(sensors={"steer_as": steer_as}, **changes), [0])[0]
    header = "steering_wheel [rad]" if steer_as == "steering_wheel" else "delta [rad]"
    logged, acting = drive.log[header], drive.truth["delta [rad]"] / 1.1
    expected = {"road_wheel": acting, "steering_wheel": 15 * acting, "command": drive.truth["command [rad]"]}
    np.testing.assert_allclose(logged, expected[steer_as], atol=1e-12)


def test_a_late_sensor_is_late_and_no_accelerometer_leaves_no_column():
    drive = run_scenario(quiet(sensors={"log_ay": "no", "r": {"delay": "30 ms"}}), [0])[0]
    np.testing.assert_allclose(drive.log["r [rad/s]"][3:], drive.truth["r [rad/s]"][:-3], atol=1e-9)
    assert "ay [m/s^2]" not in drive.log


def test_cars_of_one_s_own_drive_a_scenario():
    groups = {"L": 2.7, "pi1": 0.44, "eta": 1.4, "rho": 1.0, "m": 1500.0}
    cars = Car.of_groups(K=np.array([100.0, 150.0]), **groups)
    first, second = run_scenario(quiet(SATURATING), [0, 1], car=cars)
    assert first.truth["K [m^2/s^2]"][0] == pytest.approx(100)
    assert second.truth["pi3 [-]"][0] == pytest.approx(150 / (80 / 3.6) ** 2)
    assert second.truth["eta [-]"][0] == pytest.approx(1.4)


def test_stiffness_moves_K_and_friction_does_not():
    surface = [{"begin": "5 s", "friction": 0.5}, {"begin": "5 s", "stiffness": 0.5}]
    for one, factor in zip(surface, (1.0, 0.5), strict=True):
        truth = run_scenario(quiet(SATURATING, road={"surface": [one]}), [0])[0].truth
        K = truth["K [m^2/s^2]"]
        assert K[-1] == pytest.approx(factor * K[0])
        assert truth["friction [-]"][-1] == (0.5 if factor == 1 else 1.0)


def test_a_car_that_spins_is_said():
    ice = {"friction": 0.05}
    drive = run_scenario(
        quiet(SATURATING, road=ice, run__duration="30 s",
              driver={"kind": "turns", "amplitude": "500 mrad", "rise": "1 s", "hold": "9 s", "rest": "1 s"},
              vehicle__Car="60 kN/rad"), [0])[0]  # fmt: skip
    assert (np.abs(drive.truth["beta [rad]"]).max() > np.pi / 4) == bool(drive.warnings)
