"""The printed Python is a module anyone can read and run: tables, init, step."""

import math

import pytest
import sympy as sp

from similitude.program.ir import Assign, When
from similitude.program.python import print_python

from .tiny import mean, tiny_program, x


def module(**changes) -> dict:
    namespace: dict = {}
    exec(compile(print_python(tiny_program(**changes)), "tiny.py", "exec"), namespace)
    return namespace


def test_the_tables_are_the_layout():
    twin = module()

    assert twin["NAME"] == "average" and twin["STATUS"] == {"ok": 0, "bad_sample": 7}
    assert twin["CONFIG"] == (("rate", "1/s", "forgetting rate", 1),)
    assert [row[0] for row in twin["STATE"]] == ["mean", "last"]
    assert [row[3] for row in twin["STATE"]] == [1, 2]
    assert [row[0] for row in twin["SAMPLE"]] == ["dt", "x"]
    assert twin["OPERATIONS"] == 9
    assert "do not edit" in twin["__doc__"] and "a test" in twin["__doc__"]


def test_the_step_changes_the_flat_state_in_place():
    twin = module()
    state = same = twin["init"]([2.0])

    answers = [twin["step"]([2.0], state, s) for s in ([0.1, 1.0], [0.1, math.nan], [5.0, 3.0])]

    assert answers == [(0, [0.2]), (7, [0.2]), (0, [3.0])]
    assert state is same and state == [3.0, 3.0, 1.0]


def test_a_guard_with_nothing_in_its_first_way_passes():
    otherwise = When(x > 0, (), (Assign("mean", -x),))
    step = (Assign("status", sp.Integer(0)), otherwise, Assign("shown", mean))
    twin = module(step=step)

    assert twin["step"]([2.0], [7.0, 0.0, 0.0], [0.1, 1.0]) == (0, [7.0])
    assert twin["step"]([2.0], [7.0, 0.0, 0.0], [0.1, -1.0]) == (0, [1.0])


def test_the_text_is_the_same_every_time():
    assert print_python(tiny_program()) == print_python(tiny_program())


@pytest.mark.parametrize("line", ["weight = ", "mean = mean + weight*(x - mean)", "status = 7.0"])
def test_a_statement_reads_like_its_formula(line):
    assert line in print_python(tiny_program())
