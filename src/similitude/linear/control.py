"""To and from python-control, which knows numbers but no units (`pip install 'similitude[control]'`).

To it go the matrices at given values; from it come models whose coefficients are parameters with known
values, in units that follow from those of the signals.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import Measure, measure_of
from similitude.invariance.given_values import read_values
from similitude.linear.construction import READ, state_space_model, transfer_function_model
from similitude.linear.matrices import linear_parts
from similitude.model import Model, Quantity
from similitude.units import parse_unit


def to_control(model: Model, values: Mapping[str, object]):
    """A `control.StateSpace` of a model at given values, in SI.

    Parameters
    ----------
    model : linear, or not; then it is linearised, and ``values`` hold the operating point too.
    values : parameters in SI or as text with a unit; known values and constraints fill in the rest.

    Raises
    ------
    ModelError    python-control is not installed, a value is missing, or a name is not the model's.
    """
    control = _control()
    parts = linear_parts(model)
    held = {s.name for m in (parts.A, parts.B, parts.C, parts.D) for s in m.free_symbols}
    wanted = {q.name: q.measure() for q in model.quantities if q.name in held}
    numbers = read_values(values, wanted, model=model)
    at = {sp.Symbol(n, real=True): sp.Float(float(numbers[n]), 17) for n in wanted}
    A, B, C, D = (
        np.array(m.xreplace(at).evalf(17).tolist(), dtype=float).reshape(m.shape)
        for m in (parts.A, parts.B, parts.C, parts.D)
    )
    named = {
        "inputs": [q.name for q in model.inputs],
        "outputs": [q.name for q in model.outputs],
        "states": [q.name for q in model.states],
    }
    return control.StateSpace(A, B, C, D, name=model.name, **named)


def from_control(
    system,
    *,
    inputs: Sequence[Quantity],
    outputs: Sequence[Quantity],
    states: Sequence[Quantity] | None = None,
    name: str = "from_control",
) -> Model:
    """A model of a `control.StateSpace` or `control.TransferFunction`.

    Every coefficient that is not zero becomes a parameter (``a11``, ``b1``, ...) whose value is known and
    whose unit follows from those of the signals; a coefficient of exactly one, where its unit cancels,
    stays a number.

    Parameters
    ----------
    system : in continuous time; the numbers are taken to be in SI and seconds.
    inputs, outputs, states : quantities with the units the numbers are in; states only of a StateSpace.
        An output that is a state has the state's name.

    Raises
    ------
    ModelError    the system is sampled, has other numbers of signals, or states are missing.
    """
    control = _control()
    if not isinstance(system, (control.StateSpace, control.TransferFunction)):
        raise _fault(
            f"a system of python-control is needed, not {system!r:.60}",
            "Numbers alone are no system, and a FrequencyResponseData has no equations.",
            "from_control(control.tf([1.0], [1.0, 2.0, 3.0]), inputs=[...], outputs=[...])",
        )
    if system.isdtime(strict=True):
        raise _fault(
            f"the system is sampled every {system.dt}",
            "A model is in continuous time; invariances(model, response='z') samples it.",
            "from_control(control.ss(A, B, C, D), ...)",
        )
    if isinstance(system, control.TransferFunction):
        return _of_transfer_function(system, inputs, outputs, name)
    if states is None or (len(states), len(inputs), len(outputs)) != (
        system.nstates,
        system.ninputs,
        system.noutputs,
    ):
        said = "none" if states is None else len(states)
        raise _fault(
            f"the system has {system.nstates} states, {system.ninputs} inputs and {system.noutputs} outputs;"
            f" quantities were given for {said}, {len(inputs)} and {len(outputs)}",
            "Units cannot be read from numbers; each signal is given as a Quantity.",
            "from_control(system, states=[Quantity('x1', 'm')], inputs=[...], outputs=[...])",
        )
    second = measure_of(parse_unit("s"), angle=False)
    x, u, y = ([q.measure() for q in kind] for kind in (states, inputs, outputs))
    held: list[Quantity] = []
    A = _named("a", system.A, [[i / second / j for j in x] for i in x], held)
    B = _named("b", system.B, [[i / second / j for j in u] for i in x], held)
    C = _named("c", system.C, [[i / j for j in x] for i in y], held)
    D = _named("d", system.D, [[i / j for j in u] for i in y], held)
    return state_space_model(
        name, states=states, inputs=inputs, outputs=outputs, parameters=held, A=A, B=B, C=C, D=D
    )


def _of_transfer_function(
    system, inputs: Sequence[Quantity], outputs: Sequence[Quantity], name: str
) -> Model:
    if (system.ninputs, system.noutputs, len(inputs), len(outputs)) != (1, 1, 1, 1):
        raise _fault(
            f"the transfer function has {system.ninputs} inputs and {system.noutputs} outputs",
            "Only one input and one output go this way; several are given as a state space.",
            "from_control(control.ss(A, B, C, D), states=[...], inputs=[...], outputs=[...])",
        )
    above, below = (np.trim_zeros(np.array(c[0][0], dtype=float), "f") for c in (system.num, system.den))
    if len(above) > len(below):
        raise _fault(
            f"the transfer function has a numerator of order {len(above) - 1} over one of {len(below) - 1}",
            "It differentiates its input, which no model of states does; fast poles were left out.",
            "from_control(control.tf([1.0, 0.0], [0.01, 1.0]), inputs=[...], outputs=[...])",
        )
    above, below, n = above / below[0], below / below[0], len(below) - 1
    second = measure_of(parse_unit("s"), angle=False)
    gain = outputs[0].measure() / inputs[0].measure()
    held: list[Quantity] = []
    lead = n + 1 - len(above)
    den = [_named("a", [[c]], [[second**-k]], held, start=k)[0][0] for k, c in enumerate(below)]
    num = [
        _named("b", [[c]], [[gain * second ** -(k + lead)]], held, start=k + lead)[0][0]
        for k, c in enumerate(above)
    ]
    return transfer_function_model(
        name, input=inputs[0], output=outputs[0], parameters=held, numerator=num, denominator=den
    )


def _named(
    letter: str, numbers, measures: list[list[Measure]], held: list[Quantity], start: int | None = None
):
    """Names in place of numbers, each a known parameter; zeros and plain ones stay as they are."""
    rows = []
    for i, row in enumerate(measures):
        rows.append([])
        for j, measure in enumerate(row):
            value = float(numbers[i][j])
            if value == 0 or (value in (1.0, -1.0) and measure.is_none):
                rows[-1].append(int(value))
                continue
            name = f"{letter}{i + 1}{j + 1}" if start is None else f"{letter}{start}"
            unit = "1" if measure.is_none else str(measure)
            held.append(Quantity(name, unit, f"coefficient {name}", known=f"{value!r} {unit}"))
            rows[-1].append(name)
    return rows


def _control():
    try:
        import control
    except ImportError:
        raise _fault(
            "python-control is not installed",
            "It is an extra of this package.",
            "pip install 'similitude[control]'",
        ) from None
    return control


def _fault(what: str, usually: str, paste: str) -> ModelError:
    return ModelError(what, usually=usually, paste=paste, read=READ)
