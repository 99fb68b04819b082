"""One output of a model: an output, a state or any formula in its quantities."""

import pytest

from similitude.errors import ModelError
from similitude.invariance.model_equations import equations
from similitude.systems.bicycle import BICYCLE


@pytest.mark.parametrize(
    ("output", "name", "unit"),
    [(None, "r", "1/s"), ("v", "v", "m/s"), ("v/U", "v/U", "-"), ("m*v", "m*v", "kg m/s")],
)
def test_outputs_states_and_formulas(output, name, unit):
    eq = equations(BICYCLE, output, angle=False)

    assert (eq.name, str(eq.output_measure)) == (name, unit)
    assert list(eq.parameters) == ["m", "U", "a", "b", "Caf", "Car", "Iz"]
    assert [c.where for c in eq.certificates] == ["rate of v", "rate of r", f"output {name}"]


def test_a_name_the_model_has_is_left_to_it():
    eq = equations(BICYCLE, None, angle=False)

    assert eq.free("m") == "m_" and eq.free("t") == "t"


@pytest.mark.parametrize(
    ("output", "angle", "said"),
    [
        ("q", False, r"no output 'q' \(outputs and states: r, v\)"),
        ("v + r", False, "the output r \\+ v has no unit"),
        ("v*q", False, "'q', which is not declared"),
        (None, True, "with angles as a dimension, the rate of 'v' is not homogeneous"),
    ],
)
def test_what_is_no_output_is_refused(output, angle, said):
    with pytest.raises(ModelError, match=said):
        equations(BICYCLE, output, angle=angle)


def test_an_input_has_to_be_named_where_there_are_several():
    eq = equations(BICYCLE, None, angle=False)

    assert eq.input_named(None) == eq.input_named("delta") == 0
    with pytest.raises(ModelError, match=r"no input 'u' \(inputs: delta\)"):
        eq.input_named("u")
