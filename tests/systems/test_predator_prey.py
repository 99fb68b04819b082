"""Lotka and Volterra's equations against their constant of motion and Volterra's law of averages."""

import numpy as np
import pytest

from similitude.systems.predator_prey import SYSTEM

from .held_run import held_run


def test_the_constant_of_motion_is_constant():
    run, p, h = held_run(SYSTEM), SYSTEM.numbers(), SYSTEM.held_inputs()["h"]
    x, y = run["x"], run["y"]
    kept = p["e"] * x - (p["d"] + h) * np.log(x) + p["b"] * y - (p["a"] - h) * np.log(y)

    assert np.ptp(kept) < 1e-6 * abs(kept).max()
    assert x.max() / x.min() > 3  # it does go round


@pytest.mark.parametrize("effort", ["0 1/year", "0.05 1/year"])
def test_hunting_raises_the_average_of_the_prey(effort):
    """Volterra: a start at the averages (d + h)/e and (a - h)/b stays there."""
    h = float(effort.split()[0])
    x, y = (0.80 + h) / 0.024, (0.55 - h) / 0.028
    run = held_run(SYSTEM, h=effort, x=repr(x), y=repr(y))

    np.testing.assert_allclose(run["x"], x, rtol=1e-6)
    np.testing.assert_allclose(run["y"], y, rtol=1e-6)


def test_counts_have_no_unit_so_units_remove_time_alone():
    assert [dict(g.exponents) for g in SYSTEM.groups().groups] == [
        {"b": 1, "a": -1}, {"d": 1, "a": -1}, {"e": 1, "a": -1},
    ]  # fmt: skip
