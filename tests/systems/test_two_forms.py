"""The run in groups is a run of its own: a wrong group shows, units cannot."""

from dataclasses import replace

import pytest
import sympy as sp

from similitude.systems.dc_motor import SYSTEM
from similitude.systems.two_forms import simulate_two_forms


def both(groups, **changed):
    values = SYSTEM.numbers() | changed
    inputs, start = SYSTEM.held_inputs(), {"i": 0.2, "w": 0.0}
    return simulate_two_forms(groups, values=values, inputs=inputs, start=start, duration=3.0)


def test_both_forms_agree():
    run = both(SYSTEM.groups())

    assert run.names == ("i", "w", "w") and run.dimensional.shape == (60, 3)
    assert run.disagreement < 1e-7


@pytest.mark.parametrize("part", ["rates", "output_map", "scale", "time_scale"])
def test_an_error_anywhere_in_the_rewriting_shows(part):
    groups = SYSTEM.groups()
    value = getattr(groups, part)
    wrong = value * 1.01 if part == "time_scale" else {**value, "w": value["w"] * sp.Rational(101, 100)}

    assert both(replace(groups, **{part: wrong})).disagreement > 1e-4


def test_a_run_that_blows_up_is_an_error_and_no_number():
    with pytest.raises(ArithmeticError):
        both(SYSTEM.groups(), J=-1e-9, b=1e9)
