"""A base for a model whose author named none: of what is known, completed where nothing measures a signal.

Invariant: the base spans, and a quantity that was added only measures: it is in no equation.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import combinations, islice

from similitude.dimensional.base_advice import advise_base
from similitude.errors import ModelError
from similitude.model import Model, Quantity
from similitude.units import Dimension

LOOKED_AT = 200  # bases


def choose_base(
    model: Model, exact: Collection[str], *, base: Sequence[str] | None = None
) -> tuple[Model, tuple[str, ...], tuple[str, ...]]:
    """Repeating variables, and the model with what had to be added to measure by.

    Parameters
    ----------
    model : Model.
    exact : parameters whose values are known exactly; they are preferred.
    base : the author's; completed where it does not span.

    Returns
    -------
    model, base, added    names of quantities that only measure, 1 SI unit each.

    Raises
    ------
    ModelError            the base that was named is none.
    """
    candidates = [q for q in model.parameters if q.name not in model.constraints]
    if base is not None:
        return model, tuple(base), ()
    found = _best(model, exact)
    if found is not None:
        return model, found, ()
    time = Quantity("time", model.time_unit, "time")
    wanted = [*model.inputs, *model.states, *model.outputs, time]
    spare = list({q.dimension: q for q in wanted if q.dimension != Dimension.none}.values())
    taken = {q.name for q in (*model.quantities, *candidates)}
    for count in range(1, len(spare) + 1):
        for some in combinations(spare, count):
            more = tuple(
                Quantity(_free(f"{q.name}_measure", taken), q.unit, f"a {q.name} to measure by") for q in some
            )
            larger = replace(model, parameters=(*model.parameters, *more))
            found = _best(larger, {*exact, *(q.name for q in more)})
            if found is not None:
                return larger, found, tuple(q.name for q in more)
    raise ModelError(
        f"model {model.name!r} has nothing that all its units could be measured by",
        usually="it has neither states nor parameters with units.",
        paste="print(similitude.advise_base(model))",
        read='docs/groups.md, "Choosing a base"',
    )


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name


def _best(model: Model, exact: Collection[str]) -> tuple[str, ...] | None:
    """Of the adviser's bases the first with most members that are known exactly."""
    ranked = [one.base for one in islice(advise_base(model).ranked, LOOKED_AT)]
    fit = [b for b in ranked if not set(b) & set(model.constraints)]
    known = {*exact, *model.signals}
    return max(fit, key=lambda b: sum(name in known for name in b), default=None)
