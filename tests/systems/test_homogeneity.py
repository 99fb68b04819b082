"""Changing the units finds the term that does not fit, and finds none where all do."""

import pytest
import sympy as sp

from similitude.model import Model, Quantity
from similitude.systems.homogeneity import misfits


@pytest.fixture(autouse=True)
def unchecked(monkeypatch):
    """A Model refuses what is tried here as soon as it is made; the suite is a second route."""
    monkeypatch.setattr(Model, "_check_homogeneity", lambda self: None)


x, F, m, k, L = sp.symbols("x F m k L", real=True)


def model(rate) -> Model:
    position = Quantity("x", "m")
    return Model(
        name="trial",
        states=(position,),
        inputs=(Quantity("F", "N"),),
        outputs=(position,),
        parameters=(Quantity("m", "kg"), Quantity("k", "1/s"), Quantity("L", "m")),
        rates={"x": rate},
        output_map={"x": x},
    )


@pytest.mark.parametrize(
    "rate",
    [
        F / (m * k) - k * x,
        k * sp.sqrt(x**2 + L**2),
        k * L * sp.sin(x / L),
        k * L * sp.asin(x / (10 * L)) * sp.log(2 + x / L),
        sp.Integer(0),
        k * (x + L) ** 3 / (x**2 + L**2),
        sp.Max(k * x, k * L),
    ],
)
def test_a_homogeneous_rate_has_no_misfit(rate):
    assert misfits(model(rate)) == []


@pytest.mark.parametrize(
    ("rate", "term", "base"),
    [
        (F / (m * k) - m * x, "-m*x", "mass"),
        (k * x + x, "x", "time"),
        (k * x + F / m, "F/m", "time"),
        (k * L * sp.sin(x), "L*k*sin(x)", "length"),
        (k * sp.sqrt(x**2 + m**2), "k*sqrt(m**2 + x**2)", "mass"),
        (k * x + k, "k", "length"),
    ],
)
def test_the_term_that_does_not_fit_is_named(rate, term, base):
    found = misfits(model(rate))

    assert {f.term for f in found} == {term} and base in {f.base for f in found}
    assert all(f.where == "dx/dt" and f.term in str(f) for f in found)


def test_powers_are_told():
    (found,) = misfits(model(k * x + x))

    assert (found.base, found.found, found.wanted) == ("time", pytest.approx(0, abs=1e-9), -1)
    assert str(found) == "dx/dt: x scales with time as its power 0, not -1"


def test_what_has_no_real_value_is_not_called_homogeneous():
    with pytest.raises(ArithmeticError, match="no real value"):
        misfits(model(k * L * sp.sqrt(-x / L)))
