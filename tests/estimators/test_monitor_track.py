"""Signatures: what the held filter would miss, had the steer alone driven another car."""

import numpy as np

from similitude.filter_run import population_setup
from similitude.monitor_config import DESIGN
from similitude.simulate import bicycle_response

from ..filter_rig import CAR, NOISE
from ..simulated_drive import CAR as TRUTH
from ..simulated_drive import drive, log_of, wandering_steer


def evidence(log, **changes):
    from similitude.change_alarm import watch

    done = population_setup(log, CAR, L=TRUTH["L"], noise_std=NOISE, input_scale_sd=0.02).run()
    return watch(done, changes=changes)


def test_a_disturbance_without_steer_has_no_signature_and_gives_no_evidence():
    """Gusts of 3 mrad on a car whose steer stands still: information stays at zero."""
    t = np.arange(0, 60, 0.01)
    gusts = 0.003 * np.sin(2 * np.pi * 0.3 * t) * (np.sin(2 * np.pi * 0.02 * t) > 0)
    yaw = bicycle_response(t, gusts, 25.0, **TRUTH)[0]
    noise = NOISE * np.random.default_rng(1).standard_normal(t.size)
    seen = evidence(log_of(t, 0 * t, yaw + noise, np.full(t.size, 25.0)), known_least=0.0, heard_least=0.0)

    assert seen.alarms == ()
    # the drives along the steer lean on the held filter, so a little of a gust comes in by that way
    assert seen.information_rate.max() < DESIGN["hearing_least"]
    assert not seen.armed.any()


def test_information_grows_with_the_square_of_the_steer():
    """Twice the steer, twice the signature: four times the information a second."""
    rates = []
    for rms in (0.001, 0.002):
        seen = evidence(drive(seconds=60, rms=rms, noise=NOISE, seed=4))
        rates.append(np.median(seen.information_rate[3000:]))

    # the filter's own sizes of noise and disturbance grow with the response and take a part of it
    assert 2.0 < rates[1] / rates[0] < 4.4


def test_steer_that_moves_gives_information():
    assert wandering_steer(1, 0.005).size == 1000
    assert evidence(drive(seconds=30, rms=0.006)).information_rate[-1] > 50
