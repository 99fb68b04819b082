"""Slopes of outputs are those of a solution in closed form."""

import mpmath
import numpy as np
import pytest
import sympy as sp

from similitude.errors import ModelError
from similitude.symmetry.arithmetic import DIGITS
from similitude.symmetry.equations import read_equations
from similitude.symmetry.output_slopes import OutputSlopes, gather
from similitude.symmetry.row_space import null_vectors, reduced
from similitude.symmetry.tape import record


def plan(rates, parameters, output, *, signals=()):
    equations = read_equations(rates, parameters, signals=signals, time="t")
    formula = sp.sympify(output, locals={n: sp.Symbol(n, real=True) for n in equations.names})
    tape = record([*equations.rates.values(), formula])
    return OutputSlopes(tape, equations, tuple(parameters), (), 1)


@pytest.mark.parametrize("factor", ["1", "exp(0*t)"])  # in residues, and in long numbers
def test_a_decay_has_the_slopes_of_an_exponential(factor):
    # c x(0) exp(-k t): in logarithms (-k t, 1, 1) times the output, so c and x(0) cannot be told apart
    found = plan({"x": f"-k*x*{factor}"}, ["k", "c"], "c*x")
    with mpmath.workdps(DIGITS):
        rows, _ = found.sensitivities(0)

        assert found.columns == ("k", "c", "x")
        assert len(rows) == 2
        assert [[abs(float(x)) for x in row] for row in rows] == [[1, 0, 0], [0, 1, 1]]


def test_plain_slopes_are_the_logarithmic_ones_over_the_values():
    found = plan({"x": "-(a + b)*x"}, ["a", "b"], "x")
    logarithmic, plain = found.sensitivities(0)

    assert len(logarithmic) == len(plain) == 2
    assert reduced(plain)[0].tolist() == [[1, 1, 0], [0, 0, 1]]  # only the sum of a and b is seen


def test_points_are_added_until_none_brings_anything_new():
    rows = gather(plan({"x": "-(a + b)*x"}, ["a", "b"], "x"))

    assert len(rows.turning) == 2  # the blind direction (1/a, -1/b) turns through the whole plane
    assert len(null_vectors(rows.plain)) == 1
    assert rows.ranks == (3, 2, 2)


def test_inputs_are_no_unknowns():
    found = plan({"x": "u - k*x"}, ["k"], "x", signals=("u",))

    assert found.columns == ("k", "x")
    assert len(found.sensitivities(0)[0]) == 2


def test_what_is_singular_everywhere_is_named():
    with pytest.raises(ModelError, match="singular wherever"):
        plan({"x": "sqrt(-1 - x**2)"}, [], "x").sensitivities(0)


def test_equal_seeds_give_equal_rows():
    found = plan({"x": "-k*x**2"}, ["k"], "x")

    np.testing.assert_array_equal(found.sensitivities(3)[0], found.sensitivities(3)[0])
