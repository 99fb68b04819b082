"""The matrices of a linear model, or of one linearised, and its transfer functions, in symbols.

    x' = A x + B u        A = df/dx, B = df/du         G(s) = N(s)/M(s)
    y  = C x + D u        C = dg/dx, D = dg/du         M = det(sI - A), N = det [sI - A, B; -C, D]

Of a model that is not linear they hold the states and inputs of the operating point.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from similitude.errors import ModelError
from similitude.model import Model


@dataclass(frozen=True)
class LinearParts:
    """A (n, n), B (n, m), C (p, n), D (p, m) in the model's symbols; ``is_linear`` where no state or
    input is left in them."""

    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix
    C: sp.ImmutableMatrix
    D: sp.ImmutableMatrix
    is_linear: bool


def linear_parts(model: Model, *, outputs: Sequence[sp.Expr] | None = None) -> LinearParts:
    """Jacobians of a model's rates and outputs.

    Parameters
    ----------
    model : n states, m inputs.
    outputs : p formulas in place of the model's outputs.

    Raises
    ------
    ModelError    the model has no state.
    """
    if not model.states:
        raise ModelError(
            f"model {model.name!r} has no state",
            usually="It is a relation, not a system that moves.",
            paste="euler_rows(expression, quantities)",
            read='docs/invariances.md, "Any homogeneous function"',
        )
    x, u = [q.symbol for q in model.states], [q.symbol for q in model.inputs]
    f = sp.Matrix([model.rates[q.name] for q in model.states])
    g = sp.Matrix([model.output_map[q.name] for q in model.outputs] if outputs is None else list(outputs))
    parts = [
        sp.ImmutableMatrix(len(m), len(v), lambda i, j, m=m, v=v: sp.diff(m[i], v[j]))
        for m, v in ((f, x), (f, u), (g, x), (g, u))
    ]
    left = set().union(*(part.free_symbols for part in parts))
    return LinearParts(*parts, is_linear=not left & {*x, *u})


def transfer_function(
    model: Model, *, output: str | None = None, input: str | None = None, s: sp.Symbol | None = None
) -> sp.Expr:
    """G(s) from one input to one output, in symbols, as numerator over characteristic polynomial.

    Parameters
    ----------
    model : linear, or not; then G holds states and inputs of the operating point.
    output, input : names; the first where they are left out.
    s : the Laplace variable; ``Symbol("s")`` where it is left out.

    Raises
    ------
    ModelError    no output or input of that name.
    """
    names = [q.name for q in model.outputs], [q.name for q in model.inputs]
    places = []
    for kind, wanted, known in zip(("output", "input"), (output, input), names, strict=True):
        if not known or wanted not in (None, *known):
            raise ModelError(
                f"model {model.name!r} has no {kind} {wanted or ''} (there are {', '.join(known) or 'none'})",
                usually="The name was misspelt, or the model has none.",
                paste=f"transfer_function(model, {kind}={(known or ['u'])[0]!r})",
                read='docs/model.md, "Linear models"',
            )
        places.append(0 if wanted is None else known.index(wanted))
    N, M = transfer_polynomials(linear_parts(model), *places, s or sp.Symbol("s"))
    return N / M


def transfer_polynomials(
    parts: LinearParts, output: int, given: int, s: sp.Symbol
) -> tuple[sp.Expr, sp.Expr]:
    """Numerator and characteristic polynomial of one output to one input, expanded in s, M monic."""
    n = parts.A.rows
    M = (s * sp.eye(n) - parts.A).det(method="berkowitz")
    block = sp.Matrix(n + 1, n + 1, lambda i, j: _bordered(parts, output, given, s, i, j))
    N = block.det(method="berkowitz")
    return _in_powers(N, s), _in_powers(M, s)


def _in_powers(polynomial: sp.Expr, s: sp.Symbol) -> sp.Expr:
    return sp.Add(*(c * s**k for k, c in enumerate(reversed(sp.Poly(polynomial, s).all_coeffs()))))


def _bordered(parts: LinearParts, output: int, given: int, s: sp.Symbol, i: int, j: int) -> sp.Expr:
    n = parts.A.rows
    if i < n and j < n:
        return (s if i == j else 0) - parts.A[i, j]
    if i < n:
        return parts.B[i, given]
    return -parts.C[output, j] if j < n else parts.D[output, given]
