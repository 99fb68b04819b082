"""Leaps arrive where small steps would, and what is handed out is a covariance."""

import numpy as np

from similitude.populations.settle import settle

GOAL, COVARIANCE = np.array([3.0, -1.0]), np.array([[2.0, 0.6], [0.6, 0.5]])


def slowly(pace):
    """An improvement that covers a share of the way."""

    def improve(means, S, rows):
        calls.append(1)
        return means + pace * (GOAL - means), S + pace * (COVARIANCE - S), rows

    calls = []
    return improve, calls


def test_slow_steps_arrive_in_few_calls():
    improve, calls = slowly(0.01)
    means, S, _ = settle(improve, np.zeros((4, 2)), np.eye(2), np.zeros(1), 300)

    np.testing.assert_allclose(means, np.tile(GOAL, (4, 1)), atol=0.02)
    np.testing.assert_allclose(S, COVARIANCE, atol=0.02)
    assert len(calls) < 150  # small steps alone need 900 for that


def test_an_improvement_that_jumps_about_still_gives_a_covariance():
    rng = np.random.default_rng(0)

    def improve(means, S, rows):
        root = rng.normal(size=(2, 2))
        return rng.normal(size=means.shape), root @ root.T + 0.1 * np.eye(2), rows

    _, S, _ = settle(improve, np.zeros((3, 2)), np.eye(2), np.zeros(1), 60)
    assert np.all(np.linalg.eigvalsh(S) > 0)
