"""Seven parameters at once: claims, and three directions that no steer informs on."""

import numpy as np
import pytest

from similitude.paper import printed, seven
from similitude.paper.claims_seven import seven_claims, stiffness, two_fits

from .pinned import check


def test_claims_are_the_pinned_ones():
    check("Seven parameters at once", seven_claims(), relative=0.02)


def test_cars_along_a_blind_direction_answer_alike():
    """Mass, inertia and stiffness together; the row of mass says so."""
    heavy = {**printed.TEST_VEHICLE}
    for name in ("m", "Iz", "Caf", "Car"):
        heavy[name] *= 1.7
    one, other = seven.seven_model([printed.TEST_VEHICLE, heavy])

    assert other == pytest.approx(one, abs=1e-12)


def test_both_fits_explain_the_record_and_differ():
    one, other = two_fits()
    assert one.misfit == pytest.approx(other.misfit, rel=1e-6) and one.misfit < 1.05
    assert abs(np.log(stiffness(one) / stiffness(other))) > 0.15
