"""To python-control and back: the same poles and gains, and units the caller stated."""

import sys

import numpy as np
import pytest

from similitude.errors import ModelError
from similitude.invariance.invariances import invariances
from similitude.linear.control import from_control, to_control
from similitude.model import Quantity
from similitude.systems.bicycle import BICYCLE

control = pytest.importorskip("control")
CAR = {"m": 5.451, "Iz": "0.1615 kg m^2", "U": 4.0, "a": 0.1461, "L": 0.3652, "Caf": 65.0, "Car": 110.0}


def test_the_bicycle_goes_there_and_comes_back():
    there = to_control(BICYCLE, CAR)
    back = from_control(there, states=BICYCLE.states, inputs=BICYCLE.inputs, outputs=BICYCLE.outputs)
    again = to_control(back, {})

    for letter in "ABCD":
        assert np.array_equal(getattr(again, letter), getattr(there, letter))
    assert invariances(BICYCLE, response="poles").value(CAR) == pytest.approx(np.sort_complex(there.poles()))
    assert {q.name: q.unit for q in back.parameters}["a12"] == "m/s"


def test_a_transfer_function_becomes_a_model_with_units():
    model = from_control(
        control.tf([1.0, 3.0], [2.0, 4.0, 5.0]), inputs=[Quantity("u", "V")], outputs=[Quantity("w", "m")]
    )
    gain = invariances(model, response="dc_gain")

    assert gain.value({}) == pytest.approx(0.6)
    assert {q.name: q.unit for q in model.parameters} == {
        "a1": "1/s", "a2": "1/s^2", "b1": "s^2 A/(kg m)", "b2": "s A/(kg m)"
    }  # fmt: skip


@pytest.mark.parametrize(
    ("system", "said"),
    [
        (control.ss([[0.5]], [[1]], [[1]], [[0]], 0.1), "sampled every 0.1"),
        (control.ss([[-1.0]], [[1]], [[1]], [[0]]), "1 states, 1 inputs and 1 outputs; .* none, 1 and 1"),
        (control.tf([[[1.0], [1.0]]], [[[1.0, 1.0], [1.0, 2.0]]]), "2 inputs"),
        (control.tf([1.0, 0.0, 0.0], [1.0, 1.0]), "numerator of order 2 over one of 1"),
        (3, "is needed, not 3"),
    ],
)
def test_what_cannot_be_taken_is_refused(system, said):
    with pytest.raises(ModelError, match=said):
        from_control(system, inputs=[Quantity("u", "V")], outputs=[Quantity("w", "m")])


def test_without_the_extra_the_line_to_install_it_is_shown(monkeypatch):
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(ModelError, match="not installed") as caught:
        to_control(BICYCLE, CAR)

    assert "similitude[control]" in str(caught.value)
