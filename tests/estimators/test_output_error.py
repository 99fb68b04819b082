"""The recursive prediction error method: exact without noise, at the information bound with it."""

import dataclasses

import numpy as np
import pytest

from similitude.estimators.output_error import output_error_method
from similitude.simulate import bicycle_response
from similitude.systems.bicycle import bicycle_reduction

from .ladder_case import CAR, NOISE, PRIOR, QUIET, L, U, drive, run


@pytest.mark.parametrize("rate", [50, 100, 500])
def test_without_noise_it_finds_the_stiffness(rate):
    """The step is within 0.2 % of the exponential, and is exact at rest."""
    outputs, _, _ = run("output_error", drive(30.0, rate), rate, noise=QUIET)

    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=3e-3)


def test_a_change_of_speed_is_no_change_of_K():
    t = np.arange(4000) // 25 / 4
    outputs, _, _ = run("output_error", drive(speed=U + 8 * np.sin(2 * np.pi * t / 15)), noise=QUIET)

    late = outputs["estimate"][1000:]
    assert np.abs(late / CAR["K"] - 1).max() < 0.01


def test_uneven_steps_are_taken_as_they_are():
    rows = drive(40.0, 200)
    keep = np.sort(np.random.default_rng(0).choice(len(rows), 4000, replace=False))
    thin = rows[keep]
    thin[:, 0] = np.diff(keep, prepend=keep[0] - 1) / 200
    outputs, _, _ = run("output_error", thin, noise=QUIET)

    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.01)


def test_offsets_of_steer_and_gyro_are_taken_out():
    rows = drive(60.0)
    rows[:, 1] += 3e-3
    rows[:, 3] += 5e-3
    outputs, _, _ = run("output_error", rows, noise=QUIET)

    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.01)


def sensitivity(rows):
    """d(r)/d(ln K) of the exact plant, high-passed as the estimator does (rate 0.3 1/s)."""
    t, groups = np.arange(len(rows)) / 100, {n: CAR[n] for n in ("pi1", "eta", "rho")}
    up, down = (
        bicycle_response(t, rows[:, 1], U, L=L, K=CAR["K"] * f, **groups)[0] for f in (1.01, 1 / 1.01)
    )
    s = (up - down) / (2 * np.log(1.01))
    slow, out = 0.0, []
    for x in s:
        slow += 0.003 * (x - slow)
        out.append(x - slow)
    return np.array(out)


def test_its_scatter_is_near_the_information_bound_and_it_knows():
    """Forty drives of three memories; the bound is sigma^2 over the weighted sum of squared sensitivity.

    Weights w of a mean with forgetting make a variance sigma^2 sum(w^2 s^2)/sum(w s^2)^2.
    """
    ends, claimed = [], []
    rows = drive(60.0, rms=0.003)
    s = sensitivity(rows)
    weight = np.exp(-(np.arange(len(s))[::-1] / 100) / 20.0)
    bound = NOISE * np.sqrt(np.sum(weight**2 * s**2)) / np.sum(weight * s**2)
    for seed in range(40):
        noisy = rows.copy()
        noisy[:, 3] += NOISE * np.random.default_rng(seed).standard_normal(len(rows))
        outputs, _, _ = run("output_error", noisy)
        ends.append(np.log(outputs["estimate"][-1] / CAR["K"]))
        claimed.append(outputs["variance"][-1])

    # sd of an sd from 40 draws: 11 %; the pull of the observer costs some of the information
    assert np.std(ends) < 1.5 * bound
    assert abs(np.mean(ends)) < 0.01
    assert np.sqrt(np.mean(claimed)) > 0.8 * np.std(ends)


def test_an_unstable_car_is_followed():
    """eta < 1 at 30 m/s: its yaw rate runs away; a driver's catch keeps it on the road."""
    eta, speed, n = 0.75, 30.0, 6000
    rng = np.random.default_rng(1)
    wanted = np.convolve(rng.standard_normal(n), np.ones(60) / 60, "same") * 0.02
    rows = _held_on_the_road(wanted, eta, speed)
    prior = dataclasses.replace(PRIOR, mean=PRIOR.mean * [1, 1, eta / PRIOR.mean[2], 1])
    outputs, status, _ = run("output_error", rows, noise=QUIET, prior=prior)

    assert np.abs(rows[:, 3]).max() < 1.0
    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.1)
    assert (status[200:] != 5).mean() > 0.95


def _held_on_the_road(wanted, eta, speed):
    """Rows of a car whose driver steers against its yaw rate, integrated by ten steps a sample."""
    p1, rho, K = CAR["pi1"], CAR["rho"], CAR["K"]
    p2 = 1 - p1
    g, k, pi5, h = K / speed**2, eta * p1 / p2, rho * p1 * p2, 0.01 * speed / L / 10
    v = r = delta = 0.0
    rows = []
    for w in wanted:
        rows.append([0.01, delta, speed, r * speed / L])
        new = w - 0.4 * r * speed / L
        for i in range(10):
            d = delta + (new - delta) * (i + 0.5) / 10
            front, rear = g * (d - v - p1 * r), g * k * (-v + p2 * r)
            v, r = v + h * (front + rear - r), r + h * (p1 * front - p2 * rear) / pi5
        delta = new
    return np.array(rows)


def test_it_is_named_after_its_model():
    assert output_error_method(bicycle_reduction()).name == "bicycle_output_error"
