"""Two estimators on one log: sound cars are left in peace, a steer that acts late is not."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.cross_check import APART, cross_check, sentence
from similitude.identification import identify
from similitude.identify_setup import prepare
from similitude.report.summary import summary
from similitude.run import CrossCheck, positive_estimate
from similitude.units import Uncertain
from similitude.vehicle_file import Vehicle

from .montecarlo.experiment import fleet, log_of_car
from .simulated_drive import CAR, drive, metres, vehicle

NO_LAG = Uncertain(0.0, None, "s")


def checked(log, L, **known) -> CrossCheck | None:
    ready = prepare(log, Vehicle("car", L=metres(float(L)), **known))
    return cross_check(ready, ready.setup.run())


def late(log, rows):
    """The log of a steer that acts so many rows after its column says so."""
    return replace(log, delta=np.r_[log.delta[rows:], np.full(rows, log.delta[-1])])


@pytest.fixture(scope="module")
def sound():
    return identify(drive(seconds=60, rms=0.01), vehicle())


def test_a_sound_car_reads_alike_twice(sound):
    check = sound.cross_check

    assert not check.structure_error and check.unknowns == 4
    assert abs(check.apart) < 3 * check.std and check.std < 0.2
    assert check.K.lo < CAR["K"] < check.K.hi
    assert not any("disagree" in line for line in sound.warnings)


def test_the_summary_holds_both_numbers_and_the_doubt(sound):
    block = summary(sound)["cross_check"]

    assert block["estimator"] == "robust" and block["structure_error"] is False
    assert {"value", "std", "lo", "hi", "unit", "apart", "apart_std", "unknowns"} <= set(block)
    assert block["population"]["value"] == pytest.approx(sound.cross_check.population.value)


def test_a_lag_wrongly_stated_as_none_is_an_error_of_the_structure():
    run = identify(late(drive(seconds=60, rms=0.01), 10), vehicle(steer_lag=NO_LAG))

    assert run.cross_check.structure_error
    assert run.warnings[0] == sentence(run.cross_check)
    assert "two estimators disagree" in run.warnings[0]


def test_a_lag_that_is_scanned_is_none():
    assert not identify(late(drive(seconds=60, rms=0.01), 10), vehicle()).cross_check.structure_error


def test_a_change_of_stiffness_on_the_way_is_none():
    cars = fleet(22, cars=3, duration=60.0, step=30.0, steer_rms=1e-2)
    assert not any(checked(log_of_car(cars, i), cars.L[i]).structure_error for i in range(3))


def test_where_the_drive_says_nothing_nothing_is_said():
    run = identify(drive(seconds=30, rms=1e-4), vehicle())

    assert run.cross_check is None
    assert summary(run)["cross_check"] is None


def test_a_log_of_a_kilohertz_is_checked_at_a_hundred():
    run = identify(drive(seconds=20, rate=1000, rms=0.01), vehicle(steer_lag=NO_LAG))
    assert run.cross_check is not None and not run.cross_check.structure_error


def test_the_sentence_says_which_comparison_rang():
    def check(apart, average):
        known = positive_estimate(100.0, 0.1, "m^2/s^2")
        return CrossCheck(known, known, apart, 0.05, average, 0.1, 4, True)

    assert "average groups" not in sentence(check(-0.3, 0.0))
    assert "average groups" in sentence(check(0.0, 0.5))
    assert "-30 %" in sentence(check(-0.3, 0.0))


@pytest.mark.slow
@pytest.mark.parametrize("steer_rms", [3e-3, 10e-3])
def test_sound_cars_are_hardly_ever_accused(steer_rms):
    """40 cars of the reference experiment; both statistics stay well inside a normal's spread."""
    cars = fleet(21, cars=40, duration=60.0, steer_rms=steer_rms, halve=False)
    found = [checked(log_of_car(cars, i), cars.L[i]) for i in range(40)]
    said = [one for one in found if one is not None]
    same = np.array([one.apart / one.std for one in said])
    average = np.array([one.average_apart / one.average_std for one in said])

    print(f"\n{steer_rms}: {len(said)} checked, rms {np.std(same):.2f} and {np.std(average):.2f} sd")
    assert len(said) > 30
    assert not any(one.structure_error for one in said)
    assert np.sqrt(np.mean(same**2)) < 1.2 and np.sqrt(np.mean(average**2)) < 1.2
    assert np.abs(same).max() < APART


@pytest.mark.slow
@pytest.mark.parametrize(("rows", "share"), [(3, 0.9), (10, 0.9)])
def test_a_lag_that_nobody_accounted_for_rings(rows, share):
    """30 and 100 ms at 100 Hz and 10 mrad, the vehicle file saying none."""
    cars = fleet(23, cars=20, duration=60.0, steer_rms=1e-2, halve=False)
    found = [checked(late(log_of_car(cars, i), rows), cars.L[i], steer_lag=NO_LAG) for i in range(20)]

    assert np.mean([one is not None and one.structure_error for one in found]) >= share
