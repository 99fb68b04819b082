"""One input and one output of a model, which is what an estimator drives and measures.

Invariant: what is left out is said; nothing with several inputs or outputs is chosen silently.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from similitude.errors import UsageError, shown
from similitude.model import Model, Quantity

READ = 'docs/estimator.md, "One input, one output"'


def one_channel(model: Model, *, input: str | None = None, output: str | None = None) -> Model:
    """The model with one input and one output; other inputs are zero.

    Parameters
    ----------
    model : Model.
    input, output : names; may be left out where there is only one. A state may be named as output.

    Returns
    -------
    Model

    Raises
    ------
    UsageError    there are several and none was named, or a name is not there.
    """
    u = _one(model, "input", model.inputs, input)
    states = tuple(q for q in model.states if q.name not in {o.name for o in model.outputs})
    y = _one(model, "output", model.outputs, output, more=states)
    zero = {q.symbol: 0 for q in model.inputs if q is not u}
    formula = model.output_map.get(y.name, y.symbol)
    validity = model.validity
    if validity is not None and validity[0].free_symbols & {q.symbol for q in model.inputs}:
        validity = None  # judged from the states alone
    return replace(
        model,
        inputs=(u,),
        outputs=(y,),
        rates={name: e.xreplace(zero) for name, e in model.rates.items()},
        output_map={y.name: formula.xreplace(zero)},
        validity=validity,
    )


def _one(
    model: Model,
    what: str,
    there: Sequence[Quantity],
    name: str | None,
    *,
    more: Sequence[Quantity] = (),
) -> Quantity:
    if name is None and len(there) == 1:
        return there[0]
    found = [q for q in (*there, *more) if q.name == name]
    if found:
        return found[0]
    names = ", ".join(f"{q.name} [{q.unit}]" for q in (*there, *more)) or "none"
    asked = f"no {what} {shown(name)}" if name is not None else f"{len(there)} {what}s and none was chosen"
    raise UsageError(
        f"model {model.name!r} has {asked} (there are {names})",
        usually=f"an estimator takes one {what}; other inputs are taken as zero.",
        paste=f"{what}={there[0].name if there else '...'!r}",
        read=READ,
    )
