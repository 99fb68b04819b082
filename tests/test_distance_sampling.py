"""Rows at equal distances: the means are right, and the same car is found from them."""

from dataclasses import replace

import numpy as np
import pytest

from similitude import identify
from similitude.distance_sampling import at_rows_of, by_distance
from similitude.errors import LogError, UsageError

from .simulated_drive import CAR, drive, log_of, vehicle


def changing(t):
    """Speed between 8 and 26 m/s, there and back in twenty seconds."""
    return 17 + 9 * np.sin(2 * np.pi * t / 20)


def ramp(n=2000, speed=10.0):
    """A log whose every signal rises in proportion to the distance."""
    t = np.arange(n) / 100
    s = speed * t
    return log_of(t, 1e-4 * s, 2e-4 * s, np.full(n, speed))


def test_rows_lie_at_equal_distances_whatever_the_speed():
    log = drive(seconds=60, U=changing)
    rows = by_distance(log, 0.4, wheelbase=CAR["L"])
    travelled = np.interp(rows.t, log.t, np.concatenate([[0], np.cumsum(np.diff(log.t) * log.U[:-1])]))
    # the integral above is a left sum: off by at most one sample's change of speed
    assert np.allclose(np.diff(travelled), 0.4, atol=2 * np.abs(np.diff(log.U)).max() * 0.01)
    assert rows.samples == pytest.approx(60 * 17 / 0.4, rel=0.02)


@pytest.mark.parametrize("spacing", [0.11, 0.25, 0.5])
def test_a_straight_line_keeps_its_values(spacing):
    rows = by_distance(ramp(), spacing, wheelbase=2.7)
    s = 10.0 * rows.t
    inner = slice(1, -1)  # the outer stretches are cut short by the ends of the log
    assert np.allclose(rows.delta[inner], 1e-4 * s[inner], rtol=1e-9, atol=1e-12)
    assert np.allclose(rows.r[inner], 2e-4 * s[inner], rtol=1e-9, atol=1e-12)
    assert np.allclose(np.diff(rows.t), spacing / 10.0)


def test_a_mean_over_a_stretch_loses_no_signal():
    log = drive(seconds=30, U=changing, noise=0.0)
    rows = by_distance(log, 0.3, wheelbase=CAR["L"])
    way = np.diff(np.concatenate([[0], np.cumsum(0.5 * (log.U[1:] + log.U[:-1]) * np.diff(log.t))]))
    whole = np.sum(0.5 * (log.r[1:] + log.r[:-1]) * way)
    # all stretches are of one length but the first and the last, which are half of one or less
    assert np.sum(rows.r) * 0.3 == pytest.approx(whole, abs=0.3 * np.abs(log.r).max() * 1.01)


def test_standing_and_reversing_take_no_rows():
    log = ramp()
    speed = log.U.copy()
    speed[500:900] = 0.0
    speed[900:1000] = -3.0
    rows = by_distance(replace(log, U=speed), 0.25, wheelbase=2.7)
    assert not ((rows.t > 5.01) & (rows.t < 9.98)).any()
    assert np.all(np.diff(rows.t) > 0)


def test_a_hole_stays_a_hole():
    log = ramp()
    r = log.r.copy()
    r[300:400] = np.nan
    rows = by_distance(replace(log, r=r), 0.5, wheelbase=2.7)
    inside = (rows.t > 3.06) & (rows.t < 3.93)
    outside = (rows.t < 2.94) | (rows.t > 4.05)
    assert np.isnan(rows.r[inside]).all() and np.isfinite(rows.r[outside]).all()
    assert np.isfinite(rows.delta).all()


@pytest.mark.parametrize("seed", range(4))
def test_the_same_car_is_found_as_by_time_from_a_third_of_the_rows(seed):
    log = drive(seconds=90, U=changing, seed=seed)
    by_time, by_way = (identify(log, vehicle(), spacing=ds) for ds in (None, 0.5))
    apart = np.log(by_way.K.value / by_time.K.value)
    # one drive, one noise: what differs is the discretisation, well inside either sd
    assert abs(apart) < by_time.K.std / by_time.K.value
    assert abs(np.log(by_way.K.value / CAR["K"])) < 3 * by_way.K.std / by_way.K.value
    assert by_way.verdict == by_time.verdict


def test_the_run_has_the_rows_of_the_log():
    log = drive(seconds=30, U=changing)
    run = identify(log, vehicle(), spacing=0.5)
    assert np.array_equal(run.trace.t, log.t)
    assert len(run.trace.K) == log.samples and np.isfinite(run.trace.K).all()
    told = np.isfinite(run.trace.innovation)
    assert told.sum() < 0.5 * log.samples  # an innovation is told once, where its row ended
    assert run.assumed["spacing"].value == 0.5


def test_a_row_never_knows_what_comes_after_it():
    log = drive(seconds=20, U=changing)
    rows = by_distance(log, 0.5, wheelbase=CAR["L"])
    run = identify(rows, vehicle())
    told = at_rows_of(run, log).trace
    for at in (500, 1234, 1999):
        last = np.flatnonzero(rows.t <= log.t[at])[-1]
        assert told.K[at] == run.trace.K[last]


@pytest.mark.parametrize("spacing", [0.0, -0.5, 0.9, np.nan])
def test_a_spacing_that_does_not_suit_the_wheelbase_is_refused(spacing):
    with pytest.raises(UsageError, match="does not suit a wheelbase"):
        by_distance(ramp(), spacing, wheelbase=2.7)


def test_a_spacing_finer_than_the_log_is_refused():
    with pytest.raises(UsageError, match="finer than the log"):
        by_distance(ramp(), 0.04, wheelbase=2.7)


def test_a_car_that_hardly_moves_has_too_few_rows():
    log = ramp()
    with pytest.raises(LogError, match="are the least"):
        by_distance(replace(log, U=np.full(log.samples, 0.3)), 0.5, wheelbase=2.7)


@pytest.mark.parametrize("estimator", ["paper", "band", "robust"])
def test_filters_designed_in_hertz_take_rows_by_time_only(estimator):
    with pytest.raises(UsageError, match="equal times only"):
        identify(drive(seconds=10), vehicle(), estimator=estimator, spacing=0.5)


def test_output_error_takes_rows_by_distance():
    run = identify(drive(seconds=40, rms=0.01), vehicle(), estimator="output_error", spacing=0.5)
    assert run.K.lo < CAR["K"] < run.K.hi
