"""An estimator and an estimate in words, for a terminal.

Invariant: every number that was taken and not stated is shown with the word "taken".
"""

from __future__ import annotations

from typing import Any


def estimator_text(estimator: Any) -> str:
    """What is unknown, what is made of it and why, and what was taken."""
    fewest, choice = estimator.fewest, estimator.choice
    unknowns = {u.name: u for u in estimator.reduced.reduction.unknowns}
    uncertain = fewest.knowledge.uncertain
    lines = [
        f"{estimator.library.name}: {len(uncertain)} uncertain parameter{'s' * (len(uncertain) != 1)} "
        f"({', '.join(uncertain)}), {len(unknowns)} unknown{'s' * (len(unknowns) != 1)}; "
        f"base {', '.join(fewest.base)}",
        *(f"  {n} = {u.meaning}" for n, u in unknowns.items()),
        *(f"  note: {note}" for note in fewest.notes),
        estimator.reduced.text,
        f"estimator: {choice.kind}, since {choice.reason}",
    ]
    for name, (value, unit, origin) in estimator.assumed.items():
        lines.append(f"  {name} = {value:.4g}{'' if unit == '-' else f' {unit}'}  ({origin})")
    if estimator.library.why_slow:
        lines.append(f"  {estimator.library.why_slow}")
    return "\n".join(lines)


def estimate_text(estimate: Any) -> str:
    """Verdict, unknowns and parameters with intervals."""
    lines = [
        f"{estimate.verdict}: {estimate.reason}",
        *(_line(n, one) for n, one in estimate.unknowns.items()),
        "which makes of the parameters",
        *(_line(n, one) for n, one in estimate.parameters.items()),
        f"mean squared innovation {estimate.consistency:.2f} of what was expected",
    ]
    return "\n".join(lines)


def _line(name: str, one: Any) -> str:
    unit = "" if one.unit in ("-", "1") else f" {one.unit}"
    return (
        f"  {name:<14} {one.value:.4g}{unit}  95 % {one.low:.4g} to {one.high:.4g}"
        f"  (sd {100 * one.sd:.2g} %, before {100 * one.prior_sd:.2g} %)"
    )
