"""The variance handed out, against the dense formula and at its edges."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.filter_rig import car_config
from tests.run_statements import run_statements

from similitude.estimators.filter_fields import Layout
from similitude.estimators.filter_interval import interval, leant_on
from similitude.filter_config import DESIGN
from similitude.program.library import shipped
from similitude.systems.bicycle import bicycle_reduction
from similitude.systems.bicycle_with_accelerometer import bicycle_with_accelerometer_reduction

LAYOUT = Layout(bicycle_reduction())
N = LAYOUT.covariance.n
T = LAYOUT.coordinates.index("K")
AT = [LAYOUT.coordinates.index(name) for name in leant_on(LAYOUT)]


def handed_out(P, doubt=2.0):
    """Own variance and the one for intervals, of a covariance (N, N)."""
    values = {LAYOUT.covariance.target(i, j): P[i, j] for i in range(N) for j in range(i, N)}
    found = run_statements(interval(LAYOUT), {**values, "slow_doubt": doubt})
    return found["own_variance"], found["variance"]


def drawn(seed):
    """A covariance of sizes as the filter has them."""
    rng = np.random.default_rng(seed)
    factor = rng.standard_normal((N, N + 2)) * 10.0 ** rng.uniform(-4, 0, N)[:, None]
    return factor @ factor.T


@given(seed=st.integers(0, 10_000), doubt=st.floats(0, 20))
def test_it_is_the_dense_formula(seed, doubt):
    P = drawn(seed)
    own, variance = handed_out(P, doubt)
    b, S = P[AT, T], P[np.ix_(AT, AT)]
    assert own == P[T, T]
    # two more columns than rows leave every pivot above 1e-6 of its variance, so none is held up
    scale = np.sqrt(np.diag(S))
    leant = (b / scale) @ np.linalg.solve(S / np.outer(scale, scale), b / scale)
    assert variance == pytest.approx(own + doubt * leant, rel=1e-6)
    assert own <= variance <= (1 + doubt) * own * (1 + 1e-9)


def test_what_leans_on_nothing_stays():
    P = drawn(1)
    P[T, AT] = P[AT, T] = 0
    assert handed_out(P) == (P[T, T], P[T, T])


def test_constants_that_are_known_add_nothing_and_break_nothing():
    P = drawn(2)
    for i in AT:
        P[i, :] = P[:, i] = 0
    assert handed_out(P) == (P[T, T], P[T, T])


@pytest.mark.parametrize("slip", [0.0, 1e-16, -1e-16])
def test_two_constants_that_are_one_leave_it_bounded(slip):
    P = drawn(3)
    first, second = AT[0], AT[1]
    P[second, :] = P[first, :]
    P[:, second] = P[:, first]
    P[second, second] = P[first, first] * (1 + slip)
    own, variance = handed_out(P)
    assert own <= variance <= 3 * own * (1 + 1e-12)


def test_a_small_filter_hands_out_its_own():
    small = Layout(bicycle_reduction(), lean=True)
    (line,) = interval(small)
    assert run_statements([line], {small.covariance.target(T, T): 0.3})["variance"] == 0.3


def test_only_what_is_learnt_from_every_sample_is_leant_on():
    assert leant_on(LAYOUT) == ("eta", "rho", "input_scale")
    richer = leant_on(Layout(bicycle_with_accelerometer_reduction()))
    assert richer == ("eta", "rho", "grip", "place", "input_scale")


@pytest.mark.parametrize("name", ["bicycle_population", "saturating_bicycle_population"])
def test_the_filter_goes_its_way_whatever_it_hands_out(name):
    library, rng = shipped(name), np.random.default_rng(4)
    n = 500
    steer = 0.02 * np.sin(np.arange(n) * 0.05)
    rows = np.column_stack([np.full(n, 0.01), steer, np.full(n, 25.0), 5 * steer + rng.normal(0, 3e-3, n)])
    outputs = []
    for doubt in (0.0, DESIGN["slow_doubt"], 1e6):
        config = car_config(library, slow_doubt=doubt)
        found, _ = library.run(config, library.start(config), rows)
        outputs.append(np.delete(found, library.index("output", "variance"), axis=1))
        assert np.all(np.isfinite(found))
    assert np.array_equal(outputs[0], outputs[1]) and np.array_equal(outputs[0], outputs[2])
