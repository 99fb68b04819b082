"""Trajectories and slopes against closed forms, stiff ones too; a state that runs away is said to."""

import numpy as np
import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.invariance.sensitivity_flow import Flow

x, k, u, t, x0 = sp.symbols("x k u t x0", real=True)
TIMES = np.array([0.0, 0.3, 0.3, 2.0, 1.0])


def test_a_lag_and_its_slopes():
    flow = Flow((x,), (k, u, x0), t, (u - k * x,), (x0,), (3 * x + t,))
    states, outputs, slopes = flow.integrator()([2.0, 1.0, 0.25], TIMES)
    e = np.exp(-2.0 * TIMES)
    true = 0.5 * (1 - e) + 0.25 * e
    by_k = 3 * (-0.5 * (1 - e) + (0.5 - 0.25) * 2.0 * TIMES * e)

    assert states[:, 0] == pytest.approx(true, abs=1e-11)
    assert outputs[0] == pytest.approx(3 * true + TIMES, abs=1e-11)
    assert slopes[0, 0] == pytest.approx(by_k, abs=1e-10)
    assert slopes[0, 1] == pytest.approx(3 * 0.5 * (1 - e), abs=1e-10)
    assert slopes[0, 2] == pytest.approx(3 * 0.25 * e, abs=1e-10)
    assert slopes[0, 3] == pytest.approx(TIMES * (3 * (1 - 2.0 * true) + 1), abs=1e-10)


def test_a_stiff_model_is_followed_in_few_steps():
    flow = Flow((x,), (k, u), t, (k * (sp.sin(u * t) - x),), (sp.Integer(0),), (x,))
    _, outputs, _ = flow.integrator()([1e4, 1.0], np.array([0.0, 1.0]))

    assert outputs[0, 1] == pytest.approx(np.sin(1) - 1e-4 * np.cos(1) - 1e-8 * np.sin(1), abs=1e-9)


def test_a_state_that_runs_away_is_said_to():
    flow = Flow((x,), (k,), t, (k * x**2,), (sp.Integer(1),), (x,))
    with pytest.raises(ModelError, match="cannot be followed"):
        flow.integrator()([1.0], np.array([2.0]))
