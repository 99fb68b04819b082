"""A hole round one number in a yaw rate is found whatever its width, and sound or coarse ones have none."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.log_survey import survey
from similitude.signal_faults.dead_band import dead_band, dead_rows

from ..damaged_drives import coarse, sound_drives, write


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 10_000),
    share=st.floats(0.1, 0.8),
    bias=st.floats(-2, 2),
    steps=st.sampled_from([0, 8]),
)
def test_a_hole_is_found_with_its_middle_and_width(seed, share, bias, steps):
    """``steps`` readings in the width of the hole, or unrounded."""
    x = np.random.default_rng(seed).standard_normal(4000)
    x = np.where(np.abs(x) < share, 0.0, x)
    x = np.round(x / share * steps) * share / steps if steps else x
    found = dead_band(x + bias)

    assert found is not None
    assert found.value == pytest.approx(bias, abs=1e-12)
    # the hundredth part of the values that is nearest may lie beyond the hole
    assert share - (share / steps if steps else 0) - 1e-6 <= found.width <= share + 0.1
    assert np.array_equal(dead_rows(x + bias), x == 0)


@pytest.mark.parametrize("share", [0.1, 0.3, 0.6])
def test_a_band_that_was_subtracted_has_no_hole_but_a_favourite_number(share):
    for drive in sound_drives(12, seed=4):
        rate = drive.columns["r"] - np.median(drive.columns["r"])
        found = dead_band(np.sign(rate) * np.maximum(np.abs(rate) - share * rate.std(), 0.0))

        assert found is not None
        assert (found.value, found.width) == (0.0, 0.0)


def test_a_log_with_a_subtracted_band_is_said_and_no_repair_is_offered(tmp_path):
    drive = sound_drives(3, seed=2)[0]
    rate = drive.columns["r"]
    drive.columns["r"] = np.sign(rate) * np.maximum(np.abs(rate) - 0.3 * rate.std(), 0.0)
    path = write(drive, tmp_path)

    (found,) = survey(path).findings

    assert (found.fault, found.fix) == ("dead_band_subtracted", None)
    assert "short by it" in found.usually
    assert not np.isnan(survey(path, fixes=["drop_dead_band"]).values["r"]).any()


def test_a_sensor_that_is_stuck_once_has_no_favourite():
    rng = np.random.default_rng(3)
    x = rng.standard_normal(4000)
    x[1000:1400] = x[1000]

    assert dead_band(x) is None


def test_neither_sound_signals_nor_coarse_ones_have_a_hole():
    rng = np.random.default_rng(0)
    for drive in sound_drives(60, seed=21):
        assert dead_band(drive.columns["r"]) is None
        assert dead_band(coarse(drive, rng).columns["r"]) is None


@pytest.mark.parametrize("size", [0, 10, 500])
def test_few_values_and_one_value_say_nothing(size):
    assert dead_band(np.zeros(size)) is None
    assert dead_band(np.full(size, np.nan)) is None


def test_a_log_with_a_dead_band_is_said_and_the_repair_leaves_those_cells_empty(tmp_path):
    drive = sound_drives(3, seed=2)[0]
    rate = drive.columns["r"]
    dead = np.abs(rate) < 0.5 * rate.std()
    drive.columns["r"] = np.where(dead, 0.0, rate)
    path = write(drive, tmp_path)

    (found,) = survey(path).findings
    mended = survey(path, fixes=[found.fix])

    assert (found.fault, found.value) == ("dead_band", np.count_nonzero(dead))
    assert np.array_equal(np.isnan(mended.values["r"]), dead)
