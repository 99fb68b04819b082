"""Every fault of a formula is said in four parts, with what was typed in the first."""

import inspect

import pytest

from similitude import model_text_faults as faults
from similitude.errors import ModelError

GIVEN = {
    "what": "the rate of 'S'", "text": "2 S", "at": 2, "name": "gama", "names": ["gamma"],
    "functions": ["exp"], "given": 3, "wanted": 1, "part": "I", "digits": 3000, "deepest": 100,
    "power": 400, "highest": 100,
    "found": "S", "before": "2",
}  # fmt: skip
MAKERS = [
    made for name, made in vars(faults).items() if inspect.isfunction(made) and not name.startswith("_")
    if made.__module__ == faults.__name__
]  # fmt: skip


@pytest.mark.parametrize("make", MAKERS, ids=lambda made: made.__name__)
def test_a_fault_has_four_parts_and_names_the_formula(make):
    error = make(*(GIVEN[name] for name in inspect.signature(make).parameters))

    assert isinstance(error, ModelError)
    assert error.what.startswith("the rate of 'S'")
    assert all(part and "\n" not in part for part in (error.usually, error.paste, error.read))


def test_two_factors_in_a_row_are_answered_with_their_product():
    assert faults.cannot_go_on("it", "2 S", 2, "S", "2").paste == "2*S"
