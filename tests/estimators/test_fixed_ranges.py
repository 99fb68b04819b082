"""Ranges hold for every input the gates let in, and are reached by the worst of them."""

import numpy as np
import pytest
from tests.estimators.fixed_case import NAMES, paper_named

from similitude.estimators.bessel import bessel_sections, cascade_response
from similitude.estimators.fixed_ranges import (
    filter_ranges,
    impulse_norms,
    nearest_forgetting,
    paper_ranges,
)
from similitude.estimators.paper_sums import paper_sums
from similitude.systems.bicycle import bicycle_reduction


def sections():
    return bessel_sections("high", 45.0, 0.01)


def test_the_norm_is_reached_by_the_signs_of_the_impulse_response():
    n = 400
    impulse = np.zeros(n)
    impulse[0] = 1.0
    response = cascade_response(sections(), impulse)
    worst = np.sign(response[::-1])
    _, out = impulse_norms(sections())

    assert cascade_response(sections(), worst)[-1] == pytest.approx(out, rel=1e-9)


def test_random_inputs_stay_inside():
    _, named = paper_named()
    found = filter_ranges(named)
    signs = np.random.default_rng(0).choice([-1.0, 1.0], 3000) * named["input_limit"]

    assert np.abs(cascade_response(sections(), signs)).max() < found["input_filtered"][1]
    assert found["input_memory_0"][1] == -found["input_memory_0"][0]


@pytest.mark.parametrize(("wanted", "k"), [(0.99995, 14), (0.9995, 11), (0.5, 1), (0.9, 3)])
def test_forgetting_becomes_a_shift(wanted, k):
    assert nearest_forgetting(wanted) == (1 - 2.0**-k, k)


def test_the_regressor_is_bounded_by_how_fast_a_car_steers_and_turns():
    _, named = paper_named()
    _, faster = paper_named()
    stated = paper_ranges(paper_sums(bicycle_reduction()), named, NAMES).stated

    assert stated["psi"][1] == pytest.approx(named["psi_limit"], rel=1e-3)
    assert 0 < named["psi_limit"] < 0.1
    assert faster["normal_start"] < named["psi_limit"] ** 2 * 1e-11
