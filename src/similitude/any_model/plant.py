"""Any model as a plant: its dimensional equations along an input that is straight between samples.

    linear, constant      exact: matrix exponential of the model with a straight input (no integration error)
    anything else         Runge-Kutta of fourth order in substeps of at most 1/8 of the fastest time constant

It knows nothing of groups, unknowns or estimators, so what is estimated on its logs is checked by a second
route. One system or many run side by side.

Invariant: the same seed gives the same noise whatever the model.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike, NDArray

from similitude.errors import UsageError
from similitude.model import Model

FINE = 0.125  # substep times the fastest eigenvalue: an error of 3e-7 a time constant
MOST = 2000  # substeps a sample; a stiffer system wants a shorter sample
READ = 'docs/estimator.md, "A simulated log"'


@dataclass(frozen=True, eq=False)
class Response:
    """``states`` (systems, n, states) and ``output`` (systems, n) in SI."""

    states: NDArray[np.float64]
    output: NDArray[np.float64]


def respond(
    model: Model,
    values: Mapping[str, ArrayLike],
    u: ArrayLike,
    step: float,
    *,
    start: Mapping[str, float] | None = None,
) -> Response:
    """Response of one or many systems to an input.

    Parameters
    ----------
    model : Model         with one input and one output (`one_channel`).
    values : parameter -> value, (systems,) values or, for a signal, (n,) values over time [SI].
    u : (n,) input [SI].  step : time between samples [model's unit of time in SI].
    start : state -> value at the first sample [SI]; zero where left out.

    Returns
    -------
    Response

    Raises
    ------
    UsageError            the sample is far longer than the fastest time constant of a nonlinear model.
    """
    u = np.asarray(u, dtype=float)
    fixed = [q.name for q in model.parameters if q.name not in (*model.signals, *model.constraints)]
    held = [np.atleast_1d(np.asarray(values[n], dtype=float)) for n in fixed]
    systems = max(len(v) for v in held)
    constant = dict(zip(fixed, (np.broadcast_to(v, systems) for v in held), strict=True))
    moving = {n: np.broadcast_to(np.asarray(values[n], dtype=float), u.shape) for n in model.signals}
    x0 = np.tile([(start or {}).get(q.name, 0.0) for q in model.states], (systems, 1))
    steady = all(np.ptp(v) == 0 for v in moving.values())
    at = {**constant, **{n: np.full(systems, v[0]) for n, v in moving.items()}}
    if steady and is_linear(model):
        return _exact(model, at, u, step, x0)
    return _stepped(model, constant, moving, u, step, x0)


def is_linear(model: Model) -> bool:
    """Whether rates and outputs are linear in states and inputs, nothing added."""
    symbols = [q.symbol for q in (*model.states, *model.inputs)]
    formulas = sp.Matrix([*model.rates.values(), *model.output_map.values()])
    slopes = formulas.jacobian(symbols)
    rest = formulas.subs(dict.fromkeys(symbols, 0))
    return not slopes.free_symbols & set(symbols) and all(sp.simplify(e) == 0 for e in rest)


def _lambdify(model: Model, expressions: sp.Matrix | list) -> tuple[Callable, list[str]]:
    """The expressions as a function of states, input and parameters; constraints put in."""
    given = {sp.Symbol(n, real=True): e for n, e in model.constraints.items()}
    names = [q.name for q in model.parameters if q.name not in model.constraints]
    order = [*(q.name for q in model.states), model.inputs[0].name, *names]
    for _ in given:
        expressions = [e.xreplace(given) for e in expressions]
    plain = [e.doit() if isinstance(e, sp.Expr) else e for e in expressions]
    return sp.lambdify([sp.Symbol(n, real=True) for n in order], plain, "numpy", cse=True), names


def _matrices(model: Model, at: Mapping[str, NDArray], x: NDArray, u: NDArray) -> tuple[NDArray, ...]:
    """Slopes of rates and output by states and input: (s, k, k), (s, k), (s, k), (s,) for s systems."""
    states, k = [q.symbol for q in model.states], len(model.states)
    both = [*states, model.inputs[0].symbol]
    rates = sp.Matrix([model.rates[q.name] for q in model.states])
    output = sp.Matrix([model.output_map[model.outputs[0].name]])
    slopes = [*rates.jacobian(both), *output.jacobian(both)]
    numeric, names = _lambdify(model, slopes)
    entries = numeric(*x.T, u, *(at[n] for n in names))
    flat = np.array([np.broadcast_to(e, len(x)) for e in entries]).T.reshape(len(x), k + 1, k + 1)
    return flat[:, :k, :k], flat[:, :k, k], flat[:, k, :k], flat[:, k, k]


def _exact(model: Model, at: Mapping[str, NDArray], u: NDArray, step: float, x: NDArray) -> Response:
    from scipy.linalg import expm

    A, B, C, D = _matrices(model, at, x, np.zeros(len(x)))
    k = A.shape[1]
    block = np.zeros((len(x), k + 2, k + 2))
    block[:, :k, :k], block[:, :k, k], block[:, k, k + 1] = A * step, B * step, 1.0
    E = expm(block)
    F, first, second = E[:, :k, :k], E[:, :k, k] - E[:, :k, k + 1], E[:, :k, k + 1]
    states = np.empty((len(x), len(u), k))
    states[:, 0] = x
    for i in range(1, len(u)):
        x = (F @ x[:, :, None])[:, :, 0] + first * u[i - 1] + second * u[i]
        states[:, i] = x
    return Response(states, np.einsum("sk,snk->sn", C, states) + D[:, None] * u)


def _stepped(
    model: Model,
    constant: Mapping[str, NDArray],
    moving: Mapping[str, NDArray],
    u: NDArray,
    step: float,
    x: NDArray,
) -> Response:
    rates, names = _lambdify(model, [model.rates[q.name] for q in model.states])
    output, _ = _lambdify(model, [model.output_map[model.outputs[0].name]])
    n, systems = len(u), len(x)
    parts = _substeps(model, constant, moving, u, step, x)
    h = step / parts

    def slope(x: NDArray, u: float, at: list) -> NDArray:
        return np.array([np.broadcast_to(r, systems) for r in rates(*x.T, u, *at)]).T

    states, y = np.empty((systems, n, x.shape[1])), np.empty((systems, n))
    for i in range(n):
        at = [constant[p] if p in constant else moving[p][i] for p in names]
        if i:
            for j in range(parts):
                u0, u1 = (u[i - 1] + (u[i] - u[i - 1]) * (j + part) / parts for part in (0, 1))
                k1 = slope(x, u0, at)
                k2 = slope(x + h / 2 * k1, (u0 + u1) / 2, at)
                k3 = slope(x + h / 2 * k2, (u0 + u1) / 2, at)
                k4 = slope(x + h * k3, u1, at)
                x = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        states[:, i], y[:, i] = x, np.broadcast_to(output(*x.T, u[i], *at)[0], systems)
    return Response(states, y)


def _substeps(
    model: Model,
    constant: Mapping[str, NDArray],
    moving: Mapping[str, NDArray],
    u: NDArray,
    step: float,
    x: NDArray,
) -> int:
    at = {**constant, **{n: np.full(len(x), v.max()) for n, v in moving.items()}}
    A = _matrices(model, at, x, np.full(len(x), u.mean()))[0]
    fastest = float(np.abs(np.linalg.eigvals(np.nan_to_num(A, posinf=0.0, neginf=0.0))).max(initial=0.0))
    parts = int(np.ceil(max(step * fastest / FINE, 1)))
    if parts > MOST:
        raise UsageError(
            f"a sample of {step:.3g} s is {step * fastest:.0f} times the fastest time constant of "
            f"{model.name!r} ({1 / fastest:.3g} s)",
            usually="a value has the wrong unit, or a part of the model is so fast that it belongs left out.",
            paste=f"step='{10 / fastest:.1g} s'",
            read=READ,
        )
    return parts
