"""Zero is said exactly where algebra shows it, as a float where only digits do, and not otherwise."""

import pytest
import sympy as sp

from similitude.invariance.exact_zero import euler_residual, largest_value, proven_zero
from similitude.saturation import Saturation

x, y, z = sp.symbols("x y z", real=True)


@pytest.mark.parametrize(
    "expression",
    [
        sp.Integer(0),
        (x + y) ** 2 - x**2 - 2 * x * y - y**2,
        1 / x - 1 / (x + y) - y / (x * (x + y)),
        sp.sqrt(x * y) * sp.sqrt(x / y) - x,
        sp.sin(x / y) * x - sp.sin(x / y) * (x + y) + y * sp.sin(x / y),
    ],
)
def test_what_is_zero_is_proven(expression):
    assert proven_zero(expression) is sp.Integer(0)


def test_what_is_not_zero_is_handed_back():
    assert proven_zero(x * y - x) == x * y - x
    assert proven_zero(sp.sqrt(x**2) + x) == sp.Abs(x) + x


def test_what_only_digits_show_is_a_float():
    hidden = sp.atan(x) + sp.atan(1 / x) - sp.pi / 2  # for positive x

    assert isinstance(proven_zero(hidden), sp.Float)


def test_values_are_relative_to_the_largest_term():
    near = x * y - x * sp.sin(y + 1) / sp.sin(y + 1 + sp.Rational(1, 10**9)) * y

    assert 0 < largest_value(near) < 1e-7
    assert largest_value(sp.log(-x)) is None


@pytest.mark.parametrize(
    ("formula", "weights", "weight"),
    [
        (7 * x**2 + 2 * y**2, (1, 1), 2),
        ((x**2 + y**2) / (x - y) + x, (1, 1), 1),
        (sp.pi * x / (sp.sqrt(2) * y + x), (1, 1), 0),
        (sp.sqrt(x**2 + y**2) * sp.sin(x / y), (1, 1), 1),
        (x * Saturation(x / y), (1, 1), 1),
        (x**2.5 / y**0.5, (2, 2), 4),
    ],
)
def test_eulers_identity_holds_exactly_for_what_is_homogeneous(formula, weights, weight):
    given = dict(zip((x, y), map(sp.Integer, weights), strict=True))

    assert euler_residual(formula, given, sp.Integer(weight)) == 0
    assert euler_residual(formula, given, sp.Integer(weight + 1)) != 0
