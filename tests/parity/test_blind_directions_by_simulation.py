"""What outputs are said not to see is moved by a finite factor in a simulation: the outputs must not move.

A second route that knows nothing of ranks: SciPy integrates the original equations before and after. What
is said to be seen must move them.
"""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from similitude import identifiable, shipped_system

FACTOR = 1.7
CASES = (
    "bicycle",
    "saturating_bicycle",
    "rlc_circuit",
    "quarter_car",
    "aircraft_short_period",
    "heat_exchanger",
)
TOLERANCE = 1e-10  # of the integrator, relative
TIMES = np.linspace(0.0, 2.0, 41)  # [s], of systems whose parameters are all near one


def outputs(model, values: dict[str, float], start: dict[str, float]) -> np.ndarray:
    """Outputs (k, 41) under inputs sin t, sin 2t, ... and signals 1 + 0.3 sin 3t."""
    names = [q.name for q in (*model.states, *model.inputs, *model.parameters)]
    formulas = [
        e.doit() if e.has(sp.Function) else e for e in (*model.rates.values(), *model.output_map.values())
    ]
    constraints = {sp.Symbol(n, real=True): e for n, e in model.constraints.items()}
    formulas = [e.xreplace(constraints) for e in formulas]
    call = sp.lambdify([sp.Symbol(n, real=True) for n in names], formulas, modules="numpy")
    n = len(model.states)

    def at(t, x):
        given = [np.sin((i + 1) * t) for i in range(len(model.inputs))]
        moving = {name: values[name] * (1 + 0.3 * np.sin(3 * t)) for name in model.signals}
        return call(*x, *given, *((values | moving)[q.name] for q in model.parameters))

    begin = [start[q.name] for q in model.states]
    run = solve_ivp(lambda t, x: at(t, x)[:n], (0, 2), begin, t_eval=TIMES, rtol=TOLERANCE, atol=1e-13)
    return np.array([at(t, x)[n:] for t, x in zip(run.t, run.y.T, strict=True)]).T


@pytest.mark.parametrize("name", CASES)
def test_a_blind_direction_moves_no_output_and_a_seen_one_does(name):
    model = shipped_system(name).model
    rng = np.random.default_rng(7)
    values = {q.name: rng.uniform(0.6, 1.4) for q in model.parameters}
    values["L"] = 2 * values.get("L", 1.0)  # longer than the part of it that is a parameter, too
    start = {q.name: rng.uniform(0.6, 1.4) for q in model.states}
    found = identifiable(model)
    before = outputs(model, values, start)
    scale = np.abs(before).max()

    for direction in found.unseen:
        moved = {n: v * FACTOR ** direction.get(n, 0) for n, v in values.items()}
        begun = {n: v * FACTOR ** direction.get(f"{n}(0)", 0) for n, v in start.items()}
        change = np.abs(outputs(model, moved, begun) - before).max()
        assert change < 1e4 * TOLERANCE * scale, direction
    for monomial in found.seen:
        if len(monomial) == 1:  # a parameter told by itself
            (own,) = monomial
            change = np.abs(outputs(model, {**values, own: values[own] * FACTOR}, start) - before).max()
            assert change > 1e-4 * scale, own
