"""The written-out covariance against the matrix formulas of numpy."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from similitude.program.ir import Assign
from similitude.program.symmetric import Shared, Symmetric, column, predict, reduce_by

from ..run_statements import run_statements

sizes = st.integers(1, 6)
seeds = st.integers(0, 2**32 - 1)


def random_covariance(rng, n):
    root = rng.standard_normal((n, n)) * np.exp(rng.normal(0, 1, (n, 1)))
    return root @ root.T


def stored(P: Symmetric, matrix) -> dict[str, float]:
    return {P.target(i, j): float(matrix[i, j]) for i in range(P.n) for j in range(i, P.n)}


def unstored(P: Symmetric, values) -> np.ndarray:
    return np.array([[values[P.target(i, j)] for j in range(P.n)] for i in range(P.n)])


def assert_close(found, expected):
    """1e-12 of the largest entry: sums of at most 7 x 7 products, 50 roundings, cancelling or not."""
    assert np.abs(found - expected).max() <= 1e-12 * np.abs(expected).max()


@given(sizes)
def test_the_triangle_is_stored_row_by_row_without_holes(n):
    P = Symmetric("P", n)
    order = [P.index(i, j) for i in range(n) for j in range(i, n)]

    assert order == list(range(P.size))
    assert all(P.index(i, j) == P.index(j, i) for i in range(n) for j in range(n))
    assert len(P.field("-", "").symbols) == P.size
    assert {P.target(i, j) for i in range(n) for j in range(n)} == {s.name for s in P.field("-", "").symbols}


@settings(max_examples=20, deadline=None)
@given(sizes, st.integers(1, 3), seeds)
def test_predict_is_F_P_F_plus_Q(slow, fast, seed):
    """Dynamic rows dense; columns fast, fast + 1 proportional in them; slow states decay."""
    rng = np.random.default_rng(seed)
    n = fast + slow
    together = range(fast, min(fast + 2, n))
    F, entries = np.eye(n), rng.standard_normal(fast)
    F[:fast] = rng.standard_normal((fast, n))
    weight = {k: rng.standard_normal() for k in together}
    for k, w in weight.items():
        F[:fast, k] = entries * w
    decay = {k: rng.uniform(0, 1) for k in range(fast, n) if rng.random() < 0.5}
    for k, keep in decay.items():
        F[k, k] = keep
    noise = {k: rng.uniform(0, 1) for k in range(n) if rng.random() < 0.5}
    before, P = random_covariance(rng, n), Symmetric("P", n)
    own = [k for k in range(n) if k not in weight]

    lines = predict(
        P,
        {i: {k: sp.Float(F[i, k], 17) for k in own} for i in range(fast)},
        Shared(
            {k: sp.Float(w, 17) for k, w in weight.items()},
            {i: sp.Float(e, 17) for i, e in enumerate(entries)},
        ),
        decay={k: sp.Float(v, 17) for k, v in decay.items()},
        noise={k: sp.Float(v, 17) for k, v in noise.items()},
    )

    Q = np.diag([noise.get(i, 0.0) for i in range(n)])
    assert_close(unstored(P, run_statements(lines, stored(P, before))), F @ before @ F.T + Q)
    targets = [s.target for s in lines if s.target.startswith("P_") or s.target == "P"]
    dense = {P.target(i, j) for i in range(fast) for j in range(fast)}
    slow = [target for target in targets if target not in dense]
    assert len(slow) == len(set(slow))  # only what the dynamic states share is summed up in place


def test_what_is_worked_out_beside_a_column_sees_it_as_it_was():
    P, f = Symmetric("P", 3), sp.Rational(1, 2)
    before = random_covariance(np.random.default_rng(1), 3)

    def beside(j, FP):
        return [Assign(f"was_{j}", P[0, j]), Assign(f"FP_of_{j}", FP[0])]

    rows = {0: {0: f, 1: sp.Integer(2), 2: sp.Integer(3)}}
    lines = predict(P, rows, Shared({}, {0: sp.Integer(0)}), decay={1: f}, noise={}, beside=beside)

    done = run_statements(lines, stored(P, before))
    for j in range(3):
        assert done[f"was_{j}"] == before[0, j]
        assert done[f"FP_of_{j}"] == pytest.approx(np.array([0.5, 2.0, 3.0]) @ before[:, j])


@settings(max_examples=30, deadline=None)
@given(sizes, seeds)
def test_reduce_by_is_the_joseph_form_of_gains_that_are_optimal_or_zero(n, seed):
    rng = np.random.default_rng(seed)
    before, P = random_covariance(rng, n), Symmetric("P", n)
    H, R = rng.standard_normal(n), rng.uniform(0.1, 2)
    considered = {i for i in range(n) if rng.random() < 0.3}
    order = {i: int(rng.integers(0, 3)) for i in range(n) if i not in considered}
    closed = rng.integers(0, 4)  # gains of this order and higher are zero in this sample
    S = H @ before @ H + R
    on = np.array([float(i in order and order[i] < closed) for i in range(n)])
    c = before @ H
    K = on * c / S

    gains = {i: sp.Symbol(f"gain_{i}", real=True) for i in order}
    gradient = {i: sp.Float(H[i], 17) for i in range(n)}
    lines = [*column(P, gradient, "c"), *reduce_by(P, gains, order, "c")]
    values = stored(P, before) | {f"gain_{i}": K[i] for i in order}

    A = np.eye(n) - np.outer(K, H)
    after = run_statements(lines, values)
    assert_close([after[f"c_{i}"] for i in range(n)], c)
    assert_close(unstored(P, after), A @ before @ A.T + R * np.outer(K, K))


def test_a_held_coordinate_keeps_its_variance():
    P = Symmetric("P", 3)
    lines = reduce_by(P, {0: sp.Symbol("g", real=True)}, {0: 0}, "c")

    assert {s.target for s in lines} == {P.target(0, j) for j in range(3)}
    assert P.target(1, 1) == "P_3" and P[1, 2] == P[2, 1]
    with pytest.raises(IndexError):
        P.target(2, 3)
