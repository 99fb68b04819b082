"""Claims of section 3, and the rows once more by another route: other units."""

import numpy as np
import pytest

from similitude.paper import printed
from similitude.paper.bode import response, step_response
from similitude.paper.claims_invariance import degree, invariance_claims

from .pinned import check


def test_claims_are_the_pinned_ones():
    check("Sensitivity invariance", invariance_claims())


def test_three_sensitivities_follow_whichever_three():
    _, S = step_response(printed.TEST_VEHICLE, 0.15)
    for wanted in (("m", "Iz", "Caf"), ("m", "a", "U"), ("Iz", "b", "t")):
        found = response("time").solve_for(wanted, {n: x for n, x in S.items() if n not in wanted})
        assert [found[n] for n in wanted] == pytest.approx([S[n] for n in wanted], abs=1e-9)


def test_degrees_are_those_of_the_powers():
    assert degree("x*y**2/z", "x", "y", "z") == 2 and degree("sqrt(x)", "x") == 0.5


def test_time_counts_because_a_clock_has_a_unit_too():
    """With U, Caf, Car and the clock in minutes a car turns 60 times as many rad/min."""
    minutes = {**printed.TEST_VEHICLE, "U": 4.0 * 60, "Caf": 65.0 * 3600, "Car": 110.0 * 3600}
    one, other = step_response(printed.TEST_VEHICLE, 0.15)[0], step_response(minutes, 0.15 / 60)[0]
    still = step_response(minutes, 0.15)[0]

    assert other == pytest.approx(60 * one, rel=1e-9)
    assert not np.isclose(still, 60 * one, rtol=0.01)
