"""A signal that goes on at the other end of its range is found, and counted on to what it was."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from similitude.log_survey import survey
from similitude.signal_faults.overflow import BULGE, overflow, unwrapped

from ..damaged_drives import Drive, sound_drives, spiked, write

STEP = 1e-4  # rad/s


def turning(seed=0, *, step=STEP, most=0.3, size=3000, noise=1e-3):
    """A yaw rate of two sines in whole steps, up to `most` [rad/s]."""
    rng = np.random.default_rng(seed)
    t = 0.02 * np.arange(size)
    x = 0.2 * np.sin(rng.uniform(0.8, 2) * t) + 0.1 * np.sin(rng.uniform(2, 4) * t)
    return np.round((most / 0.3 * x + noise * rng.standard_normal(size)) / step) * step


def wrapped(x, span):
    return (x + span / 2) % span - span / 2


@settings(max_examples=60, deadline=None)
@example(seed=6194, bits=8, most=0.2421875)  # its bow is 6 % of the range's half, no higher than two steps
@example(seed=17, bits=16, most=0.25)  # no two rows in a row are one step apart
@given(seed=st.integers(0, 10_000), bits=st.sampled_from([8, 12, 16]), most=st.floats(0.24, 0.4))
def test_what_went_round_is_counted_on_to_the_last_digit(seed, bits, most):
    x = turning(seed, step=0.4 / 2**bits, most=most)
    seen = wrapped(x, 0.4)
    beyond = np.count_nonzero(np.abs(x) > 0.2)
    least = 2 * BULGE * 0.4 + 3 * np.median(np.abs(np.diff(x)))  # of a bow beyond the end, with room
    if beyond < 100 or np.abs(x).max() < 0.2 + least:  # it hardly left its range: spikes
        return

    found = overflow(seen)

    assert found is not None and found.is_binary
    np.testing.assert_allclose(unwrapped(seen), x, atol=1e-9)


@pytest.mark.parametrize("missing", [0.0, 0.2])
def test_a_range_that_is_no_power_of_two_is_found_by_the_size_of_the_jumps(missing):
    x = turning(3)
    seen = wrapped(x, 0.33)
    seen[np.random.default_rng(0).random(x.size) < missing] = np.nan
    there = np.isfinite(seen)
    assert not overflow(seen).is_binary
    np.testing.assert_allclose(unwrapped(seen)[there], x[there], atol=0.02 * 0.33)


def test_sound_signals_switches_and_spikes_do_not_go_round():
    rng = np.random.default_rng(1)
    t = 0.02 * np.arange(3000)
    switched = 0.05 * np.sign(np.sin(t)) + 1e-4 * rng.standard_normal(t.size)
    assert overflow(switched) is None
    for drive in sound_drives(40, seed=8):
        assert overflow(drive.columns["r"]) is None and overflow(drive.columns["delta"]) is None
        assert overflow(spiked("r")(drive, rng)["r"]) is None


def test_a_log_is_refused_with_the_repair_that_mends_it(tmp_path):
    x = turning(5)
    t = 0.02 * np.arange(x.size)
    columns = {"t": t, "delta": x / 8, "r": wrapped(x, STEP * 2**12), "U": np.full(x.size, 20.0)}
    path = write(Drive(columns, 2.7, 20.0, 0.0), tmp_path)

    (found,) = [one for one in survey(path).findings if one.certain]
    mended = survey(path, fixes=[found.fix])

    assert found.fault == "overflow" and "power of two" in found.what
    assert not mended.certain and "cells of r [rad/s] counted on" in mended.fixes[0]
    np.testing.assert_allclose(mended.values["r"], x, atol=1e-9)
