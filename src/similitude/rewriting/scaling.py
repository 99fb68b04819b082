"""Values and trajectories into dimensionless ones and back: numbers, arrays, and time itself.

    x* = x/c,  Pi from the parameters,  t* = integral of dt/T        and the inverse

With constant scales t* = t/T. Where a scale is an array along the trajectory, the integral is taken by
trapezoids over the times given.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import measure_of
from similitude.invariance.given_values import read_values
from similitude.rewriting.moving_scales import rate_symbol
from similitude.rewriting.rewritten import READ, Rewritten
from similitude.units import parse_unit

TIME = "t"


def into_groups(rewritten: Rewritten, values: Mapping[str, object]) -> dict[str, object]:
    """Dimensionless values of whatever dimensional values are given.

    Parameters
    ----------
    rewritten : Rewritten
    values : name -> number, array along a trajectory, or text with a unit, in SI: every base parameter,
        and any of the other parameters, states, inputs and outputs; ``"t"`` for time; ``"<name>_rate"``
        for d(name)/dt of a moving base parameter.

    Returns
    -------
    dict    states, inputs, outputs, ``"t"`` and ``"<name>_rate"`` by their own names, groups by theirs;
            a group whose parameters were not all given is left out.

    Raises
    ------
    ModelError, UnitError    a base parameter has no value, or a name is not the model's.
    """
    g, model = rewritten.groups, rewritten.groups.model
    numbers = _read(rewritten, values, model)
    at = {name: numbers[name] for name in g.base}
    signals = (*model.states, *model.inputs, *(q for q in model.outputs if q not in model.states))
    found = {q.name: numbers[q.name] / _at(g.scale[q.name], at) for q in signals if q.name in numbers}
    for group in g.groups:
        if set(group.exponents) <= set(numbers):
            found[group.name] = math.prod(_power(numbers[n], e) for n, e in group.exponents.items())
    pace = 1 / _at(g.time_scale, at)
    for name in rewritten.moving:
        if rate_symbol(name).name in numbers:
            found[rate_symbol(name).name] = numbers[rate_symbol(name).name] / pace / at[name]
    if TIME in numbers:
        found[TIME] = _integral(numbers[TIME], pace)
    return found


def out_of_groups(
    rewritten: Rewritten, dimensionless: Mapping[str, object], scales: Mapping[str, object]
) -> dict[str, object]:
    """Values with dimensions again.

    Parameters
    ----------
    rewritten : Rewritten
    dimensionless : as `into_groups` returns them; numbers or arrays along one trajectory.
    scales : base parameter -> value, array along the trajectory, or text with a unit, in SI.

    Returns
    -------
    dict    states, inputs, outputs, parameters and ``"t"`` by name, in SI, base parameters included.

    Raises
    ------
    ModelError, UnitError    a base parameter has no value, or a name is not the rewritten model's.
    """
    g, model = rewritten.groups, rewritten.groups.model
    at = read_values(scales, {n: model.quantity(n).measure() for n in g.base}, model=model)
    of_group = {group.name: group.parameter for group in g.groups}
    rates = {rate_symbol(name).name: name for name in rewritten.moving}
    signals = {q.name for q in (*model.states, *model.inputs, *model.outputs)}
    found = dict(at)
    for name, value in dimensionless.items():
        value = np.asarray(value, dtype=float)[()]
        if name in of_group:
            found[of_group[name]] = value * _at(g.scale[of_group[name]], at)
        elif name in signals:
            found[name] = value * _at(g.scale[name], at)
        elif name in rates:
            found[name] = value * at[rates[name]] / _at(g.time_scale, at)
        elif name == TIME:
            found[name] = _integral(value, _at(g.time_scale, at))
        else:
            raise ModelError(
                f"{name!r} is nothing of the rewritten model (groups {', '.join(of_group) or 'none'};"
                f" signals {', '.join(sorted(signals))}; t)",
                usually="A parameter of the dimensional model was given among the dimensionless values.",
                paste="out_of_groups(rewritten, into_groups(rewritten, values), scales)",
                read=READ,
            )
    return found


def _read(rewritten: Rewritten, values: Mapping[str, object], model) -> dict[str, object]:
    base = {name: model.quantity(name).measure() for name in rewritten.groups.base}
    time = measure_of(parse_unit(model.time_unit), angle=False)
    others = {q.name: q.measure() for q in model.quantities if q.name not in base}
    others |= {rate_symbol(name).name: base[name] / time for name in rewritten.moving}
    if TIME not in {q.name for q in model.quantities}:
        others[TIME] = time
    return read_values(values, base, model=model, optional=others)


def _at(scale: sp.Expr, values: Mapping[str, object]):
    """A product of powers at numbers or arrays."""
    result = 1.0
    for factor, power in scale.as_powers_dict().items():
        if factor.is_Symbol:
            result = result * np.asarray(values[factor.name], dtype=float) ** float(power)
        else:
            result = result * float(factor**power)
    return result[()] if isinstance(result, np.ndarray) else result


def _power(value: object, exponent) -> object:
    return (np.asarray(value, dtype=float) ** float(exponent))[()]


def _integral(times: object, pace: object):
    """Integral of the pace over the times, from zero at time zero for a constant pace."""
    times, pace = np.asarray(times, dtype=float), np.asarray(pace, dtype=float)
    if pace.ndim == 0 or times.ndim == 0:
        return (times * pace)[()]
    steps = np.diff(times) * (pace[1:] + pace[:-1]) / 2
    return times[0] * pace[0] + np.concatenate([[0.0], np.cumsum(steps)])
