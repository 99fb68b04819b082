"""What learns on a small part, and how its unknowns move."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.estimators.filter_fields import BIAS, Layout
from similitude.estimators.lean_correction import correction, held_of, keep_each_within, move_square
from similitude.status import STATUS
from similitude.systems.bicycle import bicycle_reduction
from similitude.systems.bicycle_with_accelerometer import small_accelerometer_reduction

from ..run_statements import run_statements


def layout_of(reduction):
    return Layout(reduction, errors=(BIAS,), monitored=False, followed=False, fine=False, lean=True)


def test_unknowns_wait_for_something_to_be_heard_and_the_rest_does_not():
    layout = layout_of(small_accelerometer_reduction())
    held, fast = held_of(layout)

    assert [layout.coordinates[i] for i in held] == ["K", "pi1", "eta", "rho", "lead"]
    assert sorted(held + fast) == list(range(len(layout.coordinates)))


@pytest.mark.parametrize("reduction", [bicycle_reduction(), small_accelerometer_reduction()])
def test_every_entry_but_the_unknowns_own_is_corrected_once_in_one_pass(reduction):
    layout = layout_of(reduction)
    P, (_, fast) = layout.covariance, held_of(layout)

    lines = [
        s.target for s in correction(layout, {1: sp.Symbol("os", real=True)}, []) if s.target[:2] == "P_"
    ]

    mine = {P.target(i, j) for i in fast for j in range(P.n)}
    assert sorted(lines) == sorted(mine)


@settings(max_examples=200, deadline=None)
@given(st.floats(-2, 2), st.floats(1e-3, 1e3))
def test_a_move_is_that_of_the_logarithm_and_never_below_zero(by, value):
    """exp(m/2) to second order, squared: 1 + m + m^2/2 + m^3/8 + m^4/64, off by m^3/24 and less."""
    moved = run_statements(move_square("K", "d"), {"d": by, "K": value})["K"] / value

    series = 1 + by + by**2 / 2 + by**3 / 6 + by**4 / 24
    assert moved >= 0.25 * (1 - 1e-12)
    assert moved == pytest.approx(series, abs=abs(by) ** 3 / 24 + by**4 / 24 + 1e-12)


@pytest.mark.parametrize("by", [-1e30, -16.0, 16.0, 1e30])
def test_no_move_makes_an_unknown_negative(by):
    assert run_statements(move_square("K", "d"), {"d": by, "K": 100.0})["K"] > 0


@pytest.mark.parametrize(("value", "kept", "told"), [(0.5, 1.0, True), (1.5, 1.5, False), (3.0, 2.0, True)])
def test_an_unknown_is_put_back_to_its_limit(value, kept, told):
    lines = keep_each_within(["K"])
    done = run_statements(lines, {"K": value, "K_low": 1.0, "K_high": 2.0, "status": 0})

    assert done["K"] == kept and (done["status"] == STATUS["at_limit"]) == told
