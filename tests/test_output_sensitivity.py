"""Slopes of the output against the exact response of the car, which is another program."""

import numpy as np
import pytest

from similitude.output_sensitivity import output_sensitivity, sampled_response
from similitude.systems.bicycle import bicycle_reduction

REDUCTION = bicycle_reduction()
VALUES = {"K": 145.68, "pi1": 0.4431, "eta": 1.42, "rho": 1.017, "m": 1500.0, "L": 2.7, "U": 25.0}
U = 0.02 * np.sin(2 * np.pi * 0.7 * np.arange(0, 4, 0.01))


def ode(values):
    """Yaw rate by integrating the dimensional equations, input held."""
    from scipy.integrate import solve_ivp

    m, L, speed, K = values["m"], values["L"], values["U"], values["K"]
    a = values["pi1"] * L
    b = L - a
    Cf = K * m / L
    Cr, Iz = values["eta"] * Cf * a / b, values["rho"] * m * a * b

    def rate(t, x):
        v, r = x
        delta = U[min(int(t / 0.01 + 1e-9), len(U) - 1)]
        f, g = Cf * (delta - (v + a * r) / speed), Cr * (b * r - v) / speed
        return [(f + g) / m - speed * r, (a * f - b * g) / Iz]

    grid = np.arange(len(U)) * 0.01
    return solve_ivp(rate, (0, grid[-1]), [0, 0], t_eval=grid, max_step=0.01, rtol=1e-7, atol=1e-10).y[1]


def test_the_response_is_that_of_the_equations_of_motion():
    np.testing.assert_allclose(sampled_response(REDUCTION, VALUES, U, 0.01)(VALUES), ode(VALUES), atol=2e-5)


@pytest.mark.parametrize("name", ["eta"])
def test_slopes_are_differences_of_the_equations_of_motion(name):
    s = output_sensitivity(REDUCTION, VALUES, U, 0.01)
    column = [one.name for one in REDUCTION.unknowns].index(name)
    high, low = (ode({**VALUES, name: VALUES[name] * np.exp(way)}) for way in (0.02, -0.02))

    np.testing.assert_allclose(s[:, column], (high - low) / 0.04, atol=0.01 * np.abs(s[:, column]).max())
