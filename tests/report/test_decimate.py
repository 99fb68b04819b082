import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.report.decimate import BUCKETS, decimate, envelope, shares


@given(st.integers(2, 30_000), st.integers(0, 2**32 - 1), st.floats(0, 0.9))
@settings(max_examples=40, deadline=None)
def test_no_extreme_is_lost_and_no_more_than_4000_points_are_drawn(n, seed, missing):
    random = np.random.default_rng(seed)
    t = np.cumsum(random.choice([0.01, 0.02, 5.0], n, p=[0.8, 0.19, 0.01]))
    y = random.standard_normal(n)
    y[random.random(n) < missing] = np.nan
    shown_t, shown = decimate(t, y)
    assert shown_t.size == shown.size <= 4 * BUCKETS == 4000
    if np.isfinite(y).any():
        assert np.nanmin(shown) == np.nanmin(y)
        assert np.nanmax(shown) == np.nanmax(y)
    drawn = np.isfinite(shown)
    assert np.all(np.diff(shown_t[drawn]) > 0)
    value_at = dict(zip(t, y, strict=True))
    assert all(value_at[at] == value for at, value in zip(shown_t[drawn], shown[drawn], strict=True))


def test_a_line_is_broken_at_a_gap_and_nowhere_else():
    t = np.concatenate((np.arange(5000) * 0.01, 60 + np.arange(5000) * 0.01))
    shown_t, shown = decimate(t, np.sin(t))
    (broken,) = np.flatnonzero(np.isnan(shown))
    assert shown_t[broken - 1] < 50 < shown_t[broken + 1]
    edges_t, lower, _ = envelope(t, np.sin(t), np.sin(t) + 1)
    (broken,) = np.flatnonzero(np.isnan(lower))
    assert edges_t[broken - 1] < 60 <= edges_t[broken + 1]


def test_a_signal_that_comes_every_second_row_is_still_a_line():
    y = np.ones(1000)
    y[::2] = np.nan
    assert not np.isnan(decimate(np.arange(1000) * 0.01, y)[1]).any()


def test_nothing_measured_draws_nothing():
    t, y = decimate(np.arange(10.0), np.full(10, np.nan))
    assert t.size == y.size == 0


@pytest.mark.parametrize("n", [3, 999, 1000, 1001, 54_321])
def test_a_band_is_never_drawn_narrower_than_it_is(n):
    random = np.random.default_rng(n)
    t = np.arange(n) * 0.01
    lower, upper = -random.random(n), random.random(n)
    shown_t, shown_lower, shown_upper = envelope(t, lower, upper)
    assert shown_t.size <= 1000
    assert (shown_t[0], shown_t[-1]) == (t[0], t[-1])
    assert np.all(np.diff(shown_t) > 0)
    assert shown_lower.min() == lower.min()
    assert shown_upper.max() == upper.max()
    # A bucket stands at its first sample, the last one at its last: of the two points around a
    # sample one holds it.
    left = np.maximum(np.searchsorted(shown_t, t, side="right") - 1, 0)
    right = np.minimum(left + 1, shown_t.size - 1)
    assert np.all(np.minimum(shown_lower[left], shown_lower[right]) <= lower)
    assert np.all(np.maximum(shown_upper[left], shown_upper[right]) >= upper)


def test_shares_follow_time_not_row_numbers():
    t = np.concatenate((np.arange(100) * 0.01, 99 + np.arange(100) * 0.01))
    found = shares(t, t > 50, buckets=10)
    assert found[0] == 0
    assert found[-1] == 1
    assert np.all(found[1:-1] == 0)
