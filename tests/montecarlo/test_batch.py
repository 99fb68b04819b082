"""Honesty of the batch fit: its 95 % interval over drawn cars, on the reference plant and on a dirty one.

The reference experiment without the step, its lag known to be none; and the nuisance plant: steer scale
wrong by 3 % either way, a lag of 30 ms, offsets, and a slow disturbance of 0.7 mrad.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from similitude.batch_fit import fit_batch
from similitude.batch_pass import FrozenFilter, batch_prior
from similitude.filter_run import LINEAR, population_setup
from similitude.handling import handling
from similitude.program.library import shipped
from similitude.simulate import bicycle_response
from similitude.steer_lag import MEASURED_LAG
from similitude.units import Uncertain

from . import experiment
from .experiment import NOISE, drawn_prior, fleet, log_of_car

pytestmark = pytest.mark.slow

CARS = 120
NO_LAG = Uncertain(0.0, None, "s")


def fits(cars, lag):
    prior = drawn_prior()
    joint = batch_prior(prior, steer_scale_sd=0.02, lag=lag)
    for i in range(len(cars.L)):
        setup = population_setup(
            log_of_car(cars, i), prior, L=cars.L[i], noise_std=NOISE, input_scale_sd=0.02
        )
        frozen = FrozenFilter(replace(setup, library=shipped(LINEAR)), joint)
        yield fit_batch(frozen, frozen.middle, np.log([1.0, 0.02]))


@cache
def reference(steer_rms):
    """Cars of the reference experiment and their fits, for all tests that ask something of them.

    120 cars alone cover 95 +- 2 %, which the lower bound does not outlast; twice as many do.
    """
    return [
        (cars, list(fits(cars, NO_LAG)))
        for cars in (fleet(seed, cars=CARS, steer_rms=steer_rms, halve=False) for seed in (31, 41))
    ]


def coverage(fitted):
    """Share of cars whose interval holds the truth; median error of ln K."""
    error = [fit.x[0] - np.log(cars.K[i, 0]) for cars, found in fitted for i, fit in enumerate(found)]
    std = [fit.std[0] for _, found in fitted for fit in found]
    return np.mean(np.abs(error) < 1.96 * np.array(std)), np.median(np.abs(error))


@pytest.mark.parametrize("steer_rms", [3e-3, 10e-3])
def test_the_interval_covers_on_the_reference_experiment(steer_rms):
    covered, error = coverage(reference(steer_rms))
    assert 0.93 <= covered <= 0.995
    assert error < 0.035


@pytest.mark.parametrize("steer_rms", [3e-3, 10e-3])
def test_the_interval_covers_on_the_nuisance_plant(steer_rms):
    cars = nuisance_fleet(32, cars=CARS, steer_rms=steer_rms)
    covered, error = coverage([(cars, list(fits(cars, MEASURED_LAG)))])
    assert 0.93 <= covered <= 0.995
    assert error < 0.06


def test_a_straight_road_teaches_nothing():
    """What little a minute of road noise says must not be said with confidence."""
    cars = fleet(33, cars=40, duration=240.0, steer_rms=1e-4, halve=False)
    for i, fit in enumerate(fits(cars, NO_LAG)):
        assert abs(fit.x[0] - np.log(cars.K[i, 0])) < 3.5 * fit.std[0]


def test_a_constant_car_has_equal_halves():
    assert np.mean([fit.halves.apart > 3 for _, found in reference(10e-3) for fit in found]) <= 0.02
    halved = fleet(34, cars=40, steer_rms=10e-3, halve=True)
    assert np.mean([fit.halves.apart > 3 for fit in fits(halved, NO_LAG)]) >= 0.95


def test_handling_intervals_cover_over_the_population():
    """Every car's own numbers against the interval its log gives."""
    hits, counted = {}, {}
    for cars, i, fit in ((cars, i, fit) for cars, found in reference(10e-3) for i, fit in enumerate(found)):
        place = {"L": float(cars.L[i]), "U": float(cars.U[i])}
        values = {name: fit.values[name] for name in ("K", "pi1", "eta", "rho")}
        claimed = handling(values, fit.covariance[:4, :4], **place)
        true = handling(cars.unknowns(i), np.zeros((4, 4)), **place)
        for name in claimed.keys() & true.keys():
            held = claimed[name]["lo"] <= true[name]["value"] <= claimed[name]["hi"]
            hits[name] = hits.get(name, 0) + held
            counted[name] = counted.get(name, 0) + 1
    shares = {name: hits[name] / counted[name] for name in hits if counted[name] > 50}
    assert len(shares) >= 6
    # 240 cars know a share of 95 % to 1.4 %; the interval of a ridge is a little too short or too long
    assert all(0.89 <= share <= 1.0 for share in shares.values()), shares


def nuisance_fleet(seed, *, cars, steer_rms, duration=120.0):
    """Cars of the reference experiment with everything wrong that a careful installation leaves."""
    rng = np.random.default_rng(seed)
    plain = fleet(seed, cars=cars, duration=duration, steer_rms=steer_rms, halve=False, rounded=False)
    n = len(plain.t)
    slow = butter(1, 0.15, fs=experiment.RATE, output="sos")  # Hz
    gusts = sosfilt(slow, rng.standard_normal((cars, n + 5000)))[:, 5000:]
    gusts *= 0.7e-3 / gusts.std(axis=1, keepdims=True)
    late = round(0.030 * experiment.RATE)
    acting = np.concatenate([np.zeros((cars, late)), plain.steer[:, :-late]], axis=1)
    acting *= 1 + 0.03 * rng.choice([-1, 1], (cars, 1))
    acting += gusts + 0.010 * rng.standard_normal((cars, 1))
    shaped = {name: value[:, None] for name, value in plain.groups.items()}
    r, _ = bicycle_response(plain.t, acting, plain.U[:, None], L=plain.L[:, None], K=plain.K, **shaped)
    r += NOISE * rng.standard_normal(r.shape) + 0.003 * rng.standard_normal((cars, 1))
    step = experiment.STEER_STEP
    return experiment.Fleet(
        plain.t, np.round(plain.steer / step) * step, r, plain.K, plain.L, plain.U, plain.groups
    )
