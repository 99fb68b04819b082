"""Drives: the same seed the same drive, cars as the population has them, and the truth kept apart."""

from dataclasses import fields

import numpy as np

from similitude.benchmark.cells import Cell
from similitude.benchmark.drives import LEAST_ETA, NOISE, Drive, K, draw, drives


def test_a_drive_depends_on_its_cell_and_seed_alone():
    two = drives(Cell("slalom", "linear", "none", 2), 5)
    one = drives(Cell("slalom", "linear", "none", 1), 6)

    assert np.allclose(two[1][0].r, one[0][0].r, atol=1e-12)
    assert not np.array_equal(two[0][0].r, two[1][0].r)


def test_a_fault_changes_what_it_names_and_no_more():
    (plain, truth), (coarse, same) = (
        drives(Cell("slalom", "linear", fault, 1), 5)[0] for fault in ("none", "quantised_steer")
    )

    assert np.array_equal(truth.K, same.K) and np.array_equal(plain.r, coarse.r)
    assert np.allclose(coarse.delta / 1e-3, np.round(coarse.delta / 1e-3), atol=1e-9)


def test_half_of_the_stiffness_is_gone_from_fifty_seconds_on():
    drive, truth = drives(Cell("highway", "linear", "none", 1), 5)[0]

    before, after = truth.K[drive.t < 49.99], truth.K[drive.t > 50.01]
    assert np.ptp(before) == 0 and np.allclose(after, before[0] / 2)


def test_cars_scatter_as_the_population_does_and_none_oversteers():
    cars = draw(list(range(2000)), {"K": 1.0, "eta": 1.0})

    # The sd of the mean of 2000 is 0.2/sqrt(2000), of the sd 0.2/sqrt(4000); three of them are allowed.
    assert abs(np.log(cars.K).mean() - np.log(K)) < 3 * 0.2 / np.sqrt(2000)
    assert abs(np.log(cars.K).std() - 0.2) < 3 * 0.2 / np.sqrt(4000)
    assert cars.groups["eta"].min() > LEAST_ETA


def test_an_estimator_sees_no_truth():
    drive, _ = drives(Cell("slalom", "linear", "none", 1), 5)[0]

    assert {f.name for f in fields(Drive)} == {"t", "delta", "r", "U", "ay", "vehicle"}
    assert drive.vehicle.Caf is None and drive.vehicle.m is None and drive.noise == NOISE
    assert drive.until(50.0).t[-1] < 50.0
