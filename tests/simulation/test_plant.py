"""The Runge-Kutta step: fourth order, and what is held is held."""

import numpy as np
import pytest

from similitude.simulation.plant import Push, at_the_end, between, runge_kutta


def push(delta=0.0, ax=0.0):
    return Push(delta, 1.0, 0.0, 0.0, 0.0, ax, 1.0, 1.0)


def test_the_middle_is_the_mean_of_what_changes_and_the_start_of_what_is_held():
    middle, end = between(push(0.0, 1.0), push(2.0, 3.0)), at_the_end(push(0.0, 1.0), push(2.0, 3.0))
    assert (middle.delta, middle.ax) == (1.0, 1.0) and (end.delta, end.ax) == (2.0, 1.0)


@pytest.mark.parametrize("many", [False, True])
def test_halving_the_step_divides_the_error_by_sixteen(many):
    """x' = −x + δ(t), δ straight over one second: known in closed form, 1 s from rest."""
    exact = 2 * np.exp(-1)  # x = t − 1 + exp(−t) for δ = t, plus the start 1: exp(−1)

    def error(steps):
        h, x = 1 / steps, [np.ones(2) if many else 1.0]
        for k in range(steps):
            x, _ = runge_kutta(lambda s, p: [p.delta - s[0]], x, push(k * h), push(k * h + h), h)
        return float(np.max(np.abs(x[0] - exact)))

    assert error(8) / error(16) == pytest.approx(16, rel=0.1)
