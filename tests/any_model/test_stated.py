"""Numbers, drives and doubts as a user writes them, right and wrong."""

import numpy as np
import pytest

from similitude import shipped_system
from similitude.any_model.stated import doubts_of, drive_of, number_of, numbers_of
from similitude.errors import SimilitudeError, UnitError, UsageError

RLC = shipped_system("rlc_circuit").model
AIR = shipped_system("aircraft_short_period").model


def test_text_with_a_unit_and_si_are_the_same():
    assert number_of("step", "20 us", "s") == pytest.approx(number_of("step", 2e-5, "s"))
    assert number_of("model_error", "1 %", "1") == pytest.approx(0.01)


def test_a_signal_takes_the_users_value_before_the_systems():
    own = shipped_system("aircraft_short_period").numbers()

    assert numbers_of(AIR, "signals", None, wanted=("V",), own=own)["V"] == pytest.approx(53.6, abs=0.1)
    assert numbers_of(AIR, "signals", {"V": "80 m/s"}, wanted=("V",), own=own) == {"V": 80.0}


def test_doubts_are_read_in_the_units_of_input_and_output():
    told = doubts_of(RLC, "100 mV", {"output_bias": "5 mV", "model_error": "0.5 %", "drift": "0.2 % in 4 s"})

    assert (told.noise, told.output_bias, told.model_error, told.drift) == pytest.approx(
        (0.1, 0.005, 0.005, 0.001)
    )
    assert told.disturbance is None


@pytest.mark.parametrize(
    ("call", "kind", "said"),
    [
        (lambda: number_of("step", "10 m", "s"), UnitError, "step:"),
        (lambda: number_of("step", "-1 s", "s"), UsageError, "is not above 0"),
        (lambda: number_of("step", float("nan"), "s"), UsageError, "is not above 0"),
        (lambda: drive_of(np.zeros(100), RLC), UsageError, "all zero"),
        (lambda: drive_of(np.ones((100, 2)), RLC), UsageError, r"shape \(100, 2\)"),
        (lambda: drive_of("sine", RLC), UsageError, "drive has shape"),
        (lambda: doubts_of(RLC, 0.1, {"drift": "5 %"}), UnitError, "how much in which time"),
        (lambda: doubts_of(RLC, 0.1, {"bias": 1}), UsageError, "doubts names 'bias'"),
        (lambda: numbers_of(AIR, "signals", None, wanted=("V",), own={}), UsageError, "no usual value"),
        (lambda: numbers_of(RLC, "start", {"x": 1}, wanted=(), own={}), UsageError, "start names 'x'"),
    ],
)
def test_what_is_wrong_is_named(call, kind, said):
    with pytest.raises(kind, match=said) as raised:
        call()
    assert isinstance(raised.value, SimilitudeError) and raised.value.paste and raised.value.read
