"""Functions spelt as statements against the mathematics library, over the ranges stated here."""

import math

import numpy as np
import pytest
import sympy as sp

from similitude.elementary import spelt_functions
from similitude.program.text import PYTHON, C, expression_text

x = sp.Symbol("x", real=True)
CASES = [
    (sp.sin(x), math.sin, -100, 100),
    (sp.cos(x), math.cos, -100, 100),
    (sp.tan(x), math.tan, -1.4, 1.4),
    (sp.exp(x), math.exp, -39, 39),
    (sp.log(x), math.log, 1e-10, 1e10),
    (sp.sqrt(x), math.sqrt, 1e-10, 1e10),
    (x ** sp.Rational(-3, 2), lambda v: v**-1.5, 1e-6, 1e6),
    (x ** sp.Rational(1, 3), lambda v: v ** (1 / 3), 1e-6, 1e6),
    (sp.tanh(x), math.tanh, -30, 30),
    (sp.sinh(x), math.sinh, -10, 10),
    (sp.cosh(x), math.cosh, -10, 10),
    (sp.atan(x), math.atan, -50, 50),
    (sp.Abs(x), abs, -3, 3),
    (sp.sqrt(sp.sin(x) + 2).diff(x), lambda v: math.cos(v) / 2 / math.sqrt(2 + math.sin(v)), -3, 3),
]


def evaluator(expression):
    lines, named = spelt_functions({"f": expression})
    text = "\n".join(f"{line.target} = {expression_text(line.expression, PYTHON)}" for line in lines)
    code = compile(f"{text}\nf = {expression_text(named['f'], PYTHON)}", "spelt", "exec")

    def value(at):
        names = {"x": float(at)}
        exec(code, names)
        return names["f"]

    return value


@pytest.mark.parametrize(("expression", "truth", "low", "high"), CASES, ids=[str(c[0]) for c in CASES])
def test_a_spelt_function_is_the_function(expression, truth, low, high):
    value = evaluator(expression)
    for at in np.geomspace(low, high, 200) if low > 0 else np.linspace(low, high, 201):
        assert value(at) == pytest.approx(truth(at), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("expression", [c[0] for c in CASES], ids=str)
def test_results_are_finite_whatever_the_argument(expression):
    value = evaluator(expression)

    assert all(math.isfinite(value(at)) for at in (-1e300, -1.0, -0.0, 0.0, 1e-300, 1e300))


def test_what_is_not_elementary_is_left_alone_and_c_can_be_printed():
    lines, named = spelt_functions({"f": x**2 + 1})
    assert lines == [] and named["f"] == x**2 + 1

    lines, named = spelt_functions({"f": sp.sin(x) * sp.sqrt(x)})
    assert all(expression_text(line.expression, C) for line in lines)


def test_the_kink_of_a_size_has_no_peak():
    _, named = spelt_functions({"f": sp.Abs(x).diff(x, 2)})

    assert named["f"] == 0 or not named["f"].has(sp.DiracDelta)
