"""One implicit second-order step of x' = f(x, p), with its Jacobians, as symbols.

    N = I - hJ + (hJ)^2/2,      G = h N^-1 (I - hJ/2),      x+ = x + G f(x)

For a linear f this is the (0,2) Pade approximant of exp(hJ): second order, L-stable, exact at
steady state, one small inverse; for a nonlinear f with J = df/dx it stays second order
(Rosenbrock form). The Jacobians are those of the same step: dx+/dx = N^-1, dx+/dp = G df/dp

(taken with df/dp at the start of the step, which leaves dx+/dp exact at steady state).
Invariant: no branch, no sub-steps; bounded for any h and any stable J, sign-right as h -> infinity.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from similitude.program.ir import Assign, shared

h = sp.Symbol("h", real=True)  # dimensionless length of the step [-]


@dataclass(frozen=True)
class ImplicitStep:
    """Statements and where their results stand.

    ``after`` (n,) the states after the step; ``by_state`` (n, n) = dx+/dx;
    ``by_parameter`` parameter name -> (n,) = dx+/dp.
    """

    statements: tuple[Assign, ...]
    after: sp.Matrix
    by_state: sp.Matrix
    by_parameter: dict[str, sp.Matrix]


def implicit_step(
    rates: Sequence[sp.Expr], states: Sequence[sp.Symbol], *, parameters: Mapping[str, sp.Expr]
) -> ImplicitStep:
    """Derive the step for the given rates.

    Parameters
    ----------
    rates : (n,) dx/dt* in states and anything else [-].
    states : (n,) symbols of the states before the step.
    parameters : name -> dp/d(coordinate), for each symbol whose sensitivity is wanted.

    Returns
    -------
    ImplicitStep    statements to be placed after ``h`` is assigned.
    """
    n = len(states)
    f = sp.Matrix(rates)
    J = f.jacobian(sp.Matrix(states))
    hJ = _matrix(n, "J", lambda i, j: J[i, j] != 0)
    lines = _shared(f, J, states, parameters) + _inverse(hJ, n)
    M, G = (_matrix(n, letter, lambda i, j: True) for letter in "MG")
    rate = sp.Matrix([sp.Symbol(f"f_{x.name}", real=True) for x in states])
    change = sp.Matrix([sp.Symbol(f"d_{x.name}", real=True) for x in states])
    lines += [
        Assign(f"d_{x.name}", (G * rate)[i], "change over the step [-]")
        for i, x in enumerate(states)
    ]
    by_parameter = {}
    for name in parameters:
        inner = sp.Matrix([sp.Symbol(f"f_{x.name}_{name}", real=True) for x in states])
        lines += [Assign(f"F_{x.name}_{name}", (G * inner)[i]) for i, x in enumerate(states)]
        by_parameter[name] = sp.Matrix([sp.Symbol(f"F_{x.name}_{name}", real=True) for x in states])
    return ImplicitStep(tuple(lines), sp.Matrix(states) + change, M, by_parameter)


def _shared(
    f: sp.Matrix, J: sp.Matrix, states: Sequence[sp.Symbol], parameters: Mapping[str, sp.Expr]
) -> list[Assign]:
    """Rates, hJ and df/dp with their common parts taken out together, each reciprocal taken once."""
    named = {f"f_{x.name}": f[i] for i, x in enumerate(states)}
    named |= {
        f"J_{i}{j}": h * J[i, j] for i in range(len(f)) for j in range(len(f)) if J[i, j] != 0
    }
    for name, chain in parameters.items():
        column = f.diff(sp.Symbol(name, real=True)) * chain
        named |= {f"f_{x.name}_{name}": column[i] for i, x in enumerate(states)}
    named, reciprocals = _reciprocals(named)
    return reciprocals + shared("c", named, {f"f_{x.name}": "rate [-]" for x in states})


def _reciprocals(named: Mapping[str, sp.Expr]) -> tuple[dict[str, sp.Expr], list[Assign]]:
    """Expressions with a named reciprocal in place of every division."""
    powers = {p for e in named.values() for p in e.atoms(sp.Pow) if p.exp.is_negative}
    bases = sorted({p.base for p in powers}, key=sp.default_sort_key)
    symbols = {base: sp.Symbol(f"inv{i}", real=True) for i, base in enumerate(bases)}
    replace = {p: symbols[p.base] ** (-p.exp) for p in powers}
    lines = [Assign(symbol.name, 1 / base) for base, symbol in symbols.items()]
    return {name: e.xreplace(replace) for name, e in named.items()}, lines


def _inverse(hJ: sp.Matrix, n: int) -> list[Assign]:
    """Statements for M = N^-1 and G = h M (I - hJ/2)."""
    N = sp.eye(n) - hJ + (hJ * hJ) / 2
    lines = [Assign(f"N_{i}{j}", N[i, j]) for i in range(n) for j in range(n)]
    symbols = _matrix(n, "N", lambda i, j: True)
    adjugate = symbols.adjugate()
    scale = sp.Symbol("inv_det", real=True)
    lines.append(
        Assign("inv_det", 1 / symbols.det(method="berkowitz"), "det N > 0 for every real J")
    )
    entries = [(i, j) for i in range(n) for j in range(n)]
    lines += [
        Assign(f"M_{i}{j}", scale * adjugate[i, j], "dx+/dx" if i + j == 0 else "")
        for i, j in entries
    ]
    M, B = (_matrix(n, letter, lambda i, j: True) for letter in "MB")
    half = h * (sp.eye(n) - hJ / 2)
    lines += [Assign(f"B_{i}{j}", half[i, j]) for i, j in entries]
    return lines + [Assign(f"G_{i}{j}", (M * B)[i, j]) for i, j in entries]


def _matrix(n: int, letter: str, present: Callable[[int, int], bool]) -> sp.Matrix:
    return sp.Matrix(
        n,
        n,
        lambda i, j: sp.Symbol(f"{letter}_{i}{j}", real=True) if present(i, j) else sp.Integer(0),
    )
