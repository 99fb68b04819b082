"""The regressions find the K of a car that is what they take for granted, and look no row ahead."""

import numpy as np
import pytest

from similitude.benchmark.drives import Drive
from similitude.benchmark.regression_rivals import padasip, window
from similitude.estimators.paper_design import PAPER_GROUPS
from similitude.simulate import bicycle_response

from .linear_drive import K, L, linear_drive

P1, RATIO, PI5 = PAPER_GROUPS["pi1"], PAPER_GROUPS["pi4_slope"], PAPER_GROUPS["pi5"]


def average_drive():
    """The paper's average car, without noise, along three sines."""
    given, _ = linear_drive()
    t = given.t
    delta = 0.01 * sum(np.sin(2 * np.pi * f * t + f) for f in (0.3, 0.7, 1.3))
    eta, rho = RATIO * (1 - P1) / P1, PI5 / (P1 * (1 - P1))
    r, _ = bicycle_response(t, delta, 22.0, L=L, K=K, pi1=P1, eta=eta, rho=rho)
    return Drive(t, delta, r, given.U, given.ay, given.vehicle)


def rivals():
    """Both, where padasip is installed."""
    pytest.importorskip("padasip")
    return {"window": window, "padasip": padasip}


@pytest.mark.parametrize("name", ["window", "padasip"])
def test_the_average_cars_stiffness_is_found(name):
    """A central difference over 2 h at 1.3 Hz and 100 Hz errs by (2 pi f h)²/6 = 0.1 %, twice for the second
    slope, on a part of the sum; one per cent holds it all."""
    answer = rivals()[name](average_drive())

    assert abs(np.log(answer.K[-1] / K)) < 0.01


@pytest.mark.parametrize("name", ["window", "padasip"])
def test_what_comes_later_changes_nothing(name):
    drive = average_drive()
    whole, part = rivals()[name](drive), rivals()[name](drive.until(40.0))
    n = drive.until(39.9).t.size

    assert np.allclose(whole.K[:n], part.K[:n], rtol=1e-9)


@pytest.mark.parametrize("name", ["window", "padasip"])
def test_lost_samples_are_bridged(name):
    drive = average_drive()
    drive.r[1000:1020] = np.nan
    drive.delta[0] = np.nan
    answer = rivals()[name](drive)

    assert np.isfinite(answer.K).all() and (answer.ln_K_std > 0).all()
