"""A tape evaluates what SymPy evaluates, with the slopes SymPy differentiates."""

import numpy as np
import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.saturation import Saturation
from similitude.symmetry.arithmetic import Floats, run
from similitude.symmetry.tape import record

x, y = sp.symbols("x y", real=True)
AT = {x: 0.7, y: 1.2}
EXPRESSIONS = [
    x**2 / y + x**-3, (x + y) ** 7, sp.sqrt(x + y) ** 3, x**y, sp.exp(-x / y), sp.log(x * y),
    sp.sin(x) * sp.cos(y),
    sp.tan(x), sp.tanh(x * y), sp.sinh(x) + sp.cosh(y), sp.asin(x / 2) + sp.acos(y / 3), sp.atan2(y, x),
    sp.Abs(x - y), sp.Max(x, y) * sp.Min(x, y, 3), sp.sign(x - y) * x, sp.pi * x, sp.Float("0.1") * x,
]  # fmt: skip


@pytest.mark.parametrize("e", EXPRESSIONS, ids=str)
def test_values_and_slopes_are_those_of_the_expression(e):
    point = {"x": np.array([AT[x], 1, 0]), "y": np.array([AT[y], 0, 1])}
    expected = [e, e.diff(x), e.diff(y)]

    got = run(record([e]), Floats(), point)[0]

    plain = [sp.N(part.doit().subs(AT)) for part in expected]
    assert got == pytest.approx([float(p) for p in plain], rel=1e-12)


def test_a_function_that_spells_itself_out_is_run_as_what_it_spells():
    e = Saturation(x * y)
    got = run(record([e]), Floats(), {"x": np.array([0.7, 1]), "y": np.array([1.2, 0])})[0]

    assert got[0] == pytest.approx(float(e.doit().subs(AT)))


def test_nothing_is_written_twice():
    tape = record([(x + y) ** 2, 1 / (x + y) ** 2, (x + y) ** 4])

    assert sum(kind == "add" for kind, _, _ in tape.steps) == 1
    assert tape.rational


def test_what_is_not_rational_says_so():
    assert not record([sp.sqrt(x)]).rational
    assert not record([sp.exp(x)]).rational
    assert not record([sp.pi * x]).rational


def test_an_undefined_function_is_named():
    with pytest.raises(ModelError, match="is not known"):
        record([sp.Function("f")(x)])


def test_branches_are_rational_once_they_are_chosen():
    tape = record([Saturation(x) + sp.Max(x, y)])

    assert tape.rational
    assert tape.branches
