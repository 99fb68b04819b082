"""The equations are all there, in order, and name code that exists and says which equation it is."""

import importlib
import inspect
import re

import pytest

from similitude.paper.equations import EQUATIONS


def cited(text):
    """Numbers of the equations that a source names: eq 4, eqs 1-3, eqs 24 to 27, eqs 9, 13 and 16."""
    found = set()
    for phrase in re.findall(r"\beqs? ((?:\d+(?:-\d+| to \d+)?(?:, | and |,? and )?)+)", text):
        for first, last in re.findall(r"(\d+)(?:(?:-| to )(\d+))?", phrase):
            found |= set(range(int(first), int(last or first) + 1))
    return found


def test_none_of_the_thirty_two_is_missing():
    assert [equation.number for equation in EQUATIONS] == list(range(1, 33))


def test_citations_are_read():
    assert cited("eq 4; eqs 1-3 and eqs 24 to 26, eqs 9, 13 and 16.") == {1, 2, 3, 4, 9, 13, 16, 24, 25, 26}


@pytest.mark.parametrize("equation", EQUATIONS, ids=lambda one: f"eq {one.number}")
def test_the_code_that_is_named_exists_and_cites_the_equation(equation):
    assert equation.holder is not None
    module = importlib.import_module(equation.code.rpartition(".")[0])

    assert equation.number in cited(inspect.getsource(module))
