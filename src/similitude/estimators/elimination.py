"""A small symmetric system of normal equations solved in straight-line statements.

    A = L D L',   z = L^-1 q,   w = L^-1 psi
    what the last unknown is:      z_n/d_n        what the others leave of its regressor:  w_n
    what all together explain:     sum of z_i w_i/d_i

So the unknown that is asked for stands last, and no back-substitution is needed.

Invariant: each pivot is checked against its least before anything is divided by it.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.estimators.held_sample import S
from similitude.program.ir import Assign, Statement, When
from similitude.program.symmetric import Symmetric


def eliminated(
    A: Symmetric,
    q: Sequence[sp.Symbol],
    psi: Sequence[sp.Expr],
    least: Sequence[sp.Expr],
    then: tuple[Statement, ...],
) -> tuple[Statement, ...]:
    """Guards and statements that solve the system and, where every pivot is sound, run ``then``.

    Parameters
    ----------
    A : Symmetric    (n, n) normal matrix, the unknown that is asked for last.
    q : (n,) right-hand side.
    psi : (n,) regressor of this sample.
    least : (n,) least pivot d_i that is sound, > 0.
    then : statements that may read ``z_i``, ``w_i``, ``d_i`` and ``part_i`` = z_i w_i/d_i.
    """
    n = A.n
    inner: tuple[Statement, ...] = then
    for i in reversed(range(n)):
        lines: list[Statement] = []
        for k in range(i):
            reduced = A[i, k] - sp.Add(*(S(f"l_{i}{j}") * S(f"u_{k}{j}") for j in range(k)))
            lines += [Assign(f"u_{i}{k}", reduced), Assign(f"l_{i}{k}", S(f"u_{i}{k}") * S(f"inv_d_{k}"))]
        pivot = A[i, i] - sp.Add(*(S(f"l_{i}{j}") * S(f"u_{i}{j}") for j in range(i)))
        lines.append(Assign(f"d_{i}", pivot))
        sound = (
            Assign(f"inv_d_{i}", 1 / S(f"d_{i}")),
            Assign(f"z_{i}", q[i] - sp.Add(*(S(f"l_{i}{j}") * S(f"z_{j}") for j in range(i)))),
            Assign(f"w_{i}", psi[i] - sp.Add(*(S(f"l_{i}{j}") * S(f"w_{j}") for j in range(i)))),
            Assign(f"part_{i}", S(f"z_{i}") * S(f"w_{i}") * S(f"inv_d_{i}")),
            *inner,
        )
        text = "every unknown is carried" if i == n - 1 else ""
        inner = (*lines, When(S(f"d_{i}") > least[i], sound, (), text))
    return inner
