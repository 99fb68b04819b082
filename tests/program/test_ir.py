"""A program that would read what is not there, or write what it must not, cannot be made."""

import pytest
import sympy as sp

from similitude.errors import ProgramError
from similitude.program.ir import Assign, Field, When, shared, walk

from ..run_statements import evaluate, run_statements
from .tiny import mean, tiny_program, x

a, b, c = sp.symbols("a b c", real=True)
RIGHT = tiny_program()


def test_a_field_hands_out_one_symbol_per_element():
    assert [s.name for s in Field("P", "-", "", 3).symbols] == ["P_0", "P_1", "P_2"]
    assert [s.name for s in Field("P", "-", "").symbols] == ["P"]


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        (Assign("shown", a), "reads a in 'shown'"),
        (When(a > 0, (Assign("mean", x),)), "reads a in the condition"),
        (Assign("rate", x), "assigns 'rate' again"),
        (Assign("x", mean), "assigns 'x' again"),
    ],
)
def test_a_statement_that_cannot_be_run_is_refused(statement, said):
    with pytest.raises(ProgramError, match=said):
        tiny_program(step=(*RIGHT.step, statement))


def test_a_name_of_one_way_only_is_unknown_after_the_guard():
    only = When(x > 0, (Assign("shown", x),))
    with pytest.raises(ProgramError, match="leaves shown without a value"):
        tiny_program(step=(Assign("status", sp.Integer(0)), only))
    with pytest.raises(ProgramError, match="reads weight"):  # a temporary lives in its guard
        tiny_program(step=(*RIGHT.step, Assign("mean", sp.Symbol("weight", real=True))))

    both = When(x > 0, (Assign("shown", x),), (Assign("shown", -x),))
    tiny_program(step=(Assign("status", sp.Integer(0)), both, Assign("mean", mean)))


def test_a_temporary_is_constant():
    with pytest.raises(ProgramError, match="assigns 'half' again"):
        tiny_program(step=(*RIGHT.step, Assign("half", x / 2), Assign("half", x / 3)))


def test_every_state_and_output_gets_a_value():
    with pytest.raises(ProgramError, match="leaves last_1 without"):
        tiny_program(init=RIGHT.init[:2])
    with pytest.raises(ProgramError, match="leaves shown without"):
        tiny_program(step=RIGHT.step[:-1])
    with pytest.raises(ProgramError, match="leaves status without"):
        tiny_program(step=(Assign("shown", x),))


@pytest.mark.parametrize("name", ["mean", "last_1", "last", "dt"])
def test_a_name_is_declared_once(name):
    with pytest.raises(ProgramError, match=f"declares .*{name}.* more than once"):
        tiny_program(variables=(*RIGHT.variables, Field(name, "-", "")))


@pytest.mark.parametrize("name", ["double", "lambda", "größe", "v*", "2a", "state", ""])
def test_a_name_must_suit_both_languages(name):
    with pytest.raises(ProgramError, match="cannot declare"):
        tiny_program(variables=(*RIGHT.variables, Field(name, "-", "")))


def test_walk_visits_guards_before_what_they_guard():
    kinds = [type(s).__name__ for s in walk(RIGHT.step)]
    assert kinds == ["Assign", "When", *["Assign"] * 6]


def test_shared_parts_change_no_value():
    named = {"first": (a + b) ** 2 / c + a * b, "second": (a + b) * c - a * b}
    values = {"a": 0.3, "b": -1.7, "c": 2.9}

    lines = shared("t", named, {"first": "why"})

    after = run_statements(lines, values)
    # a handful of operations on numbers near one: ten roundings of 2^-53
    for name, expression in named.items():
        assert after[name] == pytest.approx(evaluate(expression, values), rel=1e-14)
    assert [s.target for s in lines][-2:] == ["first", "second"]
    assert lines[-2].comment == "why"
    assert shared("t", named) == shared("t", dict(named))


def test_a_report_reads_the_state_and_works_out_every_output():
    last = [s for s in RIGHT.step if getattr(s, "target", "") != "shown"]
    asked = tiny_program(step=tuple(last), report=(Assign("shown", mean),))
    assert asked.report[0].target == "shown"
    with pytest.raises(ProgramError, match="its step assigns the output shown"):
        tiny_program(report=(Assign("shown", mean),))
    with pytest.raises(ProgramError, match="leaves shown without"):
        tiny_program(step=tuple(last), report=(Assign("half", mean / 2),))
    with pytest.raises(ProgramError, match="reads x in 'shown'"):  # a sample is gone by then
        tiny_program(step=tuple(last), report=(Assign("shown", x),))
    with pytest.raises(ProgramError, match="assigns 'mean' again"):
        tiny_program(step=tuple(last), report=(Assign("shown", mean), Assign("mean", mean / 2)))
