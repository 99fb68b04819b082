"""Which estimator: a regression where the sampled model is straight in one unknown, else the filter.

Invariant: the choice is made by numbers, and they stand in its reason.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from similitude.any_model.fewest_unknowns import FewestUnknowns
from similitude.any_model.plant import is_linear
from similitude.any_model.regression_numbers import straightness
from similitude.any_model.trial import Trial
from similitude.directions import Reduced
from similitude.errors import UsageError, shown
from similitude.model import Model
from similitude.population import Prior
from similitude.sampled_linearity import LINEAR

KINDS = ("population", "regression")
FROZEN = (
    0.25  # of what freezing costs in bias against the sd that the drive reaches: a thirtieth of the error
)
READ = 'docs/estimator.md, "Filter or regression"'


@dataclass(frozen=True)
class Choice:
    """Which estimator, and why.

    ``frozen``: sd [-] that freezing the other unknowns leaves in the first; ``bend``: how far the sampled
    coefficients leave their straight line in it, as a share of their change [-].
    """

    kind: str
    reason: str
    frozen: float = 0.0
    bend: float = 0.0


def choose(
    model: Model,
    fewest: FewestUnknowns,
    reduced: Reduced,
    prior: Prior,
    trial: Trial,
    *,
    kind: str | None = None,
) -> Choice:
    """Choose the estimator.

    Parameters
    ----------
    model : Model      with one input and one output.
    prior : of the unknowns, the identified one first.
    kind : one of ``KINDS``, to override.

    Raises
    ------
    UsageError         there is no such kind, or a regression cannot be had of the model.
    """
    if kind is not None and kind not in KINDS:
        raise UsageError(
            f"kind = {shown(kind)} is no estimator for any model (there are {', '.join(KINDS)})",
            usually="one of the car's estimators was meant, which `similitude identify` runs.",
            paste="kind='population'",
            read=READ,
        )
    frozen = reduced.frozen_bias if np.isfinite(reduced.frozen_bias) else 0.0
    reason = _against(model, fewest, reduced, prior, trial, frozen)
    possible = is_linear(model) and not model.signals
    if kind == "regression" and not possible:
        raise UsageError(
            f"no regression of {model.name!r}: {reason}",
            usually="the filter takes any model; a regression wants constant, linear equations.",
            paste="kind='population'",
            read=READ,
        )
    bend = straightness(fewest, reduced.reduction, prior, trial.step).worst if possible else 0.0
    if kind is not None:
        return Choice(kind, f"yours{f' ({reason})' if reason and kind == 'regression' else ''}", frozen, bend)
    if reason:
        return Choice("population", reason)
    return Choice(
        "regression",
        f"the model is linear, {prior.names[0]} alone matters, and the sampled coefficients are straight "
        f"in it to {100 * bend:.2g} %",
        frozen,
        bend,
    )


def _against(
    model: Model, fewest: FewestUnknowns, reduced: Reduced, prior: Prior, trial: Trial, frozen: float
) -> str:
    """What speaks against a regression; empty where nothing does."""
    if not is_linear(model):
        return "the model is not linear"
    if model.signals:
        return f"{', '.join(model.signals)} may change from sample to sample"
    learnt = [one.name for one in reduced.roles if one.role == "estimate"]
    if learnt:
        return f"the drive tells of {', '.join(learnt)} too, and a regression has one unknown"
    if frozen > FROZEN * reduced.frozen_sd:
        return (
            f"freezing the other unknowns would bias {prior.names[0]} by {100 * frozen:.2g} %, "
            f"where the drive tells it to {100 * reduced.frozen_sd:.2g} %"
        )
    straight = straightness(fewest, reduced.reduction, prior, trial.step)
    if not straight.is_straight:
        return (
            f"the sampled coefficients are off their straight line in {prior.names[0]} by "
            f"{100 * straight.worst:.2g} % (a regression takes up to {100 * LINEAR:g} %)"
        )
    return ""
