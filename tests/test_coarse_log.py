"""Fewer rows: means that keep what relates the columns."""

import numpy as np
import pytest

from similitude.coarse_log import coarse_log

from .simulated_drive import drive, log_of, spoilt


def test_a_log_with_too_few_rows_is_left_as_it_is():
    log = drive(seconds=5, rate=50)
    assert coarse_log(log, 50.0) is log
    assert coarse_log(log, 26.0) is log


@pytest.mark.parametrize(("rate", "rows"), [(100, 2), (1000, 20)])
def test_each_row_is_the_mean_of_its_time(rate, rows):
    log = drive(seconds=5, rate=rate)
    fewer = coarse_log(log, 50.0)
    assert fewer.samples == log.samples // rows
    for name in ("t", "delta", "r", "U"):
        assert getattr(fewer, name) == pytest.approx(
            getattr(log, name).reshape(-1, rows).mean(axis=1), abs=1e-12
        )


def test_a_pause_stays_a_pause_and_uneven_rows_are_averaged_where_they_fall():
    log = drive(seconds=5)
    t = log.t.copy()
    t[250:] += 3.0
    fewer = coarse_log(log_of(t, log.delta, log.r, log.U), 50.0)
    assert np.max(np.diff(fewer.t)) == pytest.approx(3.0, abs=0.03)
    assert fewer.samples == pytest.approx(250, abs=2)


def test_what_was_mostly_missing_is_missing_and_the_rest_is_the_mean_of_what_was_there():
    log = drive(seconds=5, rate=1000)
    fewer = coarse_log(spoilt(log, r=slice(0, 11), delta=slice(20, 29)), 50.0)
    assert np.isnan(fewer.r[0]) and np.isfinite(fewer.r[1:]).all()
    assert fewer.delta[1] == pytest.approx(log.delta[29:40].mean())
