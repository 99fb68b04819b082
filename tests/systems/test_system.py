"""A System knows its own names and units, and says which one is wrong."""

from dataclasses import replace

import pytest

from similitude.errors import ModelError, UnitError
from similitude.systems.bicycle import SYSTEM as BICYCLE
from similitude.systems.dc_motor import SYSTEM as MOTOR


def test_numbers_are_si_in_the_models_order():
    numbers = replace(MOTOR, values={**MOTOR.values, "L": "500 mH", "K": "10 mN m/A"}).numbers()

    assert list(numbers) == ["R", "K", "J", "L", "b"]
    assert numbers["L"] == pytest.approx(0.5) and numbers["K"] == pytest.approx(0.01)


def test_a_row_of_the_table_stands_in_place_of_the_nominal_values():
    (row,) = MOTOR.table

    assert MOTOR.numbers(row)["R"] == 4.0 and MOTOR.numbers()["R"] == 1.0


def test_what_a_constraint_gives_may_be_left_out():
    assert "b" not in BICYCLE.values
    assert BICYCLE.numbers()["b"] == pytest.approx(0.3652 - 0.1461)


def test_inputs_and_start_are_zero_where_nothing_is_said():
    assert MOTOR.held_inputs() == {"u": 1.0, "M": 0.0}
    assert MOTOR.starting_states() == {"i": 0.0, "w": 0.0}
    assert MOTOR.span == 3.0


@pytest.mark.parametrize(
    ("changed", "kind", "said"),
    [
        ({"base": ("R", "Q")}, ModelError, "base names 'Q'"),
        ({"values": {"R": "1 ohm"}}, ModelError, "parameter 'K'.*has no value"),
        ({"values": {**MOTOR.values, "Q": "1"}}, ModelError, "values names 'Q'"),
        ({"values": {**MOTOR.values, "L": "0.5"}}, UnitError, r"L \[H\].*no unit"),
        ({"values": {**MOTOR.values, "L": "0.5 ohm"}}, UnitError, r"L \[H\]"),
        ({"inputs": {"w": "1 rad/s"}}, ModelError, "inputs names 'w'"),
        ({"start": {"u": "1 V"}}, ModelError, "start names 'u'"),
        ({"meanings": {"R": "a base variable has no group"}}, ModelError, "meanings names 'R'"),
        ({"table": {"big": {"Q": "1"}}}, ModelError, "row 'big' of the table names 'Q'"),
        ({"table": {"big": {"R": "1 V"}}}, UnitError, r"R \[ohm\]"),
        ({"duration": "3 m"}, UnitError, "duration: .*'m'"),
        ({"duration": 3}, UnitError, "duration: the value is 3"),
        ({"values": {**MOTOR.values, "L": 0.5}}, UnitError, r"L \[H\]: the value is 0.5"),
        ({"base": "R"}, ModelError, "base is the text 'R'"),
    ],
)
def test_a_part_that_does_not_fit_the_model_is_named(changed, kind, said):
    with pytest.raises(kind, match=said) as caught:
        replace(MOTOR, **changed)
    assert caught.value.paste
