"""How the measured output moves with each unknown along a given input, by exact sampled responses.

    y(t; z)    output of the model, linearised about rest, at constant scales, input held between rows
    s_i(t) = dy/dz_i    z the coordinate of unknown i: its logarithm, or itself

Invariant: a response is exact between rows; a slope is the central difference of two responses, whose
error is far below any noise.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.reduction import Reduction
from similitude.sampled_linearity import sampled_transfer

DIFFERENCE = 1e-4  # of a coordinate, each way


def sampled_response(
    reduction: Reduction, scales: Mapping[str, float], u: NDArray, step: float
) -> Callable[[Mapping[str, float]], NDArray]:
    """The response to an input as a function of the unknowns.

    Parameters
    ----------
    reduction : Reduction   one input, one output.
    scales : name -> value [SI] of the base.
    u : (n,) input [SI].    step : sample time [s].

    Returns
    -------
    callable                values of all unknowns [their units] -> output (n,) [SI].
    """
    from scipy.signal import lfilter

    groups = reduction.groups
    model = groups.model
    states, inputs = [q.symbol for q in model.states], [model.inputs[0].symbol]
    base = {sp.Symbol(n, real=True): scales[n] for n in groups.base}
    substitution = {g.symbol: sp.sympify(reduction.substitution[g.name]).subs(base) for g in groups.groups}
    quiet = dict.fromkeys([*states, *inputs], 0)
    f = sp.Matrix([groups.rates[q.name] for q in model.states])
    y = sp.Matrix([groups.output_map[model.outputs[0].name]])
    blocks = [m.jacobian(v).subs(substitution).subs(quiet) for m, v in
              ((f, states), (f, inputs), (y, states), (y, inputs))]  # fmt: skip
    numeric = sp.lambdify([one.symbol for one in reduction.unknowns], blocks, "numpy")
    names = (model.inputs[0].name, model.outputs[0].name)
    unit_in, unit_out = (float(sp.sympify(groups.scale[n]).subs(base)) for n in names)
    T = step / float(sp.sympify(groups.time_scale).subs(base))

    def response(values: Mapping[str, float]) -> NDArray:
        matrices = numeric(*(values[one.name] for one in reduction.unknowns))
        A, B, C, D = (np.array(m, dtype=float) for m in matrices)
        both, n = sampled_transfer(A, B, C, T), len(A)
        below = np.concatenate([[1.0], both[n:]])
        above = np.concatenate([[0.0], both[:n]]) + D[0, 0] * below
        return unit_out * lfilter(above, below, np.asarray(u) / unit_in)

    return response


def output_sensitivity(
    reduction: Reduction, values: Mapping[str, float], u: NDArray, step: float
) -> NDArray[np.float64]:
    """Slopes of the output along an input.

    Parameters
    ----------
    reduction : Reduction   one input, one output.
    values : name -> value [SI] of every unknown and every scale of the base.
    u : (n,) input [SI].    step : sample time [s].

    Returns
    -------
    (n, unknowns)           d output / d coordinate [SI of the output].
    """
    response = sampled_response(reduction, values, u, step)
    slopes = []
    for one in reduction.unknowns:
        low, high = (
            response({**values, one.name: _moved(values[one.name], one.kind, way * DIFFERENCE)})
            for way in (-1, 1)
        )
        slopes.append((high - low) / (2 * DIFFERENCE))
    return np.column_stack(slopes)


def _moved(value: float, kind: str, by: float) -> float:
    return value * float(np.exp(by)) if kind == "log" else value + by
