"""Fewer rows: means that keep what relates the columns."""

import numpy as np
import pytest

from similitude.coarse_log import CoarseLog, lines_of_means

from .simulated_drive import drive, log_of, spoilt


@pytest.mark.parametrize(("rate", "rows"), [(100, 2), (1000, 20)])
def test_each_row_is_the_mean_of_its_time(rate, rows):
    log = drive(seconds=5, rate=rate)
    fewer = CoarseLog(log, 50.0).log
    assert fewer.samples == log.samples // rows
    means = {name: getattr(log, name).reshape(-1, rows).mean(axis=1) for name in ("t", "delta", "r", "U")}
    for name in ("t", "r", "U"):
        assert getattr(fewer, name) == pytest.approx(means[name], abs=1e-12)
    assert fewer.delta == pytest.approx(lines_of_means(means["delta"]), abs=1e-12)


def test_a_pause_stays_a_pause_and_uneven_rows_are_averaged_where_they_fall():
    log = drive(seconds=5)
    t = log.t.copy()
    t[250:] += 3.0
    fewer = CoarseLog(log_of(t, log.delta, log.r, log.U), 50.0).log
    assert np.max(np.diff(fewer.t)) == pytest.approx(3.0, abs=0.03)
    assert fewer.samples == pytest.approx(250, abs=2)


def test_what_was_mostly_missing_is_missing_and_the_rest_is_the_mean_of_what_was_there():
    log = drive(seconds=5, rate=1000)
    fewer = CoarseLog(spoilt(log, r=slice(0, 11), delta=slice(20, 29)), 50.0).log
    assert np.isnan(fewer.r[0]) and np.isfinite(fewer.r[1:]).all()
    means = log.delta.reshape(-1, 20).mean(axis=1)
    means[1] = log.delta[29:40].mean()
    assert fewer.delta == pytest.approx(lines_of_means(means), abs=1e-12)


@pytest.mark.parametrize("step", [0.2, 0.4, 0.8])  # w h; 0.8 is 2.5 Hz in 20 rows a second
def test_lines_from_row_to_row_are_as_high_as_the_wave_they_follow(step):
    """sinc^2 of the lines: (w h)^2/12 too low without; with, 1 + (1 - cos w h)/6 leaves (w h)^4/90."""
    rows = np.arange(4000)
    means = np.sinc(step / 2 / np.pi) * np.sin(step * rows)
    fine = np.arange(0, rows[-1], 0.01)
    wave = np.sin(step * fine)

    def height(nodes):
        seen = wave * np.hanning(fine.size)  # the ends do not count
        return (np.interp(fine, rows, nodes) @ seen) / (wave @ seen)

    lost, left = (1 - height(nodes) / np.sinc(step / 2 / np.pi) for nodes in (means, lines_of_means(means)))
    assert lost == pytest.approx(step**2 / 12, rel=0.1)
    assert left == pytest.approx(step**4 / 90, rel=0.1)


def test_a_hole_in_the_means_stays_one_cell_wide():
    means = np.sin(0.3 * np.arange(20))
    means[8] = np.nan
    assert np.flatnonzero(np.isnan(lines_of_means(means))).tolist() == [8]


def test_nothing_is_raised_across_a_pause():
    t = np.concatenate([np.arange(100), 400 + np.arange(100)]) / 100
    steer = np.where(t < 2, 0.0, 0.1)
    fewer = CoarseLog(log_of(t, steer, 10 * steer, np.full(t.size, 20.0)), 50.0).log
    assert set(fewer.delta) == {0.0, 0.1}
