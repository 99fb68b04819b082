"""The four-unknown regression against one written here with scipy and NumPy, and its steps down."""

import dataclasses

import numpy as np
import pytest
from scipy import signal

from similitude.estimators import ladder_design as design
from similitude.estimators.robust import robust_regression
from similitude.systems.bicycle import bicycle_reduction

from .ladder_case import CAR, NOISE, PRIOR, QUIET, L, U, drive, run


def reference(rows, rate, *, noise=0.0):
    """K at the end: least squares with forgetting on four filtered signals, noise's moments taken out."""
    T, w = 1 / rate, design.STATE_FILTER
    slow = signal.lfilter([0.3 * T], [1, 0.3 * T - 1], rows[:, [1, 3]], axis=0)
    delta, r = (rows[:, [1, 3]] - slow).T
    stage = signal.bilinear([w], [1, w], fs=rate)

    def filtered(x):
        stages = [x]
        for _ in range(4):
            stages.append(signal.lfilter(*stage, stages[-1]))
        return stages[4], w * (stages[3] - stages[4]), w * w * (stages[2] - 2 * stages[3] + stages[4])

    (d0, d1, _), (r0, r1, r2) = filtered(delta), filtered(r)
    p1, rho = CAR["pi1"], CAR["rho"]
    B1 = 1 / (rho * (1 - p1))
    psi = np.column_stack([B1 * d1 / L**2, -r1 / (L * U), -r0 / L**2, d0 / (L**3 * U) - r0 / (L * U) ** 2])
    n0, n1, n2 = filtered(np.eye(1, 8000)[0])
    own = np.column_stack([0 * n0, -n1 / (L * U), -n0 / L**2, -n0 / (L * U) ** 2])
    learnt = np.arange(len(rows)) >= design.SETTLING / w / T
    weight = np.where(learnt, np.exp(-(np.arange(len(rows))[::-1] * T) / design.MEMORY), 0)
    A = (psi * weight[:, None]).T @ psi - weight.sum() * noise**2 * own.T @ own
    q = psi.T @ (weight * r2) - weight.sum() * noise**2 * own.T @ n2
    return np.linalg.solve(A, q)[0]


@pytest.mark.parametrize("noise", [0.0, NOISE])
def test_it_is_the_regression_it_says_it_is(noise):
    rows = drive(noise=noise)
    outputs, _, _ = run("robust", rows, noise=noise or QUIET, excitation_least=0.0)

    assert outputs["unknowns"][-1] == 4
    assert outputs["estimate"][-1] == pytest.approx(reference(rows, 100, noise=noise or QUIET), rel=1e-6)


@pytest.mark.parametrize("rate", [50, 100, 500])
def test_without_noise_it_finds_the_stiffness(rate):
    outputs, _, _ = run("robust", drive(30.0, rate), rate, noise=QUIET)

    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=5e-3)


def test_a_change_of_speed_is_no_change_of_K():
    """What dU/dt adds is left out: 3 m/s^2 against 22 m/s, filtered over 0.1 s."""
    t = np.arange(4000) // 25 / 4
    outputs, _, _ = run("robust", drive(speed=U + 8 * np.sin(2 * np.pi * t / 15)), noise=QUIET)

    assert np.abs(outputs["estimate"][1500:] / CAR["K"] - 1).max() < 0.02


def test_a_wrong_rear_axle_and_slow_relation_do_not_matter():
    """Only B1 = 1/(rho (1 - pi1)) is believed."""
    wrong = dataclasses.replace(PRIOR, mean=PRIOR.mean * [1, 1, 1.4, 1])
    outputs, _, _ = run("robust", drive(), noise=QUIET, prior=wrong)
    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=5e-3)

    heavy = dataclasses.replace(PRIOR, mean=PRIOR.mean * [1, 1, 1, 1.1])
    outputs, _, _ = run("robust", drive(), noise=QUIET, prior=heavy)
    assert outputs["estimate"][-1] == pytest.approx(1.1 * CAR["K"], rel=5e-3)


def test_taking_the_noise_out_of_the_sums_takes_its_bias_away():
    errors = {True: [], False: []}
    for seed in range(12):
        rows = drive(60.0, seed=seed, noise=NOISE, rms=0.003, band=(0.15, 1.0))
        for compensated, found in errors.items():
            outputs, _, _ = run("robust", rows, compensated=compensated)
            found.append(np.log(outputs["estimate"][-1] / CAR["K"]))
    spread = np.std(errors[True]) / np.sqrt(12)

    assert abs(np.mean(errors[True])) < 3 * spread
    assert abs(np.mean(errors[False])) > 2 * abs(np.mean(errors[True]))


def test_offsets_of_steer_and_gyro_are_taken_out():
    rows = drive(60.0)
    rows[:, 1] += 3e-3
    rows[:, 3] += 5e-3
    outputs, _, _ = run("robust", rows, noise=QUIET)

    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.01)


def test_an_unstable_car_is_no_trouble():
    prior = dataclasses.replace(PRIOR, mean=PRIOR.mean * [1, 1, 0.5, 1])
    outputs, _, _ = run("robust", drive(eta=0.75, speed=30.0)[:1000], noise=QUIET, prior=prior)

    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.01)


def test_it_is_named_after_its_model_and_says_its_coefficients():
    program = robust_regression(bicycle_reduction())

    assert program.name == "bicycle_robust"
    assert sum(line.startswith(("B1", "M2", "K1", "K2")) for line in program.provenance) == 4
