"""The configuration: complete, limits where they belong, and in units that obey similarity."""

import numpy as np
import pytest

from similitude.accelerometer import Accelerometer
from similitude.errors import ProgramError
from similitude.filter_config import (
    DESIGN,
    LIMIT_SD,
    LIMIT_SD_TARGET,
    ROOM,
    filter_config,
)
from similitude.program.library import shipped
from similitude.unit import parse_unit

from .filter_rig import CAR, NOISE, car_config
from .rough_drive import rough_drive

LIBRARY = shipped("bicycle_population")


def at(config, name):
    return config[LIBRARY.index("config", name)]


def test_every_field_is_filled_from_prior_vehicle_log_or_design():
    config = car_config(LIBRARY)
    assert config.shape == (len(LIBRARY.names("config")),)
    assert np.isfinite(config).all()
    assert at(config, "noise_variance") == NOISE**2
    assert at(config, "L") == 2.7
    for name, value in DESIGN.items():
        if name != "beyond_time":  # of tyres that saturate
            assert at(config, name) == value
    saturating = shipped("saturating_bicycle_population")
    own = car_config(saturating)[saturating.index("config", "beyond_time")]
    assert own == DESIGN["beyond_time"] > DESIGN["seldom"]


def test_the_prior_goes_in_as_it_is():
    config = car_config(LIBRARY)
    assert [at(config, f"{name}_prior") for name in CAR.names] == CAR.mean.tolist()
    start = LIBRARY.index("config", "P_prior")
    upper = config[start : start + 10]
    assert np.array_equal(upper, CAR.covariance[np.triu_indices(4)])
    assert at(config, "prior_information") == pytest.approx(1 / 0.25)


def test_limits_are_so_many_sd_away_and_K_has_room_for_a_halved_stiffness():
    config = car_config(LIBRARY)
    widths = LIMIT_SD * CAR.std
    widths[0] = LIMIT_SD_TARGET * np.hypot(CAR.std[0], ROOM)
    for i, name in enumerate(CAR.names):
        low, mean, high = (at(config, f"{name}_{side}") for side in ("low", "prior", "high"))
        if CAR.kinds[i] == "log":
            assert [np.log(mean / low), np.log(high / mean)] == pytest.approx([widths[i]] * 2)
        else:
            assert [mean - low, high - mean] == pytest.approx([widths[i]] * 2)
    sharp = CAR.known("K", 145.68, 0.01, "exactly known")
    config = filter_config(LIBRARY, sharp, L=2.7, noise_std=NOISE, input_scale_sd=0.02)
    assert at(config, "K_low") < 145.68 / 2


def test_a_change_by_name_and_a_name_that_does_not_exist():
    assert at(car_config(LIBRARY, drift=0.5), "drift") == 0.5
    with pytest.raises(ProgramError, match="drifft"):
        car_config(LIBRARY, drifft=0.5)


# Similarity: lengths times s and times times sqrt(s) leave accelerations, groups and g alone.
# With s = 4 both factors are powers of two, so floating point must follow to the last bit.
LENGTH, TIME = 4.0, 2.0


def factor(unit):
    powers = parse_unit(unit).dimension.exponents
    assert powers.keys() <= {"length", "time"}
    return LENGTH ** float(powers.get("length", 0)) * TIME ** float(powers.get("time", 0))


def factors(struct):
    """The factor of every real of a struct, from its declared unit alone."""
    rows = getattr(LIBRARY.layout, struct.upper())
    found = [np.full(size, factor(unit)) for _, unit, _, size in rows]
    if struct == "state":
        # The covariance has the units of its coordinates; only the yaw bias is not a pure number.
        names = [name for name, *_ in rows]
        sides = np.array([factor("rad/s") if n == "output_bias" else 1.0 for n in LIBRARY.layout.COORDINATES])
        found[names.index("P")] = np.outer(sides, sides)[np.triu_indices(sides.size)]
    return np.concatenate(found)


def test_a_car_four_times_as_long_in_half_as_fast_a_film_is_the_same_car_bit_for_bit():
    config, rows = car_config(LIBRARY), rough_drive(5000, seed=3)
    possible = (rows[:, 0] > 1e-5) & (rows[:, 0] < 1e5)  # away from the two absolute bounds on dt
    rows = rows[possible]
    state = LIBRARY.start(config)
    larger_state = state * factors("state")

    outputs, status = LIBRARY.run(config, state, rows)
    with np.errstate(over="ignore"):
        larger_rows = rows * factors("sample")
    larger, larger_status = LIBRARY.run(config * factors("config"), larger_state, larger_rows)

    assert np.array_equal(status, larger_status)
    assert len(set(status.tolist())) >= 6
    assert np.array_equal(outputs * factors("output"), larger)
    assert np.array_equal(state * factors("state"), larger_state)


def test_the_start_itself_scales():
    """All but the averaging rate that begins at 1/s whatever the car."""
    config = car_config(LIBRARY)
    expected = LIBRARY.start(config) * factors("state")
    found = LIBRARY.start(config * factors("config"))
    names = np.array(LIBRARY.names("state"))
    assert set(names[found != expected]) <= {"settling"}


def test_bank_and_wind_are_in_the_bias_of_an_accelerometer():
    library, meter = shipped("bicycle_with_accelerometer_small_population"), Accelerometer(1.3, 0.05, 0.1)
    config = filter_config(library, CAR, L=2.6, noise_std=NOISE, input_scale_sd=0.02, accelerometer=meter)
    value = dict(zip(library.names("config"), config, strict=True))
    mounting, bank, wind = 0.3, 0.3, 0.1  # m/s^2

    assert value["lead_prior"] == pytest.approx(CAR.mean[1] - 0.5)
    assert value["ay_bias_sd"] ** 2 == pytest.approx(mounting**2 + bank**2 + wind**2, rel=1e-3)
    assert value["ay_bias_drift"] == pytest.approx(2.5e-3 + 2 * (bank**2 / 5.0 + wind**2 / 0.5))
    assert value["longest"] <= 2 * value["ay_time"]
