"""Sensor noise out of a log: manoeuvres, rounding and a slow bus must not pass for noise."""

import numpy as np
import pytest

from similitude.noise import FLOOR, gyro_noise, sensor_noise
from similitude.units import Uncertain

STD = 0.0026  # rad/s
ROWS = 20_000
# sd of 1.4826 median|x| is 1.17/sqrt(n) of the sd for independent x (asymptotic variance of the
# MAD); second differences overlap, so count a third of them.  Three of those:
SAMPLING = 3 * 1.17 / np.sqrt(ROWS / 3)


def white(rows=ROWS, seed=0):
    return STD * np.random.default_rng(seed).standard_normal(rows)


def weave(rows=ROWS, rate=100.0):
    """0.3 rad/s at 0.5 Hz: its second difference is 0.3 (pi/rate)^2."""
    return 0.3 * np.sin(np.pi * np.arange(rows) / rate)


def test_white_noise_is_found():
    found = sensor_noise(white())
    assert found.std == pytest.approx(STD, rel=SAMPLING)
    assert found.fresh == 1.0


def test_a_manoeuvre_is_not_noise():
    curve = 0.3 * (np.pi / 100) ** 2  # its greatest second difference, added in quadrature
    widest = np.hypot(1, curve / (np.sqrt(6) * STD))
    found = sensor_noise(white() + weave()).std / STD
    assert 1 - SAMPLING < found < widest + SAMPLING


def test_a_constant_and_a_slope_add_nothing():
    tilted = white() + 0.2 + 1e-4 * np.arange(ROWS)
    assert sensor_noise(tilted).std == pytest.approx(sensor_noise(white()).std, rel=1e-9)


@pytest.mark.parametrize("held", [2, 5, 10])
def test_a_slow_bus_is_counted_once_for_each_reading(held):
    """Averaging N rows must leave what averaging N/held readings leaves: sd sqrt(held)."""
    readings = white(ROWS) + weave(ROWS, 100.0 / held)
    found = sensor_noise(np.repeat(readings, held))
    curve = 0.3 * (np.pi * held / 100) ** 2 / (np.sqrt(6) * STD)
    assert found.fresh == pytest.approx(1 / held, rel=1e-3)
    ratio = found.std / (STD * np.sqrt(held))
    assert 1 - SAMPLING < ratio < np.hypot(1, curve) + SAMPLING


@pytest.mark.parametrize("share", [0.1, 0.5, 1.0])
def test_rounding_adds_its_own_noise_and_chance_repeats_are_readings(share):
    step = share * STD
    found = sensor_noise(np.round((white() + weave()) / step) * step)
    truth = np.hypot(STD, step / np.sqrt(12))
    # the median of a rounded |second difference| is off by up to half a step of it
    coarse = 0.5 * 1.4826 * step / np.sqrt(6) / truth
    assert found.fresh == pytest.approx(1.0, abs=0.05)
    assert found.step == pytest.approx(step)
    assert abs(found.std / truth - 1) < SAMPLING + coarse + 0.03  # and the curve of the weave


def test_a_noiseless_rounded_sensor_has_the_noise_of_its_step():
    step = 0.005
    found = sensor_noise(np.round(weave() / step) * step)
    assert found.std >= step / np.sqrt(12)


def test_never_below_the_floor():
    for silent in (np.zeros(ROWS), weave(), np.full(ROWS, np.nan), np.array([0.1, np.nan]), np.zeros(0)):
        found = sensor_noise(silent)
        assert np.isfinite(found.std)
        assert found.std >= FLOOR


def test_missing_cells_change_nothing_but_the_sampling():
    holed = white() + weave()
    holed[np.random.default_rng(1).random(ROWS) < 0.1] = np.nan
    fewer = SAMPLING / np.sqrt(0.9**3)  # three cells in a row must be there
    whole = sensor_noise(white() + weave()).std
    assert sensor_noise(holed).std == pytest.approx(whole, rel=fewer)


def test_outliers_do_not_count():
    wild = white()
    wild[:: ROWS // 20] = 5.0
    assert sensor_noise(wild).std == pytest.approx(STD, rel=SAMPLING)


def test_what_the_vehicle_file_states_is_believed():
    assert gyro_noise(white(), Uncertain(0.01, None, "rad/s")).std == 0.01
    assert gyro_noise(white(), None) == sensor_noise(white())
