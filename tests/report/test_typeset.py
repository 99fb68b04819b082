"""Names and formulas as people read them, each still told from every other."""

from fractions import Fraction

import pytest
import sympy as sp

from similitude.report.typeset import (
    math,
    math_product,
    math_rate,
    parts_of,
    plain_formula,
    plain_name,
    plain_product,
)

x, pi1, delta, mu = sp.symbols("x pi1 delta mu", real=True)


@pytest.mark.parametrize(
    ("name", "parts"),
    [
        ("pi3", ("π", "3")), ("pi", ("pi", "")), ("Caf", ("C", "af")), ("k_on", ("k", "on")),
        ("delta", ("δ", "")), ("mu", ("mu", "")), ("UA", ("UA", "")), ("k1", ("k", "1")),
        ("Iz", ("I", "z")), ("theta_2", ("θ", "2")),
        ("t_", ("t_", "")), ("_x", ("_x", "")), ("omega", ("ω", "")), ("sigma", ("σ", "")), ("x", ("x", "")),
    ],
)  # fmt: skip
def test_a_letter_and_its_index(name, parts):
    assert parts_of(name) == parts


def test_names_of_a_model_stay_different():
    names = ["pi1", "pi10", "Caf", "Car", "k1", "k_1x", "delta", "deltas", "mu", "ms", "Delta"]

    assert len({plain_name(n) for n in names}) == len(names)
    assert plain_name("pi3") == "π₃"
    assert plain_name("v", ["v"]) == "v*"


def test_formulas_on_one_line():
    assert plain_formula(pi1**2 * x - delta / mu, ["x"]) == "-δ/mu + π₁²·x*"
    assert plain_formula(x ** sp.Rational(1, 2)) == "sqrt(x)"
    assert plain_formula(pi1**10 * sp.sin(2 * x)) == "π₁¹⁰·sin(2·x)"
    assert plain_product({"Caf": Fraction(1), "m": Fraction(-1), "U": Fraction(-2)}) == "Caf/(m U²)"


def test_markup_of_products_and_rates():
    quotient = "<mrow><mfrac><mi>x</mi><msub><mi>π</mi><mn>1</mn></msub></mfrac></mrow>"
    product = math_product({"x": Fraction(1), "pi1": Fraction(-1)})
    assert product == f'<math displaystyle="true">{quotient}</math>'
    assert "<msubsup><mi>v</mi><mn>1</mn><mo>*</mo></msubsup>" in math_rate("v1", ["v1"])
    assert "<mo>−</mo>" in math(pi1 - x)
