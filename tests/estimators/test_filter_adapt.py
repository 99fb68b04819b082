"""Sizes follow the innovations within their limits, and a status only rises."""

import math

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.estimators import filter_adapt as ad
from similitude.estimators.filter_fields import Layout
from similitude.status import STATUS
from similitude.systems.bicycle import bicycle_reduction

from ..run_statements import evaluate, run_statements

LAYOUT = Layout(bicycle_reduction())
LIMITS = {"noise_scale_low": 0.01, "noise_scale_high": 100.0, "noise_adapt": 0.05}


@settings(max_examples=50, deadline=None)
@given(st.floats(-1, 1))
def test_the_exponential_without_a_library(x):
    """Third order: positive down to -1, off by less than x^4/24 times e."""
    found = evaluate(ad.exponential(sp.Symbol("x", real=True)), {"x": x})

    assert found > 0
    assert abs(found - math.exp(x)) <= math.e * x**4 / 24 + 1e-15


@settings(max_examples=100, deadline=None)
@given(
    st.floats(1e-6, 1e6), st.floats(-1, 8), st.floats(0.01, 100), st.floats(0.05, 1), st.sampled_from([1, 3])
)
def test_the_noise_stays_within_its_limits_and_moves_towards_what_is_seen(dt, odd, scale, settling, times):
    given_ = {"dt": dt, "odd": odd, "noise_scale": scale, "settling": settling, **LIMITS}

    done = run_statements(ad.adapt_noise(LAYOUT, times), given_)

    assert LIMITS["noise_scale_low"] <= done["noise_scale"] <= LIMITS["noise_scale_high"]
    assert LIMITS["noise_adapt"] <= done["settling"] <= settling
    assert (done["noise_scale"] - scale) * odd >= 0


def test_a_sample_that_stands_for_three_moves_as_three():
    given_ = {"dt": 1e-4, "odd": 1.0, "noise_scale": 1.0, "settling": 0.5, **LIMITS}
    one = run_statements(ad.adapt_noise(LAYOUT), given_)
    for _ in range(2):
        one = run_statements(ad.adapt_noise(LAYOUT), {**given_, **one})
    three = run_statements(ad.adapt_noise(LAYOUT, 3), given_)

    # both follow the same slope; what differs is of second order in dt times the rate, 1.5e-4
    assert three["noise_scale"] - 1 == pytest.approx(one["noise_scale"] - 1, rel=1e-3)
    assert three["settling"] == pytest.approx(one["settling"], rel=1e-6)


@pytest.mark.parametrize("before", STATUS.values())
@pytest.mark.parametrize("name", ["not_excited", "outside_linear"])
def test_a_status_is_only_raised(before, name):
    done = run_statements([ad.set_lower_status(name)], {"status": before})

    assert done["status"] == max(before, STATUS[name])
