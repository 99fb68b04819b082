"""The saturating bicycle: the linear one at small slip, limited by its grip beyond."""

import numpy as np
import pytest
import sympy as sp

from similitude.saturation import Saturation
from similitude.systems.bicycle import BICYCLE, bicycle_reduction
from similitude.systems.saturating_bicycle import (
    SATURATING_BICYCLE,
    saturating_bicycle_groups,
    saturating_bicycle_reduction,
)

CAR = {"m": 1500.0, "L": 2.7, "U": 25.0, "a": 1.2, "b": 1.5, "Caf": 9e4, "Car": 1.1e5, "Iz": 2500.0}


def rates(model, values):
    known = {sp.Symbol(n, real=True): v for n, v in values.items()}
    out = []
    for rate in model.rates.values():
        plain = rate.replace(lambda e: isinstance(e, Saturation), lambda e: e.doit())
        out.append(float(plain.subs(known)))
    return np.array(out)


def test_at_small_slip_it_is_the_linear_bicycle():
    """The difference is of third order: a tenth of the slip, a thousandth of the difference."""
    apart = []
    for slip in (1e-2, 1e-3):
        at = {**CAR, "v": 2.0 * slip, "r": slip, "delta": 3 * slip, "grip": 9.8}
        apart.append(np.abs(rates(SATURATING_BICYCLE, at) - rates(BICYCLE, at)).max())
    assert apart[1] == pytest.approx(apart[0] / 1000, rel=0.2)


def test_no_steer_makes_more_than_the_grip():
    at = {**CAR, "v": 0.0, "r": 0.0, "delta": 1.0, "grip": 9.8}
    sideways, _ = rates(SATURATING_BICYCLE, at)
    front_share = CAR["b"] / CAR["L"]
    assert sideways == pytest.approx(9.8 * front_share, rel=0.01)


def test_grip_is_the_sixth_group():
    groups = saturating_bicycle_groups()
    sixth = groups.groups[-1]
    assert {n: int(p) for n, p in sixth.exponents.items()} == {"grip": 1, "L": 1, "U": -2}
    assert groups.value({**CAR, "grip": 9.8})[sixth.name] == pytest.approx(9.8 * 2.7 / 625)


def test_what_is_saturated_reads_as_a_force_over_a_force():
    """Reduced rates hold two loads, each factored."""
    reduced = saturating_bicycle_reduction()
    loads = {f.args[0] for rate in reduced.rates.values() for f in rate.atoms(Saturation)}
    assert len(loads) == 2
    assert all(load == sp.factor(load) for load in loads)
    assert {u.name for u in reduced.unknowns} - {u.name for u in bicycle_reduction().unknowns} == {"grip"}
