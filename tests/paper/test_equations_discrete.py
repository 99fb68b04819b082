"""Every equation of its part fails by no more than its tolerance."""

from dataclasses import replace

import pytest

from similitude.estimators.paper_model import regression
from similitude.paper import equations_discrete
from similitude.paper.equations_discrete import TABLE


@pytest.mark.parametrize("row", TABLE, ids=lambda row: f"eq {row[0]}")
def test_the_equation_holds_in_the_code_that_is_named(row):
    tolerance = row[4] if len(row) > 4 else 1e-9

    assert row[3]() <= tolerance


@pytest.mark.parametrize("which", ["numerator", "denominator"])
def test_another_line_would_be_found(monkeypatch, which):
    """Eq 23, m1 or m2 off by a thousandth."""

    def wrong(reduction):
        right = regression(reduction)
        return replace(right, **{which: 1.001 * getattr(right, which)})

    monkeypatch.setattr(equations_discrete, "regression", wrong)
    assert equations_discrete._with_its_lines() > 1e-4


def test_what_is_left_of_the_line_falls_as_the_square_of_the_step(monkeypatch):
    monkeypatch.setattr(equations_discrete, "SMALL_T", 2e-3)
    twice = equations_discrete._with_its_lines()
    monkeypatch.setattr(equations_discrete, "SMALL_T", 1e-3)

    assert twice / equations_discrete._with_its_lines() == pytest.approx(4, rel=0.02)
