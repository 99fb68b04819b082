"""The DC motor against its transfer function and the speed that its source prints."""

import numpy as np
import pytest
import sympy as sp

from similitude.systems.dc_motor import DC_MOTOR, SYSTEM, J, K, L, M, R, b, i, u, w

from .held_run import held_run


def test_speed_from_voltage_is_the_textbooks_transfer_function():
    s = sp.Symbol("s")
    A = sp.Matrix([DC_MOTOR.rates["i"], DC_MOTOR.rates["w"]]).jacobian([i, w])
    B = sp.Matrix([DC_MOTOR.rates["i"], DC_MOTOR.rates["w"]]).jacobian([u, M])
    G = ((s * sp.eye(2) - A).inv() * B)[1, :]

    assert sp.simplify(G[0] - K / ((J * s + b) * (L * s + R) + K**2)) == 0
    assert sp.simplify(G[1] + (L * s + R) / ((J * s + b) * (L * s + R) + K**2)) == 0


def test_one_volt_turns_it_at_a_tenth_of_a_radian_a_second():
    """The source: a final speed of 0.1 rad/s for 1 V, K/(R b + K^2) = 0.0999."""
    speed = held_run(SYSTEM, duration="10 s")["w"][-1]

    assert speed == pytest.approx(0.01 / (1 * 0.1 + 0.01**2), rel=1e-6)
    assert round(speed, 1) == 0.1


def test_groups_are_the_ratio_of_time_constants_and_the_friction():
    groups = {g.parameter: dict(g.exponents) for g in SYSTEM.groups().groups}

    assert groups["L"] == {"L": 1, "R": -2, "K": 2, "J": -1}  # (L/R)/(J R/K^2)
    assert groups["b"] == {"b": 1, "R": 1, "K": -2}
    assert np.isclose(SYSTEM.groups().value(SYSTEM.numbers())["pi1"], 0.5 * 0.01**2 / 0.01)
