"""One input and one output; others are zero, and none is chosen silently."""

import pytest

from similitude import shipped_system
from similitude.any_model.one_channel import one_channel
from similitude.errors import UsageError

MOTOR = shipped_system("dc_motor").model


def test_the_other_input_is_zero_and_a_state_may_be_measured():
    one = one_channel(MOTOR, input="u", output="i")

    assert [q.name for q in (*one.inputs, *one.outputs)] == ["u", "i"]
    assert "M" not in {s.name for e in one.rates.values() for s in e.free_symbols}


@pytest.mark.parametrize("given", [{}, {"input": "v"}, {"input": "u", "output": "x"}])
def test_a_choice_nobody_made_is_asked_for(given):
    with pytest.raises(UsageError, match=r"there are .*\["):
        one_channel(MOTOR, **given)
