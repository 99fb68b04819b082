"""The circuit against the closed form of its step response."""

import numpy as np

from similitude.systems.rlc_circuit import SYSTEM

from .held_run import held_run


def test_the_step_response_is_the_textbooks():
    """280 ohm, 0.1 H, 0.4 uF at 48 V: 48 - e^(-1400 t) (48 cos 4800 t + 14 sin 4800 t) volts."""
    run = held_run(SYSTEM)
    t = run["t"]
    closed = 48 - np.exp(-1400 * t) * (48 * np.cos(4800 * t) + 14 * np.sin(4800 * t))

    np.testing.assert_allclose(run["vc"], closed, atol=48 * 1e-7)


def test_the_one_group_is_twice_the_damping_ratio():
    (group,) = SYSTEM.groups().groups
    damping = 1400 / np.hypot(1400, 4800)

    assert np.isclose(SYSTEM.groups().value(SYSTEM.numbers())[group.name], 2 * damping)
