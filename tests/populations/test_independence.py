"""Probabilities are uniform where nothing is tied, whatever base is shared."""

import numpy as np
import pytest
from scipy.stats import kstest

from similitude.populations.independence import discoveries, probability


def draw(seed, n, *, tie=0.0):
    """Two own parameters that both follow the base, and each other by `tie`."""
    rng = np.random.default_rng(seed)
    base = rng.normal(size=(n, 2))
    one = base @ [1.0, -0.5] + 0.3 * rng.normal(size=n)
    other = base @ [0.8, 0.7] + 0.3 * rng.normal(size=n) + tie * (one - base @ [1.0, -0.5])
    return one, other, base


@pytest.mark.slow
@pytest.mark.parametrize("n", [16, 40])
def test_a_shared_base_is_no_relation(n):
    p = [probability(*draw(seed, n))[0] for seed in range(100)]

    assert kstest(p, "uniform").pvalue > 1e-3
    assert all(probability(*draw(seed, n))[1] for seed in range(3))


def test_a_tie_beyond_the_base_is_seen_and_its_sign_counts():
    one, other, base = draw(0, 60, tie=1.0)

    assert probability(one, other, base)[0] < 1e-6
    assert probability(one, other, base, opposite=True)[0] > 0.99
    assert probability(one, -other, base, opposite=True)[0] < 1e-6


def test_few_rows_are_permuted_and_the_least_probability_is_that_of_one_order():
    x = np.arange(5.0)
    p, given_base = probability(x, x**2, np.zeros((5, 2)))

    assert p == pytest.approx(2 / 120) or p == pytest.approx(1 / 120)
    assert not given_base and probability(x[:3], x[:3], np.zeros((3, 2)))[0] == 1.0


def test_adjusted_probabilities_are_those_of_benjamini_and_hochberg():
    assert discoveries(np.array([0.01, 0.04, 0.03, 0.5]), 0.05) == pytest.approx(
        [0.04, 0.16 / 3, 0.16 / 3, 0.5]
    )
    assert len(discoveries(np.zeros(0), 0.05)) == 0
