"""One column: noise, grid, holds and limits that were planted come back."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from similitude.inspection.channels import channel, grid_step, usual_hold


def manoeuvre(n=6000, rate=100.0):
    """A smooth signal of about one unit."""
    t = np.arange(n) / rate
    return np.sin(2 * np.pi * 0.3 * t) + 0.4 * np.sin(2 * np.pi * 0.71 * t + 1)


@pytest.mark.parametrize("noise", [0.003, 0.03, 0.3])
@pytest.mark.parametrize("seed", range(5))
def test_planted_noise_comes_back_under_a_manoeuvre(noise, seed):
    values = manoeuvre() + noise * np.random.default_rng(seed).standard_normal(6000)

    one = channel(values, header="r [rad/s]")

    # The median of 6000 overlapping fourth differences has an sd of about 2.5 %; four of them.
    assert one.noise == pytest.approx(noise, rel=0.1)
    assert not one.noise_is_bound


def test_a_signal_without_noise_only_bounds_it():
    one = channel(manoeuvre(), header="r")

    assert one.noise_is_bound and one.noise < 1e-3


@pytest.mark.parametrize("step", [1e-4, 0.0017, 0.1])
def test_a_grid_is_found_and_its_step(step):
    fine = manoeuvre() + 2 * step * np.random.default_rng(0).standard_normal(6000)

    assert grid_step(np.round(fine / step) * step) == pytest.approx(step, rel=1e-3)


def test_a_signal_off_any_grid_has_none():
    assert grid_step(manoeuvre() + 0.01 * np.random.default_rng(1).standard_normal(6000)) is None


@pytest.mark.parametrize("every", [2, 5, 10])
def test_a_slow_bus_shows_in_holds_and_fresh_share(every):
    readings = np.random.default_rng(2).standard_normal(6000 // every)
    one = channel(np.repeat(readings, every), header="r")

    assert one.hold == every
    assert one.fresh == pytest.approx(1 / every, rel=0.02)
    assert one.noise == pytest.approx(1.0, rel=0.2)  # a reading counts once


def test_a_parked_car_does_not_make_a_bus_slow():
    changed = np.zeros(1000, bool)
    changed[:300] = True

    assert usual_hold(changed) == 1


def test_a_signal_cut_off_is_seen_at_the_end_where_it_is():
    one = channel(np.clip(2 * manoeuvre(), -1.5, 10), header="delta")

    assert one.cut_low > 0.05 and one.cut_high == 0
    assert channel(manoeuvre(), header="delta").cut_low == 0


def test_standing_still_is_no_limit():
    speed = np.maximum(manoeuvre(), 0.0)

    assert channel(speed, header="U").cut_low == 0


@settings(max_examples=60, deadline=None)
@given(arrays(np.float64, st.integers(0, 60), elements=st.floats(allow_nan=True, allow_infinity=True)))
def test_whatever_the_values_every_number_is_finite_or_none(values):
    one = channel(values if values.size else np.full(1, np.nan), header="x")

    numbers = [x for x in dataclasses.astuple(one) if isinstance(x, float)]
    assert np.isfinite(numbers).all()
    if one.low is not None:
        assert one.low <= one.mean <= one.high
    assert 0 <= one.missing <= 1 and 0 <= one.fresh <= 1


@settings(max_examples=40, deadline=None)
@given(st.floats(1e-3, 1e3), st.integers(0, 10_000))
def test_statistics_are_in_the_unit_of_the_values(factor, seed):
    values = manoeuvre(400) + 0.02 * np.random.default_rng(seed).standard_normal(400)
    one, scaled = (channel(x, header="r") for x in (values, factor * values))

    for name in ("low", "high", "mean", "noise"):
        assert getattr(scaled, name) == pytest.approx(factor * getattr(one, name), rel=1e-9)
    assert (scaled.fresh, scaled.hold) == (one.fresh, one.hold)


def test_a_constant_column_says_so():
    assert channel(np.full(100, 3.0), header="x").is_constant
