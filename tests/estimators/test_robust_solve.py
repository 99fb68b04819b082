"""Steps down: how many unknowns a drive carries, and what is read with that many."""

import numpy as np
import pytest

from similitude.estimators.robust_solve import ORDER, STAGES, normal_matrix
from similitude.simulate import bicycle_response

from .ladder_case import CAR, NOISE, PRIOR, L, U, drive, run


@pytest.mark.parametrize("hertz", [0.3, 0.5, 1.0])
def test_one_sine_carries_one_unknown_and_it_is_found(hertz):
    """Two unknowns of a sine, gain and phase, cannot be four."""
    rows = drive(40.0)
    t = np.arange(len(rows)) / 100
    rows = _driven(rows, 0.01 * np.sin(2 * np.pi * hertz * t))
    outputs, _, _ = run("robust", rows, noise=NOISE)

    assert outputs["unknowns"][1000:].max() == 1  # its beginning is more than a sine
    assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.02)


def _driven(rows, delta):
    t = np.arange(len(rows)) / 100
    groups = {n: CAR[n] for n in ("pi1", "eta", "rho")}
    r, _ = bicycle_response(t, delta, U, L=L, K=CAR["K"], **groups)
    noise = NOISE * np.random.default_rng(3).standard_normal(len(rows))
    return np.column_stack([rows[:, 0], delta, rows[:, 2], r + noise])


def test_a_straight_road_carries_none_and_K_is_held():
    outputs, _, _ = run("robust", drive(40.0, rms=1e-4, noise=NOISE))

    assert (outputs["unknowns"] == 0).all()
    assert (outputs["estimate"] == PRIOR.mean[0]).all()


def test_the_one_unknown_finds_its_way_from_afar():
    """K starts at twice and at half of what it is; the cost has a second valley near nothing."""
    rows = drive(40.0)
    t = np.arange(len(rows)) / 100
    rows = _driven(rows, 0.01 * np.sin(2 * np.pi * 0.4 * t))
    for start in (0.5 * CAR["K"], 2 * CAR["K"]):
        outputs, _, _ = run("robust", rows, noise=NOISE, K_start=start)
        assert outputs["estimate"][-1] == pytest.approx(CAR["K"], rel=0.03)


def test_what_is_asked_for_stands_last():
    assert ORDER[-1] == 1 and sorted(ORDER) == [1, 2, 3, 4]
    assert normal_matrix().n == STAGES
