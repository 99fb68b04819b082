"""Time and measurement update: what is held keeps its variance, what is forgotten goes to the prior."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.estimators import filter_covariance as cov
from similitude.estimators.filter_fields import Layout
from similitude.program.ir import Assign
from similitude.systems.bicycle import bicycle_reduction

from ..filter_rig import CAR, NOISE, car, car_config, covariance, scaled_eigenvalues
from ..parity.test_float32 import long_drive
from ..run_statements import run_statements

REDUCTION = bicycle_reduction()
LAYOUT = Layout(REDUCTION)
AT = {name: i for i, name in enumerate(LAYOUT.coordinates)}


@settings(max_examples=50, deadline=None)
@given(st.floats(-5, 5), st.floats(1e-3, 1e3))
def test_an_unknown_moves_by_at_most_one_in_its_logarithm(by, value):
    moved = run_statements(cov.move_unknown(REDUCTION.unknowns[0], "d"), {"d": by, "K": value})

    bounded = min(max(by, -1.0), 1.0)
    assert moved["K"] > 0
    assert math.log(moved["K"] / value) == pytest.approx(bounded, abs=0.12 * bounded**4 + 1e-12)


@settings(max_examples=50, deadline=None)
@given(st.floats(0.25, 4))
def test_the_logarithm_of_the_pull_is_good_to_a_third_of_a_percent(ratio):
    lines = [s for s in cov.pull(LAYOUT) if isinstance(s, Assign) and s.target in "p q pp qq away"]

    after = run_statements(lines, {"K": 145.0 * ratio, "K_prior": 145.0})

    assert after["away"] == pytest.approx(math.log(ratio), rel=3.3e-3, abs=1e-12)


def run(rows, **changes):
    library = car()
    config = car_config(library, **changes)
    state = library.start(config)
    outputs, status = library.run(config, state, rows)
    return library, state, outputs, status


def straight(samples, *, step=0.01, speed=25.0, seed=3):
    """Nothing but noise of the gyro."""
    yaw = NOISE * np.random.default_rng(seed).standard_normal(samples)
    column = np.ones(samples)
    return np.column_stack([step * column, 0 * column, speed * column, yaw])


def test_what_never_learns_keeps_its_mean_and_variance():
    rows = long_drive(5000, seed=4)
    library, state, _, _ = run(rows, seldom=1e9)
    P = covariance(library, state)

    i, at = CAR.names.index("pi1"), AT["pi1"]
    assert state[library.index("state", "pi1")] == CAR.mean[i]
    assert P[at, at] == pytest.approx(CAR.covariance[i, i], rel=1e-9)


@pytest.mark.parametrize(("seldom", "every"), [(0.0, 1), (0.015, 2), (0.025, 3), (0.035, 4), (0.095, 10)])
def test_what_is_learnt_seldom_moves_only_when_its_time_has_come(seldom, every):
    library = car()
    config = car_config(library, seldom=seldom)
    state = library.start(config)
    at = library.index("state", "pi1")
    rows = long_drive(3000, seed=4)
    values = []
    for row in rows:
        library.run(config, state, row[None])
        values.append(state[at])
    moved = np.flatnonzero(np.diff(values))

    assert len(moved) > 1500 / every
    assert np.diff(moved).min() == every
    assert np.median(np.diff(moved)) == every  # longer only around a jump


@pytest.mark.parametrize("speed", [15.0, 25.0, 35.0])
@pytest.mark.parametrize("seed", range(3))
def test_on_a_straight_road_nothing_is_learnt_of_the_unknowns(speed, seed):
    """Neither from the noise nor from the offset that is estimated from it, not even at first."""
    library, state, outputs, status = run(straight(6000, speed=speed, seed=seed))
    P = covariance(library, state)

    assert (status == library.layout.STATUS["not_excited"]).all()
    assert outputs[:, 0] == pytest.approx(CAR.mean[0], rel=1e-9)
    for i, name in enumerate(CAR.names):
        assert P[AT[name], AT[name]] == pytest.approx(CAR.covariance[i, i], rel=1e-3)
    assert P[AT["output_bias"], AT["output_bias"]] < 0.005**2  # but a little of the bias is


@pytest.mark.parametrize("step", [0.01, 1.0, 30.0, 1e5])
def test_unheard_the_first_unknown_returns_to_the_population(step):
    """After learning, a quarter of an hour (or a day) of silence leads back to prior mean and variance.

    The idle drift is 2e-3/s against a prior variance of 0.25: a correlation time of 250 s.
    """
    library = car()
    config = car_config(library)
    state = library.start(config)
    library.run(config, state, long_drive(5000, seed=4))
    at = library.index("state", "P") + LAYOUT.covariance.index(AT["K"], AT["K"])
    assert state[at] < 0.1 * CAR.covariance[0, 0]

    quiet = straight(max(60, round(1500 / step)), step=step)
    quiet[:, 3] = np.nan
    outputs, _ = library.run(config, state, quiet)

    assert (outputs[:, 1] <= CAR.covariance[0, 0] * 1.001).all()  # never less sure than the prior
    assert outputs[-1, 1] == pytest.approx(CAR.covariance[0, 0], rel=0.02)
    assert abs(math.log(outputs[-1, 0] / CAR.mean[0])) < 0.02


@pytest.mark.parametrize("factor", [0.2, 5.0])
def test_the_size_of_the_noise_is_found_out(factor):
    """The stated variance is wrong by factor^2; after 100 s the filter's own is right to 15 %."""
    rows = straight(20_000)
    rows[:, 3] *= factor
    library, state, outputs, _ = run(rows)

    scale = state[library.index("state", "noise_scale")]
    # averages over 20 s: 2000 samples, sd sqrt(2/2000) = 3 % of the variance, and the bias is small
    assert scale == pytest.approx(factor**2, rel=0.15)
    assert (outputs[-5000:, 3] ** 2 / outputs[-5000:, 4]).mean() == pytest.approx(1, abs=0.1)


def test_information_only_grows_and_the_covariance_stays_one():
    library, state, outputs, _ = run(long_drive(30_000, seed=5))

    assert (np.diff(outputs[:, 5]) >= 0).all() and outputs[-1, 5] > 50
    assert (outputs[:, 1] > 0).all() and (outputs[:, 4] > 0).all()
    assert scaled_eigenvalues(covariance(library, state)).min() > 0


def test_a_spike_counts_for_no_more_than_three_sd():
    """The innovation's weight falls as 1/nis: a spike of 100 sd moves K less than one of 3 sd would."""
    rows = long_drive(6000, seed=6)
    spiked = rows.copy()
    spiked[5000, 3] += 100 * NOISE
    library, _, clean, _ = run(rows)
    _, _, hit, _ = run(spiked)

    moved = np.log(hit[5000, 0] / clean[5000, 0])
    assert abs(moved) < 0.3 * np.sqrt(clean[5000, 1])
    assert abs(np.log(hit[-1, 0] / clean[-1, 0])) < np.sqrt(clean[-1, 1])
    assert library.layout.STATUS["ok"] == 0
