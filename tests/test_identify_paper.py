"""The paper's regression on a log: near the truth without noise, and honest where it cannot be."""

import numpy as np
import pytest

from similitude.identification import identify

from .simulated_drive import CAR, drive, metres, vehicle

AVERAGE = {"pi1": 0.4431, "eta": 1.0977 * (1 - 0.4431) / 0.4431, "rho": 0.2510 / (0.4431 * (1 - 0.4431))}
FAST = {"rate": 1000, "U": 20.0, "rms": 0.02, "band": (0.15, 8.0)}


def paper(log):
    return identify(log, vehicle(steer_lag=metres(0.0)), estimator="paper")


def test_without_noise_and_with_the_paper_s_own_groups_it_finds_the_stiffness():
    """One kHz keeps T below 0.01; what is left is the terms the regression leaves out."""
    run = paper(drive(seconds=20, noise=0.0, **FAST, **AVERAGE))
    assert run.K.value == pytest.approx(CAR["K"], rel=0.10)
    assert abs(np.log(run.K.value / CAR["K"])) < 2 * run.K.std / run.K.value


def test_it_says_the_bias_before_the_number_and_does_not_call_it_identified():
    run = paper(drive(seconds=20, noise=0.0026, **FAST, **AVERAGE))
    assert run.warnings[0].startswith("before the number")
    assert run.assumed["noise_bias"].value > 1.0
    assert run.K.value > 2 * CAR["K"]
    assert run.verdict != "identified"
    assert run.K.lo < CAR["K"] < run.K.hi


def test_a_sample_time_too_long_for_its_lines_is_said():
    run = paper(drive(seconds=20, rate=100, U=25.0))
    assert any("T = 0.09" in line and "above 0.03" in line for line in run.warnings)


def test_every_row_has_a_positive_estimate():
    run = paper(drive(seconds=10, rate=100))
    assert (run.trace.K > 0).all()
    assert np.isfinite(run.trace.ln_K_std).all()


def test_frozen_groups_and_their_cost_are_listed():
    run = paper(drive(seconds=5))
    assert {"pi1", "pi4_slope", "pi5"} <= set(run.assumed)
    assert any("frozen" in line for line in run.warnings)
    assert run.K.std / run.K.value >= 0.12
