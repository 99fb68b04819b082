"""A speed in another unit needs an odd car; sound ones are left alone, whatever ay says."""

from dataclasses import replace

import numpy as np
import pytest

from similitude.identification import identify
from similitude.identify_setup import prepare, whole_log
from similitude.speed_unit_doubt import distance, gain, speed_unit_doubts

from .simulated_drive import CAR, drive, vehicle

MPH = 1.609344  # km/h


def doubts(log):
    ready = prepare(log, vehicle())
    return speed_unit_doubts(ready, whole_log(ready, ready.setup.run()))


def said_in(log, header):
    return replace(log, sources={"U": header})


@pytest.fixture(scope="module")
def town():
    return drive(seconds=40, U=14.0, rms=0.012, seed=3)


@pytest.mark.parametrize(
    ("header", "factor", "unit", "fix"),
    [
        ("U [km/h]", 1 / MPH, "in mph", "speed_is_mph"),
        ("U [km/h]", 1 / 1.852, "in knots", "speed_is_knots"),
        ("U [m/s]", 1 / 0.44704, "in mph", "speed_is_mph"),
        ("U [m/s]", 1 / MPH, "from mph", None),
    ],
)
def test_a_speed_that_claims_another_unit_is_named_where_the_car_can_be_known(
    town, header, factor, unit, fix
):
    (found,) = doubts(said_in(replace(town, U=town.U * factor), header))

    assert found.fault == "speed_unit"
    assert not found.certain
    assert unit in found.what
    assert found.fix == fix


def test_sound_cars_from_all_over_the_population_are_left_alone():
    rng = np.random.default_rng(5)
    for seed in range(3):
        car = {
            "K": CAR["K"] * np.exp(0.3 * rng.standard_normal()),
            "eta": 1.42 + 0.15 * rng.standard_normal(),
        }
        log = drive(seconds=30, U=rng.uniform(12, 30), rms=0.006, seed=seed, **car)
        assert doubts(said_in(log, "U [km/h]")) == ()


def test_a_lateral_acceleration_does_not_vouch_for_the_speed(town):
    """Quick steering at speed makes ay 0.7 of U r: with a speed too small by 1.6 they look alike."""
    slow = replace(town, U=town.U / MPH)

    assert doubts(said_in(replace(slow, ay=1.1 * slow.U * slow.r), "U [km/h]"))


def test_a_repair_that_was_asked_for_is_the_claim(town):
    """Read as mph by request, a speed in mph is what it should be; the header no longer counts."""
    log = replace(said_in(town, "U [km/h]"), fixes=("4000 cells of U [km/h] read as mph",))

    assert doubts(log) == ()


def test_the_gain_of_a_fit_over_itself_is_nothing_and_its_distance_that_of_its_coordinates(town):
    ready = prepare(town, vehicle())
    batch = whole_log(ready, ready.setup.run())
    sds = (batch.x - batch.frozen.middle) / batch.frozen.prior.std

    assert gain(batch, batch) == 0
    if np.count_nonzero(batch.frozen.prior.covariance) == 6:
        assert distance(batch) == pytest.approx(float(sds @ sds))


def test_without_a_fit_nothing_is_said(town):
    assert speed_unit_doubts(prepare(town, vehicle()), None) == ()


def test_a_long_log_is_judged_by_the_part_in_which_most_was_steered(town):
    times = 3
    t = np.arange(times * town.samples) / town.rate
    quiet = np.concatenate([np.full(town.samples, 0.1), np.ones((times - 1) * town.samples)])
    long = replace(
        town,
        t=t,
        **{name: np.tile(getattr(town, name), times) for name in ("r", "U")},
        delta=np.tile(town.delta, times),
    )
    long = replace(long, delta=long.delta * quiet, r=long.r * quiet, U=long.U / MPH)

    (found,) = doubts(said_in(long, "U [km/h]"))

    assert found.value > 9  # many thousand times as likely


def test_who_identifies_is_told(town):
    run = identify(said_in(replace(town, U=town.U / MPH), "U [km/h]"), vehicle())

    assert run.verdict not in ("identified", "weak") or any(
        "times as likely" in line for line in run.warnings
    )
