"""The forms by the paper's letters: sensitivities against differences of logarithms, rows, matrices."""

import numpy as np
import pytest
import sympy as sp

from similitude.paper import printed
from similitude.paper.bode import (
    PARAMETERS,
    exponents,
    right_sides,
    row_sums,
    sampled_transfer,
    state_space,
    state_space_residuals,
    step_response,
    transfer_function,
)

CAR = printed.TEST_VEHICLE
H = 1e-5


def difference(function, name):
    """d ln/d ln of a parameter by central differences."""
    up, down = (function({**CAR, name: CAR[name] * np.exp(sign * H)}) for sign in (1, -1))
    return (np.log(up) - np.log(down)) / (2 * H)


@pytest.mark.parametrize("name", PARAMETERS)
def test_sensitivities_are_those_of_differences(name):
    t, s, z, Ts = 0.2, 3.0j, np.exp(0.3j), 0.05
    for form in (
        lambda v: step_response(v, t),
        lambda v: transfer_function(v, s),
        lambda v: sampled_transfer(v, z, Ts),
    ):
        # the rows of time are integrated to 1e-10 of y, a difference of logarithms divides by 2e-5
        expected = difference(lambda v, form=form: form(v)[0], name)
        assert form(CAR)[1][name] == pytest.approx(expected, abs=1e-5)


def test_values_are_those_of_the_printed_transfer_function():
    m, Iz, U, a, b, Cf, Cr = (CAR[n] for n in PARAMETERS)
    s, L = 3.0j, a + b
    over = a * Cf / Iz * s + Cf * Cr * L / (m * Iz * U)
    damping = (Cf + Cr) / (m * U) + (a * a * Cf + b * b * Cr) / (Iz * U)
    under = s * s + damping * s + Cf * Cr * L * L / (m * Iz * U * U) - (a * Cf - b * Cr) / Iz

    assert transfer_function(CAR, s)[0] == pytest.approx(over / under, rel=1e-12)
    assert step_response(CAR, 60.0)[0] == pytest.approx(transfer_function(CAR, 1e-9)[0].real, rel=1e-6)
    slow = np.exp(1e-6j)
    assert sampled_transfer(CAR, slow, 0.05)[0] == pytest.approx(transfer_function(CAR, 2e-5j)[0], rel=1e-5)


@pytest.mark.parametrize("t", [0.02, 0.15, 1.0])
def test_the_rows_hold_at_every_time(t):
    assert row_sums("time", step_response(CAR, t)[1]) == pytest.approx(right_sides("time"), abs=1e-9)


def test_only_the_time_row_misses_time():
    bare = row_sums("time", step_response(CAR, 0.15)[1], without=("t",))

    assert bare == pytest.approx([0, 0, -1.3063], abs=5e-5) and right_sides("time").tolist() == [0, 0, -1]


def test_exponents_are_those_of_the_unit():
    assert exponents("time", "Caf") == (1, 1, -2) and exponents("frequency", "s") == (0, 0, -1)


def test_every_entry_of_the_matrices_obeys_its_rows():
    left = state_space_residuals()

    assert len(state_space()) == 8 and len(left) == 24 and set(left) == {0}
    assert state_space()[1, 4] == sp.Symbol("Caf", real=True) / sp.Symbol("m", real=True)
