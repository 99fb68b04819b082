"""The program that Eva is given bounds every number and asks for every number."""

import re

import pytest

from similitude.embedded.configuration import find_numbers
from similitude.embedded.finiteness import finite_text
from similitude.embedded.state_bounds import BOUNDS
from similitude.embedded.system import find_source
from similitude.program.library import shipped

CONSTANT = {"paper": set(), "band": {"input_gain", "damping"}}


def elements(rows):
    return {name if size == 1 else f"{name}[{i}]" for name, _, _, size in rows for i in range(size)}


@pytest.mark.parametrize("estimator", sorted(BOUNDS))
def test_the_program_bounds_every_state_that_a_step_writes_and_asks_for_every_number(estimator):
    library = shipped(f"bicycle_{estimator}")
    config = find_numbers(find_source("bicycle", estimator), vehicle=None, sample_time=None).values
    text = finite_text(library, config, BOUNDS[estimator](library, config))
    number = r"(\w+(?:\[\d+\])?)"
    set_ = re.findall(rf"state\.{number} = Frama_C", text)
    asked = re.findall(rf"is_finite\((?:state|output)\.{number}\)", text)

    assert elements(library.layout.STATE) - set(set_) == CONSTANT[estimator]
    assert len(asked) == len(elements(library.layout.STATE)) + len(elements(library.layout.OUTPUT))
