"""What a lag or a servo that nobody stated leaves open of K, and that the interval then holds it."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.filter_config import COMMANDED_STEER_SD
from similitude.servo import Servo
from similitude.steer_lag import LagScan, Otherwise, find_lag
from similitude.steer_passes import behind_servos, passes
from similitude.steer_servo import MOST, find_servo
from similitude.vehicle_prior import vehicle_prior

from .simulated_drive import CAR, vehicle, wandering_steer
from .test_filter_run import setup_of
from .test_steer_servo import commanded, swings


def scanned(log):
    """The setup with what a scan of the log chose, and the scan."""
    car = vehicle()
    setup = setup_of(log, vehicle_prior(car))
    scan = find_servo(setup, find_lag(setup, car))
    return setup.with_servo(scan.servo).with_lag(scan.chosen, COMMANDED_STEER_SD), scan


@pytest.fixture(scope="module")
def driven():
    command = wandering_steer(40, 0.02, band=(0.15, 3.0), seed=3)
    return scanned(commanded(Servo(0.05, 2.0), lag=0.03, command=command, U=15.0))


def test_a_stated_lag_leaves_nothing_open(driven):
    setup, scan = driven
    stated = LagScan(np.empty(0), np.empty(0), scan.chosen, "vehicle file")
    done, sd = passes(setup, stated)

    assert not sd.any() and behind_servos(setup, stated) == 0.0
    assert np.array_equal(done.outputs, setup.run().outputs)


def test_a_measured_lag_leaves_half_of_what_two_passes_differ_by(driven):
    setup, scan = driven
    measured = replace(scan, std=0.005, others=())
    sides = [setup.with_lag(scan.chosen + step, COMMANDED_STEER_SD).run() for step in (-0.005, 0.005)]
    earlier, later = (np.log(side.output("estimate")) for side in sides)

    assert passes(setup, measured)[1] == pytest.approx(np.abs(later - earlier) / 2)
    assert behind_servos(setup, measured) == 0.0


def test_other_servos_count_by_how_much_the_log_speaks_for_them(driven):
    setup, scan = driven
    assert 0 < len(scan.others) <= MOST
    assert sum(x.weight for x in scan.others) < 1  # the chosen one has the rest
    assert [x.weight for x in scan.others] == sorted((x.weight for x in scan.others), reverse=True)

    far = setup.with_servo(Servo(0.11, 2.0)).run().output("estimate")
    one = replace(scan, others=(Otherwise(Servo(0.11, 2.0), 0.0, 0.25),))
    done, sd = passes(setup, one)
    assert np.array_equal(done.outputs, setup.run().outputs)  # what is reported stays
    assert sd == pytest.approx(0.5 * np.abs(np.log(far / done.output("estimate"))))
    assert behind_servos(setup, one) == sd[-1] > 0


@pytest.mark.slow
def test_the_interval_holds_K_behind_servos_that_were_not_told():
    """24 drives behind servos of all kinds."""
    rng, off = np.random.default_rng(5), []
    for seed in range(24):
        servo = Servo(0.04 * np.exp(0.5 * rng.standard_normal()), 2.0 * np.exp(0.6 * rng.standard_normal()))
        lag, U = round(float(rng.uniform(0.01, 0.06)), 3), float(rng.uniform(8, 25))
        command = (
            wandering_steer(60, 0.3 / U, band=(0.15, 3.0), seed=seed)
            if seed % 2
            else swings(0.45 / U, seed=seed)
        )
        setup, scan = scanned(commanded(servo, lag=lag, command=command, U=U, seed=seed))
        done, sd = passes(setup, scan)
        error = np.log(done.output("estimate")[-1] / CAR["K"])
        off.append(error / np.hypot(np.sqrt(done.output("variance")[-1]), sd[-1]))

    assert np.mean(np.abs(off) < 1.96) >= 19 / 24  # fewer in 1 of 1000 runs of a right interval
    assert np.sqrt(np.mean(np.square(off))) < 1.25
