"""The quarter car against its invariant point and its weight on the road."""

import numpy as np
import pytest
import sympy as sp

from similitude.systems.quarter_car import QUARTER_CAR, SYSTEM

from .held_run import held_run


@pytest.mark.parametrize("damper", [300.0, 1000.0, 4000.0])
def test_at_the_wheels_own_frequency_no_strut_changes_the_bodys_acceleration(damper):
    """ms zs'' + mu zu'' = kt (zr - zu): at w^2 = kt/mu the wheel drops out, ms zs'' = kt zr."""
    p = SYSTEM.numbers() | {"cs": damper}
    known = {QUARTER_CAR.quantity(n).symbol: value for n, value in p.items()}
    x = [q.symbol for q in QUARTER_CAR.states]
    rates = sp.Matrix([QUARTER_CAR.rates[q.name] for q in QUARTER_CAR.states]).subs(known)
    A, B = (np.array(rates.jacobian(v), float) for v in (x, [QUARTER_CAR.inputs[0].symbol]))
    C = np.array(sp.Matrix([QUARTER_CAR.output_map["az"]]).subs(known).jacobian(x), float)
    w = np.sqrt(p["kt"] / p["mu"])

    assert (C @ np.linalg.solve(1j * w * np.eye(4) - A, B))[0, 0] == pytest.approx(p["kt"] / p["ms"])


def test_after_a_step_of_the_road_body_and_wheel_stand_on_it():
    run = held_run(SYSTEM, duration="20 s")

    assert run["zs"][-1] == pytest.approx(0.05, rel=1e-6) and run["zu"][-1] == pytest.approx(0.05, rel=1e-6)


def test_the_length_that_only_measures_is_in_no_group():
    assert not any("span" in group.exponents for group in SYSTEM.groups().groups)
    assert len(SYSTEM.numbers(next(iter(SYSTEM.table)))) == 6
