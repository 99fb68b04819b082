"""Exact sensitivities against differences of logarithms, and the rows in every form."""

import numpy as np
import pytest

from similitude.paper import printed
from similitude.paper.bode import (
    PARAMETERS,
    dimension_row,
    row_sums,
    state_space_residual,
    step_response,
    transfer_function,
    z_coefficients,
)

CAR = printed.TEST_VEHICLE
H = 1e-5


def difference(function, name):
    """d ln/d ln of a parameter by central differences."""
    up, down = (function({**CAR, name: CAR[name] * np.exp(sign * H)}) for sign in (1, -1))
    return (np.log(up) - np.log(down)) / (2 * H)


@pytest.mark.parametrize("name", PARAMETERS)
def test_sensitivities_are_those_of_differences(name):
    t, s, Ts = 0.2, 3.0j, 0.05
    assert step_response(CAR, t)[1][name] == pytest.approx(
        difference(lambda v: step_response(v, t)[0], name), abs=1e-6
    )
    assert transfer_function(CAR, s)[1][name] == pytest.approx(
        difference(lambda v: transfer_function(v, s)[0], name), abs=1e-6
    )
    found = z_coefficients(CAR, Ts)
    for key in ("b1", "a2"):
        expected = difference(lambda v, key=key: z_coefficients(v, Ts)[key][0], name)
        assert found[key][1][name] == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize("t", [0.02, 0.15, 1.0])
def test_the_rows_hold_at_every_time(t):
    assert row_sums(step_response(CAR, t)[1]) == pytest.approx([0, 0, -1], abs=1e-10)


def test_only_the_time_row_misses_time():
    bare = row_sums(step_response(CAR, 0.15)[1], without=("t",))

    assert bare == pytest.approx([0, 0, -1.3063], abs=5e-5)


def test_the_dimension_of_a_parameter_is_that_of_its_unit():
    assert dimension_row("Caf") == (1, 1, -2) and dimension_row("s") == (0, 0, -1)


def test_every_entry_of_the_matrices_obeys_its_rows():
    entries, left = state_space_residual()

    assert entries == 8 and left == 0
