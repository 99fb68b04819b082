"""Matrices and transfer functions of models, in symbols."""

import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.linear.matrices import linear_parts, transfer_function
from similitude.model import Model
from similitude.systems.bicycle import BICYCLE, Caf, Car, Iz, L, U, a, b, m
from similitude.systems.saturating_bicycle import SATURATING_BICYCLE

s = sp.Symbol("s")


def test_the_transfer_function_of_the_paper():
    """Section 2, with L = a + b."""
    damping = (Caf + Car) / (m * U) + (a**2 * Caf + b**2 * Car) / (Iz * U)
    stiffness = Caf * Car * L**2 / (m * Iz * U**2) - (a * Caf - b * Car) / Iz
    paper = (a * Caf / Iz * s + Caf * Car * L / (m * Iz * U)) / (s**2 + damping * s + stiffness)

    assert sp.cancel(transfer_function(BICYCLE) - paper.subs(L, a + b)) == 0


def test_a_model_that_is_not_linear_says_so():
    assert linear_parts(BICYCLE).is_linear and not linear_parts(SATURATING_BICYCLE).is_linear


def test_names_that_are_not_there_are_refused():
    with pytest.raises(ModelError, match=r"no output q \(there are r\)"):
        transfer_function(BICYCLE, output="q")
    with pytest.raises(ModelError, match="has no state"):
        linear_parts(Model("none", [], [], [], [], {}, {}))
