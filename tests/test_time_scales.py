"""Tyre and road: remembered and forgotten."""

from types import SimpleNamespace

import numpy as np
import pytest

from similitude.time_scales import DAY, time_scales


def trace(K, std=0.05, information=None):
    K = np.asarray(K, float)
    gained = np.linspace(0, 100, K.size) if information is None else information
    return SimpleNamespace(K=K, ln_K_std=np.full(K.size, std), information=gained)


def test_a_wet_end_is_the_roads_and_not_the_tyres():
    K = np.where(np.arange(1000) < 900, 120.0, 60.0)
    found = time_scales(trace(K))

    assert found.K == pytest.approx(120 * 0.5**0.1, rel=0.01)  # a tenth of the information
    assert found.road == pytest.approx(60 / found.K)


def test_drives_are_averaged_and_never_surer_than_the_surest():
    kept = None
    for _ in range(50):
        found = time_scales(trace(np.full(100, 100.0), std=0.08), kept)
        kept = found.kept

    assert found.drives == 50 and found.K == pytest.approx(100)
    assert found.ln_K_std == pytest.approx(0.08)


def test_a_long_time_makes_the_past_count_for_less():
    kept = time_scales(trace(np.full(100, 100.0))).kept
    soon = time_scales(trace(np.full(100, 80.0)), kept, 60.0)
    late = time_scales(trace(np.full(100, 80.0)), kept, 365 * DAY)

    assert 80 < late.K < soon.K < 100
    assert soon.record["tyre"]["drives"] == 2


def test_where_nothing_was_learnt_the_last_value_stands():
    found = time_scales(trace([90.0, 95.0], information=np.zeros(2)))

    assert found.K == pytest.approx(95) and found.road == pytest.approx(1)
