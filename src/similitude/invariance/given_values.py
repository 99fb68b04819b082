"""Values of arguments as a user gives them: SI numbers, or text with a unit; known ones need not be given."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np
import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import Measure
from similitude.model import Model
from similitude.units import parse_quantity

READ = 'docs/invariances.md, "Values"'


def read_values(
    given: Mapping[str, object],
    wanted: Mapping[str, Measure],
    *,
    model: Model | None = None,
    optional: Mapping[str, Measure] | None = None,
) -> dict[str, object]:
    """Numbers in SI for every argument wanted.

    Parameters
    ----------
    given : name -> number or array in SI, or text such as ``"5.451 kg"``. Quantities of the model that are
        not wanted may be there too.
    wanted : name -> measure.
    model : its known values fill in what is not given, and its constraints what follows from the rest.
    optional : names that are taken where they are given.

    Raises
    ------
    ModelError    a value is missing, has a name nobody knows, or is no finite number.
    UnitError     text that cannot be read, or of another dimension.
    """
    optional = dict(optional or {})
    quantities = {} if model is None else {q.name: q.measure() for q in model.quantities}
    measures = quantities | optional | dict(wanted)
    strange = sorted(set(given) - set(measures))
    if strange:
        raise _fault(
            f"a value is given for {', '.join(strange)}, which is no argument"
            f" (arguments: {', '.join(wanted) or 'none'})",
            "A name was misspelt, or the argument belongs to another kind of response.",
            f"values = {{{next(iter(wanted), 'm')!r}: ...}}",
        )
    values = {name: _number(name, value, measures[name]) for name, value in given.items()}
    if model is not None:
        values = _filled(model, values)
    missing = [name for name in wanted if name not in values]
    if missing:
        raise _fault(
            f"the value of {missing[0]} [{wanted[missing[0]]}] is missing"
            + (f" (and of {', '.join(missing[1:])})" if missing[1:] else ""),
            "Every argument needs a value: parameters, the height of the input, and t, s or Ts.",
            f"values = {{{missing[0]!r}: '1 {wanted[missing[0]]}', ...}}".replace(" -'", "'"),
        )
    return {name: values[name] for name in (*wanted, *optional) if name in values}


def read_single(values: Mapping[str, object]) -> None:
    """Refuse a signal over time where one real number is meant.

    Raises
    ------
    ModelError    a value is an array, or complex.
    """
    for name, value in values.items():
        if np.ndim(value) or np.iscomplexobj(value):
            kind = f"an array of shape {np.shape(value)}" if np.ndim(value) else f"the complex number {value}"
            raise _fault(
                f"the value of {name} is {kind}; one real number is needed",
                "A signal over time was given as a value; it goes in as a formula of t instead.",
                f"trajectory(model, times, values, drive={{{name!r}: '0.1*sin(w*t)'}}, quantities=[...])",
            )


def _filled(model: Model, values: dict[str, object]) -> dict[str, object]:
    values = {q.name: q.value for q in model.quantities if q.value is not None} | values
    for name, formula in model.constraints.items():
        names = {s.name for s in formula.free_symbols}
        if name not in values and names <= set(values):
            values[name] = float(
                formula.xreplace({s: sp.Float(values[s.name]) for s in formula.free_symbols})
            )
    return values


def _number(name: str, value: object, measure: Measure) -> object:
    if isinstance(value, str):
        return parse_quantity(value, expect=measure.dimension)[0]
    try:
        array = np.asarray(value, dtype=complex if np.iscomplexobj(value) else float)
    except (TypeError, ValueError):
        array = np.array(np.nan)
    if not np.all(np.isfinite(array)):
        raise _fault(
            f"the value of {name} is {re.sub(r'[^ -~]', '?', repr(value))[:60]}, which is no finite number",
            "A list holds text, or a column of a log was passed with gaps.",
            f"values = {{{name!r}: '1 {measure}'}}".replace(" -'", "'"),
        )
    return array if array.ndim else array[()]


def _fault(what: str, usually: str, paste: str) -> ModelError:
    return ModelError(what, usually=usually, paste=paste, read=READ)
