"""Every equation of its part fails by no more than its tolerance."""

import pytest
import sympy as sp

from similitude.estimators.paper_model import proportional_matrices
from similitude.paper import equations_model
from similitude.paper.equations_model import TABLE
from similitude.simulation.lqr import path_matrices


@pytest.mark.parametrize("row", TABLE, ids=lambda row: f"eq {row[0]}")
def test_the_equation_holds_in_the_code_that_is_named(row):
    tolerance = row[4] if len(row) > 4 else 1e-9

    assert row[3]() <= tolerance


def test_another_matrix_would_be_found(monkeypatch):
    """Eq 2, one entry of A or B off by a thousandth."""
    for place in ((1, 2), (3, 1), (3, 3)):

        def wrong(*given, place=place):
            A, B = path_matrices(*given)
            A[place] *= 1.001
            return A, B

        monkeypatch.setattr(equations_model, "path_matrices", wrong)
        assert equations_model._matrices() > 1e-4


def test_another_transfer_function_would_be_found(monkeypatch):
    """Eq 20, the slope of the rear axle taken to be that of the front."""

    def wrong(*given, **named):
        slope = sp.Symbol("pi4_slope", real=True)
        return tuple(M.subs(slope, 1) for M in proportional_matrices(*given, **named))

    monkeypatch.setattr(equations_model, "proportional_matrices", wrong)
    assert equations_model._slope_taken_out() == 1
