"""The response over time: to a step of an input, to a drive given as a formula, or from initial states.

    y(t) = g(x(t), u(t), p)        arguments: p, the heights of the inputs (or what the drive is made of),
                                   the initial states that are not zero, and t itself

The time argument is what the printed eq 13 of Brennan & Alleyne 2004 leaves out; without it the row of
time is false.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import Measure
from similitude.homogeneity.walk import mismatches
from similitude.invariance.model_equations import Equations
from similitude.invariance.response import Response
from similitude.invariance.sensitivity_flow import Flow
from similitude.model import Quantity
from similitude.model_formulas import read_formula

READ = 'docs/invariances.md, "Time responses"'


def time_response(
    eq: Equations,
    *,
    drive: Mapping[str, str | sp.Expr],
    quantities: Sequence[Quantity],
    initial: Sequence[str] | None,
) -> Response:
    """The output at time t after the model was let go.

    Parameters
    ----------
    eq : the model and its output.
    drive : input -> formula in t, parameters and ``quantities``; an input without one is a step, whose
        height is the argument of the input's name.
    quantities : what the drive is made of beside parameters: an amplitude, a frequency.
    initial : states that start elsewhere than at zero; None: all of them where nothing drives the model.

    Raises
    ------
    ModelError    a drive or an initial state of a name nobody declared, or a drive of another dimension.
    """
    model, t = eq.model, sp.Symbol(eq.free("t"), real=True)
    own = {q.name: q.measure(angle=eq.angle) for q in quantities}
    driven = driven_inputs(eq, drive, own, t)
    starts = [q.name for q in model.states] if initial is None and not model.inputs else list(initial or ())
    _expect(starts, [q.name for q in model.states], "initial state")
    start = {name: sp.Symbol(eq.free(f"{name}0"), real=True) for name in starts}
    rates = tuple(model.rates[q.name].xreplace(driven) for q in model.states)
    output = eq.output.xreplace(driven)
    states = tuple(q.symbol for q in model.states)
    held = {s.name for e in (*rates, output) for s in e.free_symbols} - {s.name for s in states}
    measures = {n: m for n, m in (eq.measures | own).items() if n in held}
    measures |= {start[name].name: eq.measures[name] for name in starts}
    symbols = tuple(sp.Symbol(name, real=True) for name in measures)
    begin = tuple(start.get(q.name, sp.Integer(0)) for q in model.states)
    flow = Flow(states, symbols, t, rates, begin, (output,))
    compiled = []

    def evaluate(values: Mapping[str, float]) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        if not compiled:
            compiled.append(flow.integrator())
        times = np.asarray(values[t.name], dtype=float)
        given = [float(values[s.name]) for s in symbols]
        _, y, slopes = compiled[0](given, times.reshape(-1))
        named = dict(zip((*measures, t.name), slopes[0], strict=True))
        return y[0].reshape(times.shape), {n: s.reshape(times.shape) for n, s in named.items()}

    names = {sp.Symbol(n, real=True): m for n, m in (eq.measures | measures).items()}
    return Response(
        kind="time",
        about=f"{eq.name} at time {t.name}" + _after(eq, drive, starts),
        arguments={**measures, t.name: eq.time},
        output=eq.output_measure,
        symbols=names,
        certificates=eq.certificates,
        evaluate=evaluate,
    )


def driven_inputs(
    eq: Equations, drive: Mapping[str, str | sp.Expr], own: Mapping[str, Measure], t: sp.Symbol
) -> dict[sp.Symbol, sp.Expr]:
    """Input symbols and the formulas that drive them, read and checked for their dimensions.

    Raises
    ------
    ModelError    no such input, a name nobody declared, or a drive of another dimension.
    """
    _expect(drive, [q.name for q in eq.model.inputs], "driven input")
    parameters = {q.name: eq.measures[q.name] for q in eq.model.parameters}
    measures = parameters | dict(own) | {t.name: eq.time}
    units = {sp.Symbol(n, real=True): (m, str(m)) for n, m in measures.items()}
    driven = {}
    for name, given in drive.items():
        what = f"the drive of {name!r}"
        formula = read_formula(given, measures, what=what)
        strange = sorted(s.name for s in formula.free_symbols - units.keys())
        if strange:
            raise _fault(f"{what} uses {', '.join(strange)}, which is not declared")
        found = mismatches(formula, units, eq.measures[name], what)
        if found:
            raise _fault(f"{what} is not homogeneous: {found[0]}")
        driven[sp.Symbol(name, real=True)] = formula
    return driven


def _expect(given, names: Sequence[str], kind: str) -> None:
    strange = [name for name in given if name not in names]
    if strange:
        raise _fault(f"{strange[0]!r} is no {kind} (there are {', '.join(names) or 'none'})")


def _fault(what: str) -> ModelError:
    return ModelError(
        what,
        usually="A quantity of the drive was not declared, or a name was misspelt.",
        paste="invariances(model, drive={'u': 'A*sin(w*t)'},"
        " quantities=[Quantity('A', 'N'), Quantity('w', 'rad/s')])",
        read=READ,
    )


def _after(eq: Equations, drive: Mapping[str, object], starts: Sequence[str]) -> str:
    steps = [q.name for q in eq.model.inputs if q.name not in drive]
    parts = [f"a step of {', '.join(steps)}"] if steps else []
    parts += [f"{name} = {given}" for name, given in drive.items()]
    parts += [f"initial {', '.join(starts)}"] if starts else []
    return f" after {'; '.join(parts)}" if parts else ""
