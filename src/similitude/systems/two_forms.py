"""One system simulated twice: with its units, and in Pi groups, dimensionless states and time.

    dx/dt = f(x, u; p)          against          dx*/dt* = f*(x*, u*; pi),   x = X x*, t = T t*

Invariant: the second run is given the groups, the starred inputs and the starred start, and nothing
that has a unit.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.groups import Groups
from similitude.model import Model

SAMPLES = 60
RTOL = 1e-10  # of the integration
POINTS = 20


@dataclass(frozen=True, eq=False)
class TwoForms:
    """Both runs in the model's own units.

    Parameters
    ----------
    t : (n,) time [s].
    dimensional, rewritten : (n, states + outputs) what each run says [SI].
    names : of the columns.
    """

    t: NDArray[np.float64]
    dimensional: NDArray[np.float64]
    rewritten: NDArray[np.float64]
    names: tuple[str, ...]

    @property
    def disagreement(self) -> float:
        """Largest difference over the largest value of its column [-]; infinite where a run failed."""
        if not (np.isfinite(self.dimensional).all() and np.isfinite(self.rewritten).all()):
            return float("inf")
        size = np.abs(self.dimensional).max(axis=0)
        apart = np.abs(self.dimensional - self.rewritten).max(axis=0)
        return float((apart / np.where(size > 0, size, 1.0)).max())


def simulate_two_forms(
    groups: Groups,
    *,
    values: Mapping[str, float],
    inputs: Mapping[str, float],
    start: Mapping[str, float],
    duration: float,
) -> TwoForms:
    """Integrate a system in both forms with its inputs held.

    Parameters
    ----------
    groups : Groups      the rewritten model.
    values : parameter -> SI value, base and all others.
    inputs, start : input, state -> SI value.
    duration : [s].

    Returns
    -------
    TwoForms

    Raises
    ------
    ArithmeticError    a form could not be integrated to its end.
    """
    model = groups.model
    scale = {name: _number(expression, values) for name, expression in groups.scale.items()}
    unit = _number(groups.time_scale, values)
    pi = groups.value(values)
    t = np.linspace(0.0, duration, SAMPLES)
    states, outputs = [q.name for q in model.states], [q.name for q in model.outputs]
    size = np.array([scale[name] for name in (*states, *outputs)])
    x0 = np.array([start[name] for name in states])
    dimensional = _run(model.rates, model.output_map, model, {**values, **inputs}, x0, t, size[: len(states)])
    u = {name: value / scale[name] for name, value in inputs.items()}
    rewritten = _run(
        groups.rates, groups.output_map, model, {**pi, **u}, x0 / size[: len(states)], t / unit,
        np.ones(len(states)),
    )  # fmt: skip
    return TwoForms(t, dimensional, rewritten * size, (*states, *outputs))


def compare_at_points(groups: Groups) -> tuple[int, float]:
    """Rates and outputs of both forms at random positive parameters, states and inputs.

    Parameters
    ----------
    groups : Groups   the rewritten model.

    Returns
    -------
    tried, apart : points at which all is finite, of `POINTS`; largest difference over the larger of the
        two values and of the equation's own scale [-].
    """
    model, rng = groups.model, np.random.default_rng(1)
    signals = [q.name for q in (*model.states, *model.inputs)]
    scales = [
        *(
            (model.rates[q.name], groups.rates[q.name], groups.scale[q.name] / groups.time_scale)
            for q in model.states
        ),
        *((model.output_map[q.name], groups.output_map[q.name], groups.scale[q.name]) for q in model.outputs),
    ]
    functions = [tuple(map(_callable, row)) for row in scales]
    tried, apart = 0, 0.0
    for _ in range(POINTS):
        point = _point(model, rng)
        star = {**groups.value(point), **{n: point[n] / _number(groups.scale[n], point) for n in signals}}
        try:
            rows = [(f(point), g(star) * unit(point), unit(point)) for f, g, unit in functions]
        except (ValueError, TypeError, ZeroDivisionError, OverflowError):
            continue  # outside of the domain of a root, a logarithm, an arc
        if np.isfinite(rows).all():
            tried += 1
            apart = max([apart, *(abs(a - b) / max(abs(a), abs(b), abs(u)) for a, b, u in rows)])
    return tried, apart


def _point(model: Model, rng: np.random.Generator) -> dict[str, float]:
    point = {q.name: float(rng.uniform(0.5, 2.0)) for q in model.quantities}
    for name, expression in model.constraints.items():
        point[name] = _number(sp.sympify(expression), point)
    return point


def _callable(expression: sp.Expr):
    expression = sp.sympify(expression).doit()
    free = sorted(expression.free_symbols, key=str)
    call = sp.lambdify(free, expression, "math")
    return lambda known: call(*(known[s.name] for s in free))


def _number(expression: sp.Expr, values: Mapping[str, float]) -> float:
    return float(sp.sympify(expression).subs({s: values[s.name] for s in expression.free_symbols}))


def _run(rates, output_map, model, known, x0, t, size) -> NDArray[np.float64]:
    from scipy.integrate import solve_ivp

    x = [q.symbol for q in model.states]
    g = _function(x, [output_map[q.name] for q in model.outputs], known)
    if not x:  # a static model says the same at all times
        return np.array([g()] * len(t))
    f = _function(x, [rates[q.name] for q in model.states], known)
    ends, tight = (t[0], t[-1]), {"rtol": RTOL, "atol": 1e-12 * np.abs(size)}
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a run that fails is told by its result
        done = solve_ivp(lambda _, now: f(*now), ends, x0, "LSODA", t_eval=t, **tight)
    if not done.success or len(done.t) != len(t) or not np.isfinite(done.y).all():
        raise ArithmeticError(f"the integration stopped at {done.t[-1] if len(done.t) else 0:.4g}")
    return np.array([[*now, *g(*now)] for now in done.y.T])


def _function(x, expressions, known: Mapping[str, float]):
    expressions = [sp.sympify(e).doit() for e in expressions]
    free = sorted({s for e in expressions for s in e.free_symbols} - set(x), key=str)
    call = sp.lambdify([*x, *free], expressions, "math", cse=True)
    held = [known[s.name] for s in free]
    return lambda *now: call(*now, *held)
