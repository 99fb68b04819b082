"""Conditioning a Prior is the product of two Gaussians, whatever order things are said in."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.population import Prior

KINDS = ("log", "linear", "log")


def correlated(seed):
    """A prior with every pair of unknowns tied."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(3, 3))
    mean = np.array([145.0, 0.44, 1.4])
    return Prior(("K", "p", "eta"), KINDS, mean, 0.02 * (root @ root.T + 0.1 * np.eye(3)))


def coordinates(prior):
    return np.where([kind == "log" for kind in KINDS], np.log(prior.mean), prior.mean)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 1000), st.sampled_from(range(3)), st.floats(0.01, 1.0), st.floats(-0.5, 0.5))
def test_observe_is_the_product_of_two_gaussians_in_information_form(seed, i, std, away):
    prior = correlated(seed)
    name = prior.names[i]
    place = coordinates(prior)[i] + away
    value = np.exp(place) if KINDS[i] == "log" else place

    told = prior.observe(name, value, std, "a measurement")

    seen = np.zeros((3, 3))
    seen[i, i] = 1 / std**2
    information = np.linalg.inv(prior.covariance) + seen
    weighted = np.linalg.solve(prior.covariance, coordinates(prior)) + seen[i] * place
    mean = np.linalg.solve(information, weighted)
    tolerance = 1e-12 * np.linalg.cond(information)  # what two inversions lose
    assert np.allclose(coordinates(told), mean, rtol=0, atol=tolerance)
    assert np.allclose(told.covariance, np.linalg.inv(information), rtol=0, atol=tolerance)
    assert told.origins == {name: "a measurement"}


def test_the_order_of_measurements_does_not_matter():
    prior = correlated(4)
    said = [("K", 120.0, 0.2, "x"), ("eta", 1.7, 0.1, "y"), ("p", 0.41, 0.02, "z")]
    forth, back = prior, prior
    for one, other in zip(said, reversed(said), strict=True):
        forth, back = forth.observe(*one), back.observe(*other)

    assert np.allclose(forth.mean, back.mean, rtol=1e-12)
    assert np.allclose(forth.covariance, back.covariance, rtol=0, atol=1e-14)


def test_an_exact_measurement_settles_its_unknown_and_a_vague_one_changes_nothing():
    prior = correlated(1)
    exact = prior.observe("K", 100.0, 0.0, "exact")
    vague = prior.observe("K", 100.0, 1e9, "vague")

    assert exact.mean[0] == pytest.approx(100.0, rel=1e-12)
    assert exact.covariance[0] == pytest.approx(np.zeros(3), abs=1e-15)
    assert np.allclose(vague.mean, prior.mean, rtol=1e-12)
    assert np.allclose(vague.covariance, prior.covariance, rtol=1e-12)


def test_known_replaces_one_unknown_and_cuts_its_ties():
    prior = correlated(2)
    told = prior.known("p", 0.5, 0.01, "the file")

    assert told.mean.tolist() == [145.0, 0.5, 1.4]
    assert told.std[1] == pytest.approx(0.01)
    assert told.covariance[1, [0, 2]].tolist() == told.covariance[[0, 2], 1].tolist() == [0, 0]
    rest = np.ix_([0, 2], [0, 2])
    assert np.array_equal(told.covariance[rest], prior.covariance[rest])
    assert prior.origins == {}  # the first one was left alone


def test_limits_lie_at_their_distance_in_the_coordinate():
    prior = correlated(3)
    low, high = prior.limits(np.array([0.7, 0.1, 0.3]))

    assert np.log(high / prior.mean)[[0, 2]] == pytest.approx([0.7, 0.3])
    assert np.log(prior.mean / low)[[0, 2]] == pytest.approx([0.7, 0.3])
    assert (high - prior.mean)[1] == pytest.approx(0.1)
    assert (prior.mean - low)[1] == pytest.approx(0.1)


def test_one_more_unknown_may_err_as_another_does():
    """d = p - q: its covariance with everything is that of p, its variance q's more."""
    prior = correlated(3)

    more = prior.beside("d", "linear", 0.1, 0.02, "stated", as_of="p")

    assert np.array_equal(more.covariance[3, :3], prior.covariance[1])
    assert more.covariance[3, 3] == pytest.approx(prior.covariance[1, 1] + 0.02**2)
    assert np.array_equal(more.covariance[:3, :3], prior.covariance)
    assert not prior.beside("d", "linear", 0.1, 0.02, "stated").covariance[3, :3].any()
