"""The three numbers a base is judged by, computed by hand and by simulation."""

import numpy as np
import pytest

from similitude import advise_base, pi_groups

from .classical import CASES

PENDULUM = {"T": "s", "l": "m", "g": "m/s^2"}


def ranked(variables, base, **more):
    return next(r for r in advise_base(variables, **more).ranked if set(r.base) == set(base))


def test_condition_and_exponents_of_the_pendulum_by_hand():
    """Base l, g: T = l^1/2 g^-1/2, so E E' = [[5/4, -1/4], [-1/4, 5/4]], eigenvalues 1 and 3/2."""
    one = ranked(PENDULUM, ["l", "g"])

    assert one.condition == pytest.approx(np.sqrt(1.5), rel=1e-12)
    assert str(one.largest) == "1/2" and one.drift is None


def test_the_drift_is_the_spread_that_reaches_the_groups():
    """Against groups computed from many draws of the base, the other variables held."""
    variables, base = CASES["pipe flow"].variables, ["rho", "V", "D"]
    spread = {"rho": 0.02, "V": 0.3, "D": 0.1}
    rng = np.random.default_rng(5)
    logs = {name: sd * rng.standard_normal(20_000) for name, sd in spread.items()}
    variances = [
        np.var(sum(float(x) * logs[name] for name, x in group.items() if name in logs))
        for group in pi_groups(variables, base)
    ]

    # a variance of 20 000 draws has a relative sd of 1 %, its root of 0.5 %
    assert ranked(variables, base, spread=spread).drift == pytest.approx(
        np.sqrt(np.mean(variances)), rel=0.02
    )


def test_a_spread_is_told_in_per_cent_while_it_is_small_and_as_a_factor_beyond():
    assert "moves the groups by 14 %" in ranked(PENDULUM, ["l", "g"], spread={"l": 0.2, "g": 0.2}).reason
    assert "by a factor of 2.72" in ranked(PENDULUM, ["l", "g"], spread={"l": 2.0, "g": 0.0}).reason


def test_without_remaining_variables_nothing_drifts():
    assert ranked({"l": "m"}, ["l"], spread={"l": 0.5}).drift == 0.0


def test_a_spread_that_nobody_stated_is_said():
    one = ranked(PENDULUM, ["T", "l"], spread={"T": 0.1, "g": 0.0})

    assert one.unstated == ("l",) and "the spread of l is not stated" in one.reason
