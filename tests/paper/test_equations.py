"""The equations are all there, in order, and name code that exists and says which equation it is."""

import importlib
import inspect

import pytest

from similitude.paper.equations import EQUATIONS


def test_none_of_the_thirty_two_is_missing():
    assert [equation.number for equation in EQUATIONS] == list(range(1, 33))


@pytest.mark.parametrize("equation", EQUATIONS, ids=lambda one: f"eq {one.number}")
def test_the_code_that_is_named_exists_and_speaks_of_equations(equation):
    assert equation.holder is not None
    module = importlib.import_module(equation.code.rpartition(".")[0])

    assert "eq" in inspect.getsource(module)
