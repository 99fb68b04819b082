"""One pass over a log: what the step is fed, and what can be read off afterwards."""

import dataclasses
import os
import subprocess
import sys
import threading

import numpy as np
import pytest

from similitude import filter_run
from similitude.filter_config import DESIGN
from similitude.filter_run import BRIDGED, FEW, coordinates, population_setup, side_by_side
from similitude.status import STATUS
from similitude.unit import parse_unit

from .filter_rig import CAR as PRIOR
from .filter_rig import covariance
from .simulated_drive import CAR, NOISE, drive, log_of, spoilt


def setup_of(log, prior=PRIOR, *, L=CAR["L"], noise_std=NOISE):
    return population_setup(log, prior, L=L, noise_std=noise_std, input_scale_sd=0.02)


@pytest.fixture(scope="module")
def log():
    return drive(seconds=10)


def test_rows_are_the_log_with_its_own_time_steps(log):
    rows = setup_of(log).samples()
    assert rows.shape == (log.samples, 4)
    assert rows[0, 0] == np.median(np.diff(log.t))
    assert np.array_equal(rows[1:, 0], np.diff(log.t))
    for column, name in ((1, "delta"), (2, "U"), (3, "r")):
        assert np.array_equal(rows[:, column], getattr(log, name))


@pytest.mark.parametrize("late", [1, 5, 25])
def test_a_lag_of_whole_rows_shifts_the_steer(log, late):
    steer = setup_of(log).with_lag(late * 0.01, 0.2).samples()[:, 1]
    # t - lag misses a row by rounding of 1e-15 s, times the quickest steer of some 0.1 rad/s
    assert np.allclose(steer[late:], log.delta[:-late], rtol=0, atol=1e-15)
    assert np.all(steer[:late] == log.delta[0])


def test_a_lag_between_rows_lies_on_the_straight_line(log):
    steer = setup_of(log).with_lag(0.0125, 0.2).samples()[:, 1]
    expected = 0.25 * log.delta[:-2] + 0.75 * log.delta[1:-1]
    assert np.allclose(steer[2:], expected, rtol=0, atol=1e-12)


def test_a_log_of_too_few_rows_stays_as_it_is_at_a_lower_rate():
    setup = setup_of(drive(seconds=5, rate=50))
    assert setup.at_rate(50.0) is setup
    assert setup.at_rate(26.0) is setup
    half = setup.at_rate(25.0)
    assert half.log.samples == setup.log.samples // 2
    assert half.at_rate(25.0) is half


@pytest.mark.parametrize("lag", [-0.01, 0.001, 0.009, 0.01, 0.02, 0.031])
def test_what_acts_in_means_is_the_mean_of_what_acts(log, lag):
    """Half-way between two means a line is flatter than at its ends: no lag may gain by that."""
    late = log.delta.copy()
    late[:] = np.interp(log.t - lag, log.t, log.delta)
    shifted = setup_of(log_of(log.t, late, log.r, log.U)).at_rate(25.0)
    steer = setup_of(log).at_rate(25.0).with_lag(lag, 0.02).samples()[:, 1]
    assert steer == pytest.approx(shifted.samples()[:, 1], abs=1e-15)


def test_means_of_means_are_those_of_the_whole_log(log):
    fewer = setup_of(log).at_rate(50.0)
    once, twice = (setup.at_rate(12.5).with_lag(0.013, 0.02) for setup in (setup_of(log), fewer))
    assert np.array_equal(once.samples(), twice.samples())
    assert twice.noise_std == pytest.approx(once.noise_std)


def test_means_of_a_log_that_was_changed_are_of_the_changed_one(log):
    fewer = setup_of(log).at_rate(50.0)
    faster = dataclasses.replace(fewer, log=dataclasses.replace(fewer.log, U=2 * fewer.log.U))
    assert faster.at_rate(12.5).log.U == pytest.approx(2 * setup_of(log).at_rate(12.5).log.U)


def test_without_a_lag_a_missing_steer_is_missing(log):
    holed = spoilt(log, delta=[3, 4, 500])
    assert np.flatnonzero(np.isnan(setup_of(holed).samples()[:, 1])).tolist() == [3, 4, 500]


def test_with_a_lag_short_holes_are_bridged_and_long_ones_stay(log):
    short, long = np.arange(100, 105), np.arange(300, 350)
    holed = spoilt(log, delta=np.concatenate([short, long]))
    steer = setup_of(holed).with_lag(0.1, 0.2).samples()[:, 1]
    missing = np.flatnonzero(np.isnan(steer))
    # a lag of ten rows; the hole's two ends are known, and rounding may take either into it
    assert set(range(310, 360)) <= set(missing) <= set(range(309, 361))
    bridge = np.interp(np.arange(99, 106), [99, 105], log.delta[[99, 105]])
    assert steer[109:116] == pytest.approx(bridge, abs=1e-12)
    assert 0.06 < BRIDGED < 0.5


def test_a_log_of_few_rows_a_second_is_not_all_holes():
    log = drive(seconds=20, rate=5)
    assert np.isfinite(setup_of(log).with_lag(0.1, 0.2).samples()).all()


def test_a_pass_can_be_repeated_and_leaves_the_log_alone(log):
    setup = setup_of(log)
    before = setup.samples().copy()
    first, second = setup.run(), setup.run()
    assert np.array_equal(first.outputs, second.outputs)
    assert np.array_equal(first.state, second.state)
    assert np.array_equal(setup.samples(), before)


def test_the_end_of_a_pass_is_its_last_row(log):
    done = setup_of(log).run()
    assert done.value("K") == done.output("estimate")[-1]
    assert done.covariance(["K"])[0, 0] == done.output("own_variance")[-1]
    assert done.value("information") == done.output("information_gained")[-1]


def test_covariance_picks_by_name_in_the_order_asked(log):
    done = setup_of(log).run()
    full = covariance(done.setup.library, done.state)
    names = coordinates(done.setup.library)
    picked = done.covariance(["rho", "K", "output_bias"])
    at = [names.index(n) for n in ("rho", "K", "output_bias")]
    assert np.array_equal(picked, full[np.ix_(at, at)])
    assert np.array_equal(picked, picked.T)
    assert np.all(np.linalg.eigvalsh(done.covariance(names)) > 0)


def test_used_rows_and_their_loss(log):
    holed = spoilt(log, r=np.arange(200, 260), delta=[300])
    done = setup_of(holed).run()
    assert np.flatnonzero(~done.used).tolist() == [*range(200, 260), 300]
    assert np.all(done.status[~done.used] == STATUS["no_measurement"])
    innovation, variance = done.output("innovation"), done.output("innovation_variance")
    by_hand = sum(
        0.5 * (np.log(variance[i]) + innovation[i] ** 2 / variance[i]) for i in np.flatnonzero(done.used)
    )
    assert np.nansum(done.loss) == pytest.approx(by_hand, rel=1e-12)
    assert np.array_equal(np.isfinite(done.loss), done.used)
    assert np.all(innovation[200:260] == 0)


def test_the_likelihood_prefers_the_true_car():
    log = drive(seconds=60)
    costs = []
    for factor in (0.5, 1.0, 2.0):
        prior = PRIOR.known("K", CAR["K"] * factor, 0.01, "told")
        done = setup_of(log, prior).run(drift=0.0, jump_drift=0.0)
        costs.append(np.nansum(done.loss))
    assert costs[1] < min(costs[0], costs[2])


def test_similarity_a_scaled_world_gives_the_same_pi3():
    """Lengths times s, times times sqrt(s): K and its prior times s, rates 1/sqrt(s), g as it is."""
    s = 0.14  # a passenger car shrunk to a tenth
    log = drive(seconds=20)
    shrunk = log_of(log.t * s**0.5, log.delta, log.r / s**0.5, log.U * s**0.5)
    prior = dataclasses.replace(PRIOR, mean=PRIOR.mean * [s, 1, 1, 1])
    design = scaled_design(s)
    full = setup_of(log)
    small = setup_of(shrunk, prior, L=CAR["L"] * s, noise_std=NOISE / s**0.5)

    whole = full.run()
    config = small.config(**design)
    state = small.library.start(config)
    # one averaging rate starts at 1/s in any world: give it the clock of this one
    state[small.library.index("state", "settling")] /= s**0.5
    outputs, status = small.library.run(config, state, small.samples())

    assert np.array_equal(status, whole.status)
    # rounding is amplified no more than a forgetting filter does
    pi3 = outputs[:, small.library.index("output", "estimate")] / shrunk.U**2
    assert pi3 == pytest.approx(whole.output("estimate") / log.U**2, rel=1e-9)
    variance = outputs[:, small.library.index("output", "variance")]
    assert variance == pytest.approx(whole.output("variance"), rel=1e-9)


def scaled_design(s):
    """The design constants of a world scaled by s, from their declared units alone."""
    units = {name: unit for name, unit, *_ in setup_of(drive(seconds=3)).library.layout.CONFIG}
    scaled = {}
    for name, value in DESIGN.items():
        powers = parse_unit(units[name]).dimension.exponents
        scaled[name] = value * s ** (float(powers.get("length", 0)) + float(powers.get("time", 0)) / 2)
    return scaled


@pytest.mark.parametrize("workers", [1, 2])
@pytest.mark.parametrize("rows", [FEW - 1, FEW])
def test_passes_are_handed_back_in_their_order_by_threads_or_without(rows, workers, monkeypatch):
    monkeypatch.setattr(filter_run, "WORKERS", workers)
    here = threading.get_ident()
    found = side_by_side([lambda i=i: (i, threading.get_ident()) for i in range(5)], rows=rows)
    assert [i for i, _ in found] == [0, 1, 2, 3, 4]
    assert all((where == here) == (rows < FEW or workers == 1) for _, where in found)


def test_passes_side_by_side_do_not_disturb_each_other(monkeypatch):
    monkeypatch.setattr(filter_run, "WORKERS", 2)
    setups = [setup_of(drive(seconds=60)).with_lag(0.004 * i, 0.02) for i in range(6)]
    at_once = side_by_side([one.run for one in setups])
    for one, done in zip(setups, at_once, strict=True):
        assert np.array_equal(one.run().outputs, done.outputs)


@pytest.mark.parametrize(("said", "workers"), [("1", 1), ("2", 2), ("", 2), (None, 2)])
def test_a_process_that_is_told_it_has_one_processor_takes_no_threads(said, workers):
    environment = {k: v for k, v in os.environ.items() if k != "OMP_NUM_THREADS"}
    environment |= {} if said is None else {"OMP_NUM_THREADS": said}
    line = "from similitude.filter_run import WORKERS; print(WORKERS)"
    done = subprocess.run([sys.executable, "-c", line], env=environment, capture_output=True, text=True)
    assert done.stdout.split() == [str(workers)]
