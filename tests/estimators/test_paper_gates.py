"""Bad samples: each gets its status, none stops the regression, nothing is ever not finite."""

import numpy as np
import pytest

from similitude.estimators.paper_design import paper_config
from similitude.status import STATUS

from .paper_case import OWN, TS, K, L, U, library, outputs, samples, servo_square, yaw_rate

N = 12_000
DELTA = servo_square(N)
R = yaw_rate(DELTA)
CONFIG = dict(sample_time=TS, L=L, speed=U, noise_std=1e-6, **OWN)
SETTLE = 112  # ceil(5/45/0.001)


def run(rows):
    config = paper_config(library(), **CONFIG)
    state = library().start(config)
    values, status = library().run(config, state, rows)
    assert np.isfinite(values).all()
    assert np.isfinite(state).all()
    assert (outputs(values, "estimate") > 0).all()
    assert (outputs(values, "variance") > 0).all()
    return values, status, state


def learns_again(values):
    return abs(outputs(values, "estimate")[-1] / K - 1) < 0.05  # noise-free figure: -2.6 %


@pytest.mark.parametrize("column", [1, 2, 3])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e300, -1e5])
def test_an_impossible_value_is_held_and_its_surroundings_are_not_used(column, value):
    rows = samples(DELTA, R)
    rows[6_000:6_010, column] = value
    values, status, _ = run(rows)

    expected = STATUS["no_measurement"]
    assert (status[6_000:6_010] == expected).all()
    assert not np.isin(status[6_010 : 6_010 + SETTLE], [STATUS["ok"]]).any()
    held = outputs(values, "estimate")[5_999 : 6_010 + SETTLE]
    assert (held == held[0]).all()
    assert (outputs(values, "innovation")[6_000:6_010] == 0).all()
    assert learns_again(values)


@pytest.mark.parametrize("dt", [0.0, -1.0, np.nan, np.inf, -np.inf])
def test_a_sample_whose_time_does_not_advance_changes_nothing(dt):
    rows = np.insert(samples(DELTA, R), 6_000, [dt, 1.0, 30.0, 5.0], axis=0)
    with_it, status, state = run(rows)
    without, _, reference = run(samples(DELTA, R))

    assert status[6_000] == STATUS["bad_sample"]
    assert (state == reference).all()
    assert (np.delete(with_it, 6_000, axis=0) == without).all()


@pytest.mark.parametrize("gap", [1, 50, 3_000])
def test_missing_rows_restart_the_count(gap):
    rows = np.delete(samples(DELTA, R), np.arange(6_000, 6_000 + gap), axis=0)
    rows[6_000, 0] = (gap + 1) * TS
    values, status, _ = run(rows)

    assert status[6_000] == STATUS["restarted"]
    assert (status[6_001 : 6_000 + SETTLE] == STATUS["not_excited"]).all()
    assert learns_again(values)


def test_too_slow_holds_the_constant():
    speed = np.full(N, U)
    speed[5_000:7_000] = np.linspace(0.4, -2.0, 2_000)
    values, status, _ = run(samples(DELTA, R, speed))

    assert (status[5_000:7_000] == STATUS["too_slow"]).all()
    estimate = outputs(values, "estimate")
    assert (estimate[5_000:7_000] == estimate[4_999]).all()


def test_a_log_of_nothing_learns_nothing():
    values, status, _ = run(samples(np.full(N, np.nan), np.nan, np.nan))

    assert (status == STATUS["no_measurement"]).all()
    assert (outputs(values, "variance") == 1.0).all()


def test_zeros_learn_nothing():
    values, status, _ = run(samples(np.zeros(N), np.zeros(N)))

    assert (status == STATUS["not_excited"]).all()
    assert (outputs(values, "variance") == 1.0).all()


def test_a_spike_is_missing_and_a_step_that_stays_is_believed():
    rows = samples(DELTA, R)
    rows[6_000, 3] += 0.3
    rows[8_000:, 3] += 0.3  # the high-pass takes an offset away
    values, status, _ = run(rows)

    assert status[[6_000, 8_000]].tolist() == [STATUS["no_measurement"]] * 2
    assert (status[8_001:] != STATUS["no_measurement"]).all()
    assert learns_again(values)


def test_scattered_faults_are_forgotten_like_any_sample():
    """A steer angle that drops to zero is believable: it weighs until it is forgotten."""
    rng = np.random.default_rng(3)
    delta = servo_square(300_000)
    rows = samples(delta, yaw_rate(delta))
    at = rng.choice(N, 24, replace=False)
    faults = np.array([np.nan, np.inf, -np.inf, 0.0, 1e9, -1e9])
    rows[at, rng.integers(0, 4, at.size)] = rng.choice(faults, at.size)
    values, status, _ = run(rows)

    assert {STATUS["ok"], STATUS["no_measurement"], STATUS["bad_sample"]} <= set(status.tolist())
    assert learns_again(values)


def test_random_bits_never_break_it():
    rng = np.random.default_rng(4)
    rows = rng.integers(0, 2**64, (20_000, 4), dtype=np.uint64).view(np.float64)
    rows[::2, 0] = TS
    rows[::3, 1:] = rng.normal(0, 1, rows[::3, 1:].shape) * [1.0, 100.0, 10.0]

    run(rows)


def test_a_turn_without_end_does_not_wind_up():
    turning = samples(np.full(500_000, 0.1), np.full(500_000, 0.5))
    config = paper_config(library(), **CONFIG)
    state = library().start(config)
    for _ in range(2):
        library().run(config, state, turning)
    values, _ = library().run(config, state, samples(DELTA, R))

    assert np.isfinite(state).all()
    assert learns_again(values)
