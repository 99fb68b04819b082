"""Elimination in straight-line statements against NumPy's solver."""

import numpy as np
import pytest
import sympy as sp

from similitude.estimators.elimination import eliminated
from similitude.program.ir import Assign, When
from similitude.program.symmetric import Symmetric

N = 4


def run(A, q, psi, least):
    """Values after the statements, and whether the innermost was reached."""
    names = Symmetric("A", N)
    values = {names.target(i, j): A[i, j] for i in range(N) for j in range(i, N)}
    values |= {f"q{i}": q[i] for i in range(N)} | {f"p{i}": psi[i] for i in range(N)}
    symbols = [[sp.Symbol(f"{letter}{i}", real=True) for i in range(N)] for letter in "qp"]
    reached = (Assign("reached", sp.Integer(1)),)
    _execute(eliminated(names, *symbols, [sp.Float(x) for x in least], reached), values)
    return values


def _execute(body, values):
    def value(e):
        return e.subs({s: values[s.name] for s in e.free_symbols})

    for s in body:
        if isinstance(s, When):
            _execute(s.body if value(s.condition) else s.otherwise, values)
        else:
            assert isinstance(s, Assign)
            values[s.target] = float(value(s.expression))


@pytest.mark.parametrize("seed", range(3))
def test_it_solves_the_system(seed):
    rng = np.random.default_rng(seed)
    X = rng.standard_normal((9, N))
    A, q, psi = X.T @ X, rng.standard_normal(N), rng.standard_normal(N)
    found = run(A, q, psi, [0.0] * N)
    solution = np.linalg.solve(A, q)

    assert found["reached"] == 1
    assert found["z_3"] / found["d_3"] == pytest.approx(solution[3], rel=1e-9)
    assert sum(found[f"part_{i}"] for i in range(N)) == pytest.approx(solution @ psi, rel=1e-9)
    rest = psi[3] - A[3, :3] @ np.linalg.solve(A[:3, :3], psi[:3])
    assert found["w_3"] == pytest.approx(rest, rel=1e-9)
    assert 1 / found["d_3"] == pytest.approx(np.linalg.inv(A)[3, 3], rel=1e-9)


@pytest.mark.parametrize("at", range(N))
def test_a_small_pivot_stops_before_the_division(at):
    X = np.random.default_rng(5).standard_normal((9, N))
    X[:, at] = X[:, at - 1] * 2 if at else 0.0
    found = run(X.T @ X, np.ones(N), np.ones(N), [1e-9] * N)

    assert "reached" not in found
    assert all(np.isfinite(x) for x in found.values())
