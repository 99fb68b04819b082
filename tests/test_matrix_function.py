"""Functions of a matrix through its characteristic polynomial, against numpy on the full matrix."""

import numpy as np
import pytest
import sympy as sp

from similitude.matrix_function import MatrixFunction


def evaluate(lines, values):
    """Run the statements on numbers."""
    known = dict(values)
    for line in lines:
        replace = {s: known[s.name] for s in line.expression.free_symbols}
        known[line.target] = float(line.expression.subs(replace))
    return known


def symbols(n):
    return sp.Matrix(n, n, lambda i, j: sp.Symbol(f"J_{i}{j}", real=True))


def numbers(n, seed):
    return np.random.default_rng(seed).normal(size=(n, n)) / n


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_a_rational_function_equals_the_same_function_of_the_full_matrix(n):
    of = MatrixFunction(symbols(n))
    inverse = of.inverse(of.named("n", of.reduced([1, -2, sp.Rational(3, 2)])), "i")
    of.matrix(of.product(inverse, of.reduced([1, 1])), "M")
    for seed in range(5):
        J = numbers(n, seed)
        known = evaluate(of.lines, {f"J_{i}{j}": J[i, j] for i in range(n) for j in range(n)})
        M = np.array([[known[f"M_{i}{j}"] for j in range(n)] for i in range(n)])
        one = np.eye(n)
        expected = np.linalg.solve(one - 2 * J + 1.5 * J @ J, one + J)
        condition = np.linalg.cond(one - 2 * J + 1.5 * J @ J)
        np.testing.assert_allclose(M, expected, atol=1e-13 * condition**2)


@pytest.mark.parametrize("n", [1, 2, 3])
def test_a_power_of_any_degree_is_reduced_below_the_size(n):
    of = MatrixFunction(symbols(n))
    reduced = of.reduced([0, 0, 0, 0, 0, 1])
    assert len(reduced) == n
    of.matrix(of.named("q", reduced), "M")
    J = numbers(n, 7)
    known = evaluate(of.lines, {f"J_{i}{j}": J[i, j] for i in range(n) for j in range(n)})
    M = np.array([[known[f"M_{i}{j}"] for j in range(n)] for i in range(n)])
    np.testing.assert_allclose(M, np.linalg.matrix_power(J, 5), atol=1e-13)


def test_zeros_of_a_sparse_matrix_stay_zeros():
    a, b = sp.symbols("a b", real=True)
    of = MatrixFunction(sp.Matrix([[a, 0], [0, b]]))
    M = of.matrix(of.reduced([1, 1]), "M")
    assert M.shape == (2, 2)
    known = evaluate(of.lines, {"a": 2.0, "b": 3.0})
    assert known["M_01"] == known["M_10"] == 0.0
    assert (known["M_00"], known["M_11"]) == (3.0, 4.0)
