"""Ranges follow from gates, clamps and forgetting; a state that nothing bounds is refused."""

from dataclasses import replace

import pytest
import sympy as sp
from tests.program.tiny import mean, tiny_program, x

from similitude.errors import ProgramError
from similitude.program.fixed.bounds import Ranges, bounds, refined, span
from similitude.program.ir import Assign

STATED = Ranges({"dt": (0.0, 1.0), "x": (-1000.0, 1000.0), "last_0": (-10.0, 10.0), "last_1": (-10.0, 10.0)})


def test_a_mean_of_what_a_gate_lets_in_stays_between_the_gates():
    found = bounds(tiny_program(), {"rate": 0.5}, STATED)

    assert found["mean"] == pytest.approx((-10.0, 10.0), rel=1e-3)
    assert found["shown"] == found["mean"]


def test_a_sum_with_forgetting_is_bounded_by_its_memory():
    summed = (*tiny_program().step, Assign("mean", sp.Rational(3, 4) * mean + sp.Max(sp.Min(x, 2), -1)))
    found = bounds(tiny_program(step=summed), {"rate": 0.5}, STATED)

    assert found["mean"][1] == pytest.approx(10.0, rel=1e-3)  # the larger of the two assignments
    assert found["mean"][0] == pytest.approx(-10.0, rel=1e-3)
    alone = (Assign("status", sp.Integer(0)), summed[-1], Assign("shown", mean))
    found = bounds(replace(tiny_program(), step=alone), {"rate": 0.5}, STATED)
    assert found["mean"] == pytest.approx((-4.0, 8.0), rel=1e-3)


def test_a_state_that_only_grows_is_refused():
    grows = (*tiny_program().step, Assign("mean", mean + 1))
    with pytest.raises(ProgramError, match="nothing bounds mean"):
        bounds(tiny_program(step=grows), {"rate": 0.5}, STATED)


def test_a_guard_narrows_what_it_compares_on_either_side():
    env = {"x": (-10.0, 10.0), "y": (3.0, 4.0)}
    y = sp.Symbol("y", real=True)

    assert refined(x > y, env, True)["x"] == (3.0, 10.0)
    assert refined(x > y, env, False)["x"] == (-10.0, 4.0)
    assert refined(sp.Or(x < -2, x > 5), env, False)["x"] == (-2.0, 5.0)
    assert span(1 / x, {"x": (0.0, 1.0)})[1] == float("inf")
    assert span(x**2, env) == (0.0, 100.0)
