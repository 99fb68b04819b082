"""Repeats of a slow bus are told from a coarse sensor, and cost neither accuracy nor honesty."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.filter_run import population_setup
from similitude.identify_setup import prepare
from similitude.noise import gyro_noise
from similitude.slow_bus import (
    bridged,
    held_columns,
    hold_period,
    new_readings,
    through,
    without_lines,
    without_repeats,
)

from .montecarlo.experiment import drawn_prior, fleet, log_of_car
from .simulated_drive import drive, vehicle

RNG = np.random.default_rng(0)
NOISY = np.cumsum(RNG.standard_normal(6000)) * 0.01 + 0.002 * RNG.standard_normal(6000)


def held(values, period, phase=0):
    """Each reading for ``period`` rows."""
    rows = np.arange(len(values))
    return values[np.maximum((rows + phase) // period * period - phase, 0)]


@settings(max_examples=40, deadline=None)
@given(st.integers(2, 20), st.integers(0, 19))
def test_the_period_of_a_bus_is_found_and_every_reading_kept(period, phase):
    column = held(NOISY, period, phase % period)
    new = new_readings(column, hold_period(column))

    assert hold_period(column) == period
    assert set(column[new]) == set(column)
    # the first one may have been on the bus for a while
    assert (np.diff(np.flatnonzero(new))[1:] == period).all()


@pytest.mark.parametrize("step", [0.0, 0.001, 0.01, 0.05])
def test_a_coarse_sensor_is_no_bus(step):
    column = np.round(NOISY / step) * step if step else NOISY
    assert hold_period(column) == 1
    assert new_readings(column, 1).all()


def test_a_bus_whose_clock_wanders_gives_one_reading_for_each_of_its_own():
    """Readings every 5 rows, a row early or late: none is counted twice."""
    at = np.cumsum(RNG.choice([4, 5, 5, 5, 6], 1000))
    at = at[at < 5000]
    column = NOISY[at[np.maximum(np.searchsorted(at, np.arange(5000), "right") - 1, 0)]]
    new = new_readings(column, hold_period(column))

    assert hold_period(column) == 5
    assert new.sum() == pytest.approx(np.count_nonzero(np.diff(column)) + 1, rel=0.01)


def test_a_steer_that_rests_is_no_slow_bus():
    column = np.zeros(5000)
    column[2000:2600] = 0.1
    assert hold_period(column) == 1


def test_the_curve_goes_through_every_reading_and_keeps_a_sine():
    t = np.arange(0, 20, 0.01)
    at = t[::10]
    curve = through(t, at, np.sin(2 * np.pi * at))
    assert curve[::10] == pytest.approx(np.sin(2 * np.pi * at), abs=1e-12)
    # cubic Hermite with central slopes: about (2 pi h)^3/24 = 1 %; a straight line takes off 5 %
    inside = slice(100, -100)
    assert np.abs(curve - np.sin(2 * np.pi * t))[inside].max() < 0.02


def test_repeats_of_the_yaw_rate_are_missing_and_those_of_the_steer_lie_on_a_curve():
    log = drive(seconds=60, rms=0.005, band=(0.15, 1.0))
    slow = replace(log, r=held(log.r, 5), delta=held(log.delta, 5))
    periods = held_columns(slow)
    clean = without_repeats(slow, periods)

    assert periods == {"r": 5, "delta": 5}
    assert np.isfinite(clean.r).mean() == pytest.approx(1 / 5, abs=1e-3)
    assert np.array_equal(clean.r[::5], log.r[::5])
    # the held one is two rows late on average, the curve is not
    late, now = (np.abs(one.delta - log.delta).std() for one in (slow, clean))
    assert now < late / 5
    assert np.isfinite(bridged(clean).r)[:-5].all()


def test_a_column_that_is_too_slow_is_left_as_it_is():
    log = drive(seconds=60, rms=0.005)
    assert held_columns(replace(log, r=held(log.r, 40))) == {}


def test_what_was_held_is_among_what_was_assumed_of_a_log():
    log = drive(seconds=60, rms=0.005)
    ready = prepare(replace(log, r=held(log.r, 5)), vehicle())

    assert ready.held == {"r": 5}
    # its noise is that of a reading, known to a tenth or so
    assert ready.noise.std == pytest.approx(prepare(log, vehicle()).noise.std, rel=0.35)


@pytest.mark.slow
@pytest.mark.parametrize(("yaw", "steer"), [(2, 1), (5, 5), (10, 1), (1, 10)])
def test_a_slow_bus_costs_no_honesty(yaw, steer):
    """Taken row by row, intervals of 95 % covered between 45 and 92 % in these cells."""
    cars = fleet(11, cars=30, steer_rms=6e-3, halve=False)
    covered = []
    for i in range(30):
        log = log_of_car(cars, i)
        log = replace(log, r=held(log.r, yaw), delta=held(log.delta, steer))
        periods = held_columns(log)
        clean = without_repeats(log, periods)
        std = gyro_noise(log.r[new_readings(log.r, periods.get("r", 1))], None).std
        setup = population_setup(clean, drawn_prior(), L=cars.L[i], noise_std=std, input_scale_sd=0.02)
        done = setup.run()
        away = np.abs(np.log(done.output("estimate") / cars.K[i])) / np.sqrt(done.output("variance"))
        covered.append(np.mean((away < 1.96)[cars.t > 10]))
    assert np.mean(covered) >= 0.90


def test_lines_across_a_hole_are_no_readings():
    log = log_of_car(fleet(3, cars=1, duration=60.0, halve=False), 0)
    hole = (log.t > 20) & (log.t < 25)
    drawn = np.where(hole, np.interp(log.t, log.t[~hole], log.r[~hole]), log.r)

    measured = without_lines(replace(log, r=drawn))

    assert without_lines(log) is log
    assert np.array_equal(np.isnan(measured.r), hole)
    assert np.array_equal(measured.r[~hole], log.r[~hole])


def test_a_hole_that_was_drawn_across_does_not_move_the_stiffness():
    """As measured, the line says that a car under steer does not turn: K would fall to its limit."""
    log = log_of_car(fleet(3, cars=1, duration=90.0, halve=False), 0)
    hole = log.t > 60
    hole[-1] = False
    drawn = replace(log, r=np.where(hole, np.interp(log.t, log.t[~hole], log.r[~hole]), log.r))
    missing = replace(log, r=np.where(hole, np.nan, log.r))

    found, expected = (prepare(one, vehicle()).setup.run() for one in (drawn, missing))

    assert found.value("K") == expected.value("K")
