"""What an Analysis comes to, in sentences and rows that the terminal and the page share.

Invariant: every number in a sentence is counted from the Analysis; nothing is rounded.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from similitude.analysis.analysis import Analysis, CheckedRow
    from similitude.symmetry.identifiability import Identifiability

WORDS = "no one two three four five six seven eight nine ten eleven twelve".split()

AFTER = "After the rewrite every row is empty: nothing has a dimension."


def rows_are_empty(found: Analysis) -> bool:
    """Whether the model was rewritten and no row couples its sensitivities any more."""
    return found.rows_after == 0


def rewrite_words(found: Analysis) -> tuple[str, ...]:
    """Whether the rewritten model is the same model, and what it leaves out."""
    proof = found.equivalence
    if proof.wrong:
        same = f"It is not the same model: {', '.join(proof.wrong)} differ."
    else:
        how = "in exact arithmetic" if proof.exact else "to fifty digits"
        shown = "" if proof.not_shown else ", then in symbols"
        same = f"It is the same model: compared {how} at {counted(proof.points, 'random point')}{shown}."
    left = found.rewritten.statement
    return (same, f"{left[0].upper()}{left[1:]}.") if left else (same,)


def residual_words(row: CheckedRow) -> str:
    """The residual of an invariance: proven, or how large."""
    if math.isinf(row.residual):
        return "does not hold"
    return "0, proven" if row.residual == 0 else f"{row.residual:.1e}"


def counted(number: int, noun: str, plural: str = "") -> str:
    """A number with its noun: ``three states``."""
    word = WORDS[number] if number < len(WORDS) else str(number)
    return f"{word} {noun if number == 1 else plural or noun + 's'}"


def headline(found: Analysis) -> str:
    """The model in one line."""
    model = found.model
    kinds = (
        ("state", model.states),
        ("input", model.inputs),
        ("output", model.outputs),
        ("parameter", model.parameters),
    )
    return ", ".join(counted(len(quantities), kind) for kind, quantities in kinds if quantities)


def account(found: Analysis) -> tuple[tuple[str, str, str], ...]:
    """What removes what: who, how much, and in words; one row each."""
    model, constrained = found.model, len(found.model.constraints)
    given = f"{counted(constrained, 'of them', 'of them')} given by others" if constrained else ""
    rows = [("parameters", str(len(model.parameters)), given)]
    base = f", measured in {', '.join(found.base)}" if found.base else ""
    rows.append(("units remove", str(found.units), f"{counted(found.units, 'independent dimension')}{base}"))
    rows.append(("structure removes", str(len(found.beyond)), _beyond_words(found)))
    blind = len(found.seen.parameters) - found.seen.determined
    told = f"of {counted(len(found.seen.parameters), 'unknown parameter')}"
    rows.append((f"{_outputs(found.seen)} cannot see", str(blind), told))
    return tuple(rows)


def _beyond_words(found: Analysis) -> str:
    if not found.beyond:
        return "no scaling but the units leaves the equations true"
    signals = {q.name for kind in (found.model.states, found.model.inputs, found.model.outputs) for q in kind}
    linear = [row for row in found.beyond if set(row) <= signals and set(row.values()) == {1}]
    if linear and len(found.beyond) == 1:
        return "states and inputs scale together: the model is linear"
    return f"{counted(len(found.beyond), 'scaling')} beyond the units"


def _outputs(seen: Identifiability) -> str:
    if not seen.outputs:
        return "no output"
    return ("outputs " if len(seen.outputs) > 1 else "output ") + ", ".join(seen.outputs)


def seen_words(seen: Identifiability, held: tuple[str, ...] = ()) -> str:
    """What outputs tell, in one sentence."""
    given = [name for name in seen.known if name not in held]
    known = f" with {', '.join(given)} known" if given else ""
    still = f" while {', '.join(held)} {'is' if len(held) == 1 else 'are'} held" if held else ""
    told = f"{_outputs(seen)[0].upper()}{_outputs(seen)[1:]}{known}{still}"
    numbers = (
        f"{counted(seen.determined, 'number')} about {counted(len(seen.parameters), 'unknown parameter')}"
    )
    if seen.is_complete and len(seen.parameters) == 1:
        return f"{told} tells the one parameter."
    if seen.is_complete:
        return f"{told} tells all {counted(len(seen.parameters), 'parameter')}." if seen.parameters else (
            f"{told}: there is no parameter to tell."
        )  # fmt: skip
    others = seen.determined - len(seen.seen)
    more = f", {counted(others, 'of them', 'of them')} not a product of powers" if others else ""
    return f"{told} tells {numbers}{more}."


def moved(direction: Mapping[str, int]) -> str:
    """A scaling in words: ``v, r, delta``, with powers where they are not one."""
    return ", ".join(name if power == 1 else f"{name}^{power}" for name, power in direction.items())
