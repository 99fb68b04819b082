"""Where a model comes to rest while its inputs are held: f(x, u; p) = 0, and what moves that point.

    dx/d ln a = -(df/dx)^-1 df/d ln a            y = g(x, u, p)

Found by Newton steps from the states that are given as guesses, zero where none is.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.invariance.compiled import compiled, log_slope
from similitude.invariance.model_equations import Equations
from similitude.invariance.response import Response

STEPS = 100
CLOSE = 1e-13  # of the size of the states: a Newton step below it is rounding [-]


def steady_response(eq: Equations) -> Response:
    """The output at rest; arguments are the parameters and the inputs that are held."""
    model = eq.model
    states = [q.symbol for q in model.states]
    names = {q.name for q in model.states}
    measures = {n: m for n, m in eq.measures.items() if n in eq.used and n not in names}
    arguments = [sp.Symbol(n, real=True) for n in measures]
    compiled_once = []

    def evaluate(values: Mapping[str, float]) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        if not compiled_once:
            compiled_once.append(_functions(eq, states, arguments))
        given = [float(values[a.name]) for a in arguments]
        x = np.array([float(values.get(s.name, 0.0)) for s in states])
        x, slopes = _rest(eq, *compiled_once[0][:2], x, given)
        n, m = len(states), len(arguments)
        flat = np.array(compiled_once[0][2](*x, *given), dtype=float)
        moved = flat[1 : 1 + n] @ slopes + flat[1 + n :]
        return flat[0], {a.name: moved[k] for k, a in enumerate(arguments) if k < m}

    return Response(
        kind="steady_state",
        about=f"{eq.name} at rest",
        arguments=measures,
        output=eq.output_measure,
        symbols={sp.Symbol(n, real=True): m for n, m in eq.measures.items()},
        certificates=eq.certificates,
        evaluate=evaluate,
        guesses={q.name: eq.measures[q.name] for q in model.states},
    )


def _functions(eq: Equations, states: list[sp.Symbol], arguments: list[sp.Symbol]):
    f, g = [eq.model.rates[s.name] for s in states], eq.output
    both = [*states, *arguments]
    rates = compiled(both, [*f, *(sp.diff(e, x) for e in f for x in states)])
    forced = compiled(both, [log_slope(e, a) for e in f for a in arguments])
    output = compiled(both, [g, *(sp.diff(g, x) for x in states), *(log_slope(g, a) for a in arguments)])
    return rates, forced, output


def _rest(eq: Equations, rates, forced, x: np.ndarray, given: list[float]) -> tuple[np.ndarray, np.ndarray]:
    n = len(x)
    for _ in range(STEPS):
        with np.errstate(all="ignore"):
            flat = np.array(rates(*x, *given), dtype=float)
        jacobian = flat[n:].reshape(n, n)
        if not np.all(np.isfinite(flat)) or np.linalg.matrix_rank(jacobian) < n:
            break
        step = np.linalg.solve(jacobian, flat[:n])
        x = x - step
        if np.all(np.abs(step) <= CLOSE * max(np.abs(x).max(), np.finfo(float).tiny)):
            slopes = -np.linalg.solve(jacobian, np.array(forced(*x, *given), dtype=float).reshape(n, -1))
            return x, slopes
    named = ", ".join(f"{q.name} = {v:.4g}" for q, v in zip(eq.model.states, x, strict=True))
    raise ModelError(
        f"model {eq.model.name!r} was not found at rest; the search ended at {named}",
        usually="It has no rest for these inputs (it integrates), or the search started too far away:"
        " give the states as guesses.",
        paste=f"values = {{..., {eq.model.states[0].name!r}: 1.0}}",
        read='docs/invariances.md, "Responses"',
    )
