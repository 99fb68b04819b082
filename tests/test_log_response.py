"""Steer, yaw rate, speed and lateral acceleration must fit each other; noise and delay must not matter."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.log_columns import choose_columns
from similitude.log_response import check_response, relate
from similitude.vehicle_file import Vehicle, read_vehicle

from .damaged_drives import sound_drives
from .simulated_drive import CAR, drive
from .test_log import DATA, REAL

HEADERS = {"t": "t [s]", "delta": "delta [rad]", "r": "r [rad/s]", "U": "U [m/s]", "ay": "ay [m/s^2]"}
CARS = {"bmw": "bmw_m8", "rav": "rav4", "f1t": "f1tenth"}


def check(values, *, wheelbase=CAR["L"], **headers):
    named = HEADERS | headers
    if "steering_wheel" in headers:
        named.pop("delta")
    columns, _ = choose_columns([named[name] for name in named if name in values or name == "steering_wheel"],
                                file="drive.csv", mapping={})  # fmt: skip
    return check_response(values, columns, wheelbase=wheelbase, file="drive.csv")


def values_of(log, **factors):
    return {name: getattr(log, name) * factors.get(name, 1) for name in ("t", "delta", "r", "U")}


@pytest.fixture(scope="module")
def quiet():
    """1 mrad rms of steer: peak lateral acceleration under 0.1 g, even with a unit wrong by 57."""
    return drive(rms=0.001, seconds=60)


def test_a_sound_log_is_believed(quiet):
    assert check(values_of(quiet)) == []
    assert check(values_of(quiet), wheelbase=None) == []


DEG = 180 / np.pi
WRONG = {
    "yaw rate in deg/s": ({"r": DEG}, {}, "yaw_rate_is_deg_per_s"),
    "yaw rate in rad/s": ({"r": 1 / DEG}, {"r": "r [deg/s]"}, "yaw_rate_is_rad_per_s"),
    "steer in deg": ({"delta": DEG}, {}, "steer_is_deg"),
    "steer in rad": ({"delta": 1 / DEG}, {"delta": "delta [deg]"}, "steer_is_rad"),
    "sign of the steer": ({"delta": -1}, {}, "flip_steer_sign"),
    "sign of the yaw rate": ({"r": -1}, {}, "flip_steer_sign"),
}


@pytest.mark.parametrize("case", WRONG)
def test_a_quiet_log_in_another_unit_or_sign_is_refused_with_its_repair(quiet, case):
    factors, headers, fix = WRONG[case]

    found = check(values_of(quiet, **factors), **headers)

    assert [one.certain for one in found] == [True]
    # Steer and yaw rate cannot be told apart from each other alone; then both are named.
    assert found[0].fix == fix or fix.split("_is_")[1].split("_")[0] in found[0].usually
    assert found[0].paste == f"--fix {found[0].fix}"


@pytest.mark.parametrize(
    ("factor", "headers", "paste"),
    [
        (15.3, {}, '--map "steering_wheel=delta"'),
        (1 / 15.3, {"steering_wheel": "SWA [rad]"}, '--map "delta=SWA"'),
    ],
)
def test_a_steering_wheel_taken_for_the_road_wheel_and_the_reverse_are_found(quiet, factor, headers, paste):
    (found,) = check(values_of(quiet, delta=factor), **headers)

    assert found.fault == "steer_against_yaw"
    assert found.paste == paste


@pytest.mark.parametrize("name", REAL)
@pytest.mark.parametrize("with_ay", [False, True])
def test_real_logs_are_believed_and_their_mirror_images_refused(name, with_ay):
    from similitude.log import read_log

    car = read_vehicle(DATA / f"{CARS[name[:3]]}.toml")
    log = read_log(DATA / f"{name}.csv")
    values = values_of(log) | ({"ay": log.ay} if with_ay and log.ay is not None else {})

    assert [one.fault for one in check(values, wheelbase=car.L.value)] == []
    mirrored = check(values | {"delta": -log.delta}, wheelbase=car.L.value)
    assert [(one.fault, one.certain) for one in mirrored] == [("steer_sign", True)]


def test_lateral_acceleration_tells_a_speed_in_another_unit():
    lively = max(sound_drives(20, seed=2), key=lambda one: one.rms * one.speed**2)
    columns = lively.columns

    assert check(columns, wheelbase=lively.L) == []
    (found,) = check(columns | {"U": 3.6 * columns["U"]}, wheelbase=lively.L)
    assert (found.fault, found.certain, found.fix) == ("ay_against_yaw", True, "speed_is_kmh")
    turned = check(columns | {"ay": -columns["ay"]}, wheelbase=lively.L)
    assert [(one.fault, one.certain) for one in turned] == [("ay_sign", False)]


@pytest.mark.parametrize(
    ("factor", "header", "fix"),
    [(1 / 1.609344, "U [km/h]", "speed_is_mph"), (1 / 1.852, "U [km/h]", "speed_is_knots"),
     (1 / 3.6, "U [km/h]", "speed_is_m_per_s"), (1.609344, "U [mph]", "speed_is_kmh")],
)  # fmt: skip
def test_lateral_acceleration_names_the_unit_of_a_speed(factor, header, fix):
    """A car driven in steady turns, where its lateral acceleration is U r and nothing else."""
    t = np.arange(0, 60, 0.02)
    rng = np.random.default_rng(0)
    turning = sum(
        np.sin(w * t + p) for w, p in zip(rng.uniform(0.2, 1.5, 8), rng.uniform(0, 6, 8), strict=True)
    )
    rate = 0.03 * turning
    values = {"t": t, "delta": rate * 2.6 / 20, "r": rate, "U": np.full(t.size, 20.0), "ay": 20.0 * rate}
    assert check(values) == []

    found = check(values | {"U": factor * values["U"]}, U=header)

    assert fix in {one.fix for one in found}


@pytest.mark.parametrize("speed", [1.0, 1 / 3.6])
def test_only_oversteer_turns_a_car_more_than_its_steer_asks(speed):
    """At 14 m/s a car answers with 0.8 of the yaw rate of one on rails; with its speed too small, 2.9."""
    log = drive(U=14.0, seconds=60)
    found = check(values_of(log, U=speed), U="U [km/h]")
    if speed == 1.0:
        assert found == []
    else:
        assert [(one.fault, one.certain, one.fix) for one in found] == [
            ("steer_against_yaw", False, "speed_is_m_per_s")
        ]


def test_an_ay_that_follows_a_slaloms_sine_is_compared_in_size():
    t = np.arange(0, 20, 0.01)
    rate = 0.1 * np.sin(np.pi * t) + 0.001 * np.random.default_rng(0).standard_normal(t.size)
    values = {"t": t, "delta": 0.03 * np.sin(np.pi * t + 0.3), "r": rate, "U": np.full(t.size, 16.0)}
    assert check(values | {"ay": 16.0 * rate}) == []
    found = check(values | {"ay": 1.4 * 16.0 * rate})
    assert [(one.fault, one.certain) for one in found] == [("ay_against_yaw", False)]


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.05, 3.0))
def test_signals_that_have_nothing_to_do_with_each_other_are_not_related(seed, width):
    """Two slow random signals look alike now and then; Bartlett's chance must know."""
    rng = np.random.default_rng(seed)
    t = np.arange(1200) * 0.05
    kernel = np.exp(-np.arange(0, 5 * width, 0.05) / width)
    x, y = (np.convolve(rng.standard_normal(1200), kernel, "same") for _ in range(2))

    relation = relate(t, x, y, level_counts=False)

    assert not relation.counts


@given(st.floats(0.0, 0.3), st.floats(0.2, 4.0), st.integers(0, 99))
@settings(max_examples=40, deadline=None)
def test_the_two_slopes_hold_the_true_one_whichever_signal_is_noisy(noise, slope, seed):
    rng = np.random.default_rng(seed)
    t = np.arange(2000) * 0.05
    x = np.convolve(rng.standard_normal(2000), np.ones(20) / 20, "same")
    y = slope * np.roll(x, 3)
    which = rng.random() < 0.5
    spoilt = [one + noise * one.std() * rng.standard_normal(2000) * flag
              for one, flag in ((x, which), (y, not which))]  # fmt: skip

    relation = relate(t, *spoilt, level_counts=False)

    assert 0.97 * relation.low <= slope <= 1.03 * relation.high


def test_a_standing_car_says_nothing(quiet):
    values = values_of(replace(quiet, U=quiet.U * 0))

    assert check(values) == []
    assert Vehicle("car").L is None


def test_a_steer_that_is_missing_wherever_the_car_moves_says_nothing(quiet):
    values = values_of(quiet)
    moving = np.arange(quiet.samples) % 2 == 0

    with np.errstate(all="raise"):
        assert not check(values | {"U": values["U"] * moving, "delta": np.where(moving, np.nan, 0.01)})


@pytest.mark.parametrize("sign", [1, -1])
def test_a_slalom_of_one_frequency_with_a_turned_sign_gets_a_word(sign):
    """Sines of equal frequency may be alike by chance, so it is not refused; nor is it passed over."""
    t = np.arange(0, 20, 0.01)
    answer = 0.1 * np.sin(np.pi * t - 0.3) + 0.002 * np.random.default_rng(0).standard_normal(t.size)
    steer = 0.03 * np.sin(np.pi * t)
    found = check({"t": t, "delta": sign * steer, "r": answer, "U": np.full(t.size, 16.0)})
    said = [(one.fault, one.certain, one.fix) for one in found]
    assert said == ([] if sign > 0 else [("steer_sign", False, "flip_steer_sign")])
