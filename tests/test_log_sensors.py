"""What was not measured is found by place, size and length; what moves freely is left alone."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.log import read_log
from similitude.log_sensors import (
    check_sensors,
    clipped_rows,
    runs,
    spike_rows,
    straight_rows,
    stuck_rows,
)

from .test_log import DATA

T = np.arange(3000) * 0.01


def noisy(seed=0, *, size=0.1, noise=0.002, frequency=0.4):
    rng = np.random.default_rng(seed)
    return size * np.sin(2 * np.pi * frequency * T + seed) + noise * rng.standard_normal(T.size)


def driving(x):
    return {"t": T, "r": x, "U": np.full(T.size, 20.0) + 0.01 * np.sin(T)}


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 999), st.integers(60, 500), st.integers(5, 2400))
def test_a_stuck_stretch_is_found_where_it_is(seed, length, start):
    x = noisy(seed)
    x[start : start + length] = x[start]

    rows = np.flatnonzero(stuck_rows(driving(x), "r"))

    assert rows.min() == start
    assert rows.max() == min(start + length, T.size) - 1


def test_a_stuck_stretch_at_standstill_and_a_coarse_signal_are_no_fault():
    x = noisy()
    x[500:900] = 0.0
    standing = driving(x)
    standing["U"] = np.where((T > 4.9) & (T < 9.1), 0.0, 20.0)

    assert not stuck_rows(standing, "r").any()
    assert not stuck_rows(driving(np.round(noisy(noise=0), 1)), "r").any()


def steered(steer):
    """A car at 20 m/s that turns in proportion to the steer, with 2 mrad/s of noise."""
    return {"t": T, "delta": steer, "r": 3 * steer + noisy(3, size=0), "U": np.full(T.size, 20.0)}


def test_a_coarse_steer_that_a_driver_holds_still_is_no_fault_and_one_that_fell_silent_is():
    moves = np.where(T % 9 < 4, 0.04 * np.sin(2 * np.pi * T / 4), 0.0)
    coarse = np.round(moves, 3)
    assert not stuck_rows(steered(coarse), "delta").any()

    silent = steered(coarse)
    silent["delta"] = coarse.copy()
    silent["delta"][850:1250] = coarse[850]  # from 8.5 s, while the car turns from 9 s on
    rows = np.flatnonzero(stuck_rows(silent, "delta"))
    assert 850 - 460 <= rows.min() <= 850 and rows.max() == 1249

    assert not stuck_rows({"t": T, "delta": silent["delta"]}, "delta").any()


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 999), st.integers(40, 500), st.integers(5, 2400), st.booleans())
def test_an_interpolated_hole_is_found_even_as_six_digits(seed, length, start, printed):
    x = noisy(seed)
    x[start : start + length] = np.linspace(x[start], x[start + length - 1] + 0.05, length)
    if printed:
        x = np.array([float(f"{value:.6g}") for value in x])

    rows = np.flatnonzero(straight_rows(T, x))

    assert start <= rows.min() <= start + length // 4
    assert start + length - length // 4 <= rows.max() < start + length + 1


@pytest.mark.parametrize("every", [5, 10, 25])
def test_a_slow_yaw_rate_drawn_out_to_a_fast_clock_is_found(every):
    nodes = np.arange(0, T.size, every)

    rows = straight_rows(T, np.interp(T, T[nodes], noisy()[nodes]))

    assert np.count_nonzero(rows) == pytest.approx(T.size * (1 - 1 / every), rel=0.03)


@pytest.mark.parametrize("frequency", [0.02, 0.1, 0.4, 2.0])
def test_a_signal_without_noise_draws_no_lines(frequency):
    assert not straight_rows(T, noisy(noise=0, frequency=frequency)).any()


def test_the_hole_of_a_real_log_is_found():
    """f1tenth_ds2 has 27 s that nobody measured: the steer jumps, the yaw rate does not."""
    log = read_log(DATA / "f1tenth_ds2.csv")

    (found,) = [one for one in log.findings if one.fault == "interpolated"]

    assert found.value == pytest.approx(27.4, abs=0.1)
    assert log.t[found.rows[0] - 1] == pytest.approx(116.4, abs=0.05)
    repaired = read_log(DATA / "f1tenth_ds2.csv", fixes=["drop_interpolated"])
    assert np.count_nonzero(np.isnan(repaired.r)) == pytest.approx(found.value * log.rate, abs=1)
    assert not [one for one in repaired.findings if one.fault == "interpolated"]


@pytest.mark.parametrize("share", [0.4, 0.7, 0.95])
def test_a_saturated_sensor_is_found(share):
    x = noisy()
    limit = share * np.abs(x).max()

    rows = clipped_rows(np.clip(x, -limit, limit))

    np.testing.assert_array_equal(rows, np.abs(x) >= limit)


@pytest.mark.filterwarnings("error")
def test_a_steer_of_two_values_is_a_square_wave_and_not_clipped():
    assert not clipped_rows(0.05 * np.where(np.sin(4.4 * T + 0.1) > 0, 1, -1)).any()
    assert not clipped_rows(0.05 * np.sign(np.sin(4.4 * T))).any()  # and one zero, at its start


@pytest.mark.parametrize("digits", [1, 2, 3, 6])
def test_a_coarse_sine_is_not_clipped(digits):
    assert not clipped_rows(np.round(noisy(noise=0, frequency=1.7), digits)).any()
    assert not clipped_rows(np.round(noisy(), digits)).any()


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 999), st.lists(st.integers(1, 290), min_size=1, max_size=12, unique=True))
def test_single_spikes_are_found_and_nothing_else(seed, places):
    x = noisy(seed)
    rows = 10 * np.array(sorted(places))
    x[rows] += 0.3

    np.testing.assert_array_equal(np.flatnonzero(spike_rows(x)), rows)


def test_a_step_and_a_fast_manoeuvre_are_no_spikes():
    step = noisy() + 0.5 * (T > 7)
    burst = noisy() + 0.4 * np.sin(2 * np.pi * 8 * T) * ((T > 5) & (T < 8))

    assert not spike_rows(step).any()
    assert not spike_rows(burst).any()


def test_runs_are_starts_and_ends():
    starts, stops = runs(np.array([True, True, False, True, False]))

    assert starts.tolist() == [0, 3]
    assert stops.tolist() == [2, 4]


def test_missing_cells_are_no_fault():
    x = noisy()
    x[::2] = np.nan
    columns = {}

    assert check_sensors({"t": T}, columns) == []
    for find in (clipped_rows, spike_rows):
        assert not find(x).any()
    assert not straight_rows(T, x).any()
    assert not stuck_rows(driving(x), "r").any()
