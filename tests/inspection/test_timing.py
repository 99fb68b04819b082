"""The clock: planted gaps, jumps and repeats come back with row and length."""

import numpy as np
import pytest

from similitude.inspection.timing import timing


def test_planted_gaps_come_back_longest_first():
    t = np.arange(1000) * 0.01
    t[300:] += 0.5
    t[700:] += 2.0

    found = timing(t)

    assert [gap.row for gap in found.gaps] == [701, 301]
    assert [gap.length for gap in found.gaps] == pytest.approx([2.01, 0.51])
    assert found.lost == pytest.approx(2.5 / found.duration)
    assert found.is_usable and found.rate == pytest.approx(100.0)


def test_a_clock_that_was_set_or_turned_back_jumps():
    t = np.arange(400) * 0.02
    t[100:] += 3600.0
    t[200:] -= 3700.0

    found = timing(t)

    assert [(jump.row, round(jump.length)) for jump in found.jumps] == [(201, -3700), (101, 3600)]
    assert not found.gaps and not found.is_usable


def test_repeated_and_missing_times_are_counted():
    t = np.arange(100) * 0.01
    t[10] = t[9]
    t[50] = np.nan

    found = timing(t)

    assert (found.repeated, found.missing, found.rows) == (1, 1, 100)
    assert not found.is_usable


@pytest.mark.parametrize("seed", range(5))
def test_jitter_shows_in_the_percentiles(seed):
    t = np.cumsum(0.01 + 0.001 * np.random.default_rng(seed).uniform(-1, 1, 20_000))

    found = timing(t)

    assert found.step == pytest.approx(0.01, rel=0.01)
    assert found.step_low == pytest.approx(0.00902, rel=0.005)
    assert found.step_high == pytest.approx(0.01098, rel=0.005)
    assert not found.gaps


@pytest.mark.parametrize("t", [[], [1.0], [np.nan, np.nan, 3.0]])
def test_too_few_times_are_no_clock(t):
    assert timing(np.array(t)) is None


def test_a_clock_that_stands_has_no_rate():
    found = timing(np.zeros(50))

    assert found.rate == 0 and not found.is_usable
