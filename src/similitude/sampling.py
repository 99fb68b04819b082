"""One implicit second-order step of x' = f(x, p), with its Jacobians, as symbols.

    J = (h/6) df/dx,    N = I - 2J + 3/2 J^2,    E = N^-1 (I + J),    M = E E
    G = (h/4) N^-1 (2I - J) (E + I),             x+ = x + G f(x, mean u) + W df/du (change of u)
    W = -(h/4) N^-2 J (2I - 7/4 J + 3/4 J^2)

E is the (1,2) Pade approximant of the exponential over half the step; its square is within 0.2 %
of the exponential for every stable eigenvalue up to |h lambda| = 1, L-stable, positive on the whole
real axis and exact at steady state, for one small inverse. For a nonlinear f the step is of second
order (exponential Rosenbrock form). The Jacobians are those of the same step: dx+/dx = M and
dx+/dp = G df/dp, with df/dp at the start of the step, which leaves dx+/dp exact at steady state.

W is what an input adds that rises in a straight line over the step, from the same two half steps
(Radau IIA, whose stages see the input a third of the way and at the end). Without it a log that is slow
against the vehicle makes it half a sample late.

Invariant: no branch, no sub-steps; bounded for any h and any stable J, sign-right as h -> infinity.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from similitude.elementary import spelt_functions
from similitude.matrix_function import MatrixFunction
from similitude.program.ir import Assign, shared
from similitude.saturation import arguments, spelt

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
    companion_after: sp.Matrix


def implicit_step(
    rates: Sequence[sp.Expr],
    states: Sequence[sp.Symbol],
    *,
    parameters: Mapping[str, sp.Expr],
    companion: Mapping[sp.Symbol, sp.Symbol] | None = None,
    ramp: tuple[str, sp.Symbol] | None = None,
    halves: int = 2,
) -> ImplicitStep:
    """Derive the step for the given rates.

    Parameters
    ----------
    rates : (n,) dx/dt* in states and anything else [-].
    states : (n,) symbols of the states before the step.
    parameters : name -> dp/d(coordinate), for each symbol whose sensitivity is wanted.
    companion : symbols of states and inputs -> those of the companion trajectory; none: the
        trajectory itself.
    ramp : name of the parameter that is an input, and symbol of its change over the step; none: all
        inputs are held.
    halves : 2: two half steps, as above; 1: one whole step of the same approximant,
        M = N^-1 (I + J), G = h N^-1 (I - J/2) with J = (h/3) df/dx, for a third fewer operations: within
        1.2 % of the exponential at |h lambda| = 1, 0.1 % at one half. Takes no ramp.

    Returns
    -------
    ImplicitStep    statements to be placed after ``h`` is assigned.
    """
    n = len(states)
    f = sp.Matrix(rates)
    J = f.jacobian(sp.Matrix(states))
    scaled = _matrix(n, "J", lambda i, j: J[i, j] != 0)
    path = companion or {}
    weights: list[sp.Expr] = []
    if halves == 2:
        inverted, weights = _inverse(scaled, n, ramped=ramp is not None)
    else:
        inverted = _whole_step(scaled, n)
    lines = _shared(f, h / (3 * halves) * J, states, parameters, path) + inverted
    M, G = (_matrix(n, letter, lambda i, j: True) for letter in "MG")
    rate = sp.Matrix([sp.Symbol(f"f_{x.name}", real=True) for x in states])
    change = sp.Matrix([sp.Symbol(f"d_{x.name}", real=True) for x in states])
    rising = sp.zeros(n, 1)
    if ramp is not None:
        lines += _ramp(scaled, states, weights, *ramp)
        rising = sp.Matrix([sp.Symbol(f"rise_{x.name}", real=True) for x in states])
    moves = G * rate + rising
    lines += [Assign(f"d_{x.name}", moves[i], "change over the step [-]") for i, x in enumerate(states)]
    followers = [path[x] for x in states if x in path]
    rate_of = sp.Matrix([sp.Symbol(f"f_{x.name}", real=True) for x in followers])
    if followers:
        moves = G * rate_of + rising
        lines += [Assign(f"d_{x.name}", moves[i]) for i, x in enumerate(followers)]
    moved = sp.Matrix([x + sp.Symbol(f"d_{x.name}", real=True) for x in followers])
    by_parameter = {}
    for name in parameters:
        inner = sp.Matrix([sp.Symbol(f"f_{x.name}_{name}", real=True) for x in states])
        lines += [Assign(f"F_{x.name}_{name}", (G * inner)[i]) for i, x in enumerate(states)]
        by_parameter[name] = sp.Matrix([sp.Symbol(f"F_{x.name}_{name}", real=True) for x in states])
    return ImplicitStep(tuple(lines), sp.Matrix(states) + change, M, by_parameter, moved)


def _shared(
    f: sp.Matrix,
    J: sp.Matrix,
    states: Sequence[sp.Symbol],
    parameters: Mapping[str, sp.Expr],
    path: Mapping[sp.Symbol, sp.Symbol],
) -> list[Assign]:
    """Rates, scaled df/dx and df/dp with their common parts taken out together, each reciprocal once."""
    named = {f"f_{x.name}": f[i] for i, x in enumerate(states)}
    named |= {f"f_{path[x].name}": f[i].xreplace(path) for i, x in enumerate(states) if x in path}
    named |= {f"J_{i}{j}": J[i, j] for i in range(len(f)) for j in range(len(f)) if J[i, j] != 0}
    for name, chain in parameters.items():
        column = f.diff(sp.Symbol(name, real=True)) * chain
        named |= {f"f_{x.name}_{name}": column[i].xreplace(path) for i, x in enumerate(states)}
    named = {name: sp.factor_terms(e) for name, e in named.items()}  # what all terms hold, once
    functions, named = spelt_functions(named)
    loads = arguments(named)
    named, reciprocals = _reciprocals(named | loads)
    loads = {name: named.pop(name) for name in loads}
    saturated, named = spelt(named, loads)
    return [
        *functions,
        *reciprocals,
        *shared("s", loads, dict.fromkeys(loads, "force over its limit [-]")),
        *saturated,
        *shared("c", named, {f"f_{x.name}": "rate [-]" for x in states}),
    ]


def _reciprocals(named: Mapping[str, sp.Expr]) -> tuple[dict[str, sp.Expr], list[Assign]]:
    """Expressions with a named reciprocal in place of every division."""
    powers = {p for e in named.values() for p in e.atoms(sp.Pow) if p.exp.is_negative}
    bases = sorted({p.base for p in powers}, key=sp.default_sort_key)
    symbols = {base: sp.Symbol(f"inv{i}", real=True) for i, base in enumerate(bases)}
    replace = {p: symbols[p.base] ** (-p.exp) for p in powers}
    lines = [Assign(symbol.name, 1 / base) for base, symbol in symbols.items()]
    return {name: e.xreplace(replace) for name, e in named.items()}, lines


def _ramp(
    J: sp.Matrix, states: Sequence[sp.Symbol], weights: Sequence[sp.Expr], name: str, change: sp.Symbol
) -> list[Assign]:
    """Statements for ``rise_<state>``, what the input's straight line adds to its mean."""
    n = len(states)
    slope = sp.Matrix([sp.Symbol(f"f_{x.name}_{name}", real=True) for x in states])
    lines = [Assign("ramp", h * change)]
    lines += [Assign(f"ramp_{k}", weights[k] * sp.Symbol("ramp", real=True)) for k in range(n)]
    total, power = sp.zeros(n, 1), slope
    for k in range(n):
        total += sp.Symbol(f"ramp_{k}", real=True) * power
        if k + 1 < n:
            names = [sp.Symbol(f"slope{k + 1}_{x.name}", real=True) for x in states]
            lines += [Assign(s.name, (J * power)[i]) for i, s in enumerate(names)]
            power = sp.Matrix(names)
    rise = "the input rises or falls in a straight line [-]"
    return lines + [Assign(f"rise_{x.name}", total[i], rise if i == 0 else "") for i, x in enumerate(states)]


def _inverse(J: sp.Matrix, n: int, *, ramped: bool) -> tuple[list[Assign], list[sp.Expr]]:
    """Statements for M = dx+/dx and G = change of the states per rate; W/h in powers of J."""
    of = MatrixFunction(J)
    N = of.named("n", of.reduced([1, -2, sp.Rational(3, 2)]))
    D = of.inverse(N, "i", "det N > 0 for every real J")
    E = of.named("E", of.product(D, of.reduced([1, 1])), "half a step")
    H = of.named("H", of.product(D, of.reduced([h / 2, -h / 4])), "change per rate over half a step")
    whole = of.named("m", of.product(E, E))
    change = of.named("g", of.product(H, of.reduced([E[0] + 1, *E[1:]])))
    weights: list[sp.Expr] = []
    if ramped:
        inner = of.reduced([0, -sp.Rational(1, 2), sp.Rational(7, 16), -sp.Rational(3, 16)])
        half = of.named("wh", of.product(D, of.named("wi", inner)))
        weights = of.named("w", of.product(D, half), "W/h in powers of J")
    of.matrix(whole, "M", "dx+/dx")
    of.matrix(change, "G", "change per rate")
    return of.lines, weights


def _whole_step(J: sp.Matrix, n: int) -> list[Assign]:
    """Statements for M and G of one step of the approximant."""
    of = MatrixFunction(J)
    N = of.named("n", of.reduced([1, -2, sp.Rational(3, 2)]))
    D = of.inverse(N, "i", "det N > 0 for every real J")
    of.matrix(of.named("m", of.product(D, of.reduced([1, 1]))), "M", "dx+/dx")
    of.matrix(of.named("g", of.product(D, of.reduced([h, -h / 2]))), "G", "change per rate")
    return of.lines


def _matrix(n: int, letter: str, present: Callable[[int, int], bool]) -> sp.Matrix:
    return sp.Matrix(
        n,
        n,
        lambda i, j: sp.Symbol(f"{letter}_{i}{j}", real=True) if present(i, j) else sp.Integer(0),
    )
