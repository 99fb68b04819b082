"""The regression in a band against one written here with scipy's filters, and what noise does to it."""

import numpy as np
import pytest
from scipy import signal

from similitude.estimators import ladder_design as design
from similitude.estimators.band import band_regression
from similitude.estimators.bessel import bessel_sections
from similitude.systems.bicycle import bicycle_reduction

from .ladder_case import CAR, NOISE, QUIET, L, drive, run

FAST = {"rate": 1000, "seconds": 20.0, "band": (1.0, 15.0)}  # steering that the band hears


def reference(rows, rate, *, noise=0.0, memory=design.MEMORY):
    """K after each sample: least squares of r(q) - r(q-1) on the first-order form, filtered by scipy."""
    T = 1 / rate
    kinds = (("high", design.HIGH_PASS), ("low", design.LOW_PASS))
    sections = np.vstack([bessel_sections(kind, corner, T) for kind, corner in kinds])
    sos = np.insert(sections, 3, 1.0, axis=1)
    impulse = signal.sosfilt(sos, np.eye(1, 4000)[0])
    zero, one = impulse @ impulse, impulse[1:] @ impulse[:-1]
    steer, rate_of_yaw = (signal.sosfilt(sos, rows[:, i]) for i in (1, 3))
    p1, eta, rho = CAR["pi1"], CAR["eta"], CAR["rho"]
    k, pi5 = eta * p1 / (1 - p1), rho * p1 * (1 - p1)
    B1, M2 = p1 / pi5, 1 + k + (p1**2 + (1 - p1) ** 2 * k) / pi5
    to_r = T * M2 / (L * rows[1:, 2])
    psi = T * B1 / L**2 * steer[:-1] - to_r * rate_of_yaw[:-1]
    y = np.diff(rate_of_yaw)
    keep = np.exp(-T / memory)

    def total(x):
        return signal.lfilter([1], [1, -keep], x)

    learnt = np.arange(1, len(rows)) >= np.ceil(design.SETTLING / design.HIGH_PASS / T)
    A = total(np.where(learnt, psi**2 - to_r**2 * zero * noise**2, 0))
    Q = total(np.where(learnt, psi * y - to_r * (zero - one) * noise**2, 0))
    return Q, A


@pytest.mark.parametrize("noise", [0.0, NOISE])
def test_it_is_the_regression_it_says_it_is(noise):
    rows = drive(noise=noise, **FAST)
    assumed = noise or QUIET
    outputs, _, _ = run("band", rows, 1000, noise=assumed, excitation_least=0.0, K_low=1e-9, K_high=1e9)
    Q, A = reference(rows, 1000, noise=assumed)

    late = slice(5000, None)
    assert np.allclose(outputs["estimate"][1:][late], Q[late] / A[late], rtol=1e-7, atol=0)


def test_without_noise_it_reads_up_to_what_its_form_leaves_out():
    """Left out is K1 and K2: of relative size K2 K/(U^2 ...) over the band, a few per cent of a car."""
    outputs, _, _ = run("band", drive(**FAST), 1000, noise=QUIET)

    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.05)


def test_taking_the_noise_out_of_the_sums_takes_its_bias_away():
    """Means of six drives: without, K reads low; with it, within three sd and 1 % of right."""
    errors = {True: [], False: []}
    for seed in range(6):
        rows = drive(seed=seed, noise=0.01, rms=0.005, **FAST)
        quiet, _, _ = run("band", drive(seed=seed, rms=0.005, **FAST), 1000, noise=QUIET)
        for compensated, found in errors.items():
            outputs, _, _ = run("band", rows, 1000, noise=0.01, compensated=compensated)
            found.append(np.log(outputs["estimate"][-1] / quiet["estimate"][-1]))
    mean = {key: np.mean(x) for key, x in errors.items()}
    spread = np.std(errors[True]) / np.sqrt(6)

    assert mean[False] < -0.05
    assert abs(mean[True]) < 3 * spread + 0.01


def test_hands_on_a_wheel_say_nothing_to_it():
    outputs, _, _ = run("band", drive(band=(0.15, 1.0), noise=NOISE))

    assert (outputs["unknowns"] == 0).all() and (outputs["variance"] == 1.0).all()


def test_it_is_named_after_its_model_and_says_what_it_froze():
    program = band_regression(bicycle_reduction())

    assert program.name == "bicycle_band"
    assert any("frozen: pi1, eta, rho" in line for line in program.provenance)
