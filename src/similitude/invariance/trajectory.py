"""A Model simulated: states and outputs over time, for values, a drive and initial states."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import sympy as sp

from similitude.invariance.given_values import read_single, read_values
from similitude.invariance.model_equations import equations
from similitude.invariance.sensitivity_flow import Flow
from similitude.invariance.time_response import driven_inputs
from similitude.model import Model, Quantity


def trajectory(
    model: Model,
    times: Sequence[float] | np.ndarray,
    values: Mapping[str, object],
    *,
    drive: Mapping[str, str | sp.Expr] | None = None,
    quantities: Sequence[Quantity] = (),
) -> dict[str, np.ndarray]:
    """Simulate a model.

    Parameters
    ----------
    model : Model, with dimensions or rewritten without.
    times : (k,) in the model's unit of time, from zero on.
    values : parameters and, for inputs that are not driven, their constant values, in SI or as text with a
        unit; states where they start elsewhere than at zero.
    drive, quantities : inputs as formulas in t and parameters, and what else those are made of.

    Returns
    -------
    dict    "t", each state and each output -> (k,) in SI, to about 1e-11 of its size.

    Raises
    ------
    ModelError, UnitError    a value is missing, unknown or cannot be read, or the model runs away.
    """
    eq = equations(model, next(q.name for q in (*model.outputs, *model.states)), angle=False)
    t = sp.Symbol(eq.free("t"), real=True)
    own = {q.name: q.measure() for q in quantities}
    driven = driven_inputs(eq, drive or {}, own, t)
    rates = tuple(model.rates[q.name].xreplace(driven) for q in model.states)
    outputs = tuple(model.output_map[q.name].xreplace(driven) for q in model.outputs)
    states = {q.name: q.measure() for q in model.states}
    held = {s.name for e in (*rates, *outputs) for s in e.free_symbols}
    wanted = {n: m for n, m in (eq.measures | own).items() if n in held and n not in states}
    numbers = read_values(values, wanted, model=model, optional={**states, **own})
    read_single(numbers)
    start = tuple(sp.Float(float(numbers.get(name, 0.0)), 17) for name in states)
    flow = Flow(
        tuple(q.symbol for q in model.states),
        tuple(sp.Symbol(name, real=True) for name in wanted),
        t,
        rates,
        start,
        outputs,
    )
    times = np.asarray(times, dtype=float)
    given = [float(numbers[name]) for name in wanted]
    x, y, _ = flow.integrator()(given, times, with_slopes=False)
    found = {"t": times} | {name: x[:, k] for k, name in enumerate(states)}
    return found | {q.name: y[k] for k, q in enumerate(model.outputs)}
