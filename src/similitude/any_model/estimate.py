"""Estimate: what an estimator says of a log: unknowns and parameters with intervals, and a verdict.

Invariant: intervals are 95 % and those of the logarithm, so every end is a possible value; a verdict comes
with every number.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.any_model.words import estimate_text
from similitude.status import NAMES

WIDE = 1.959964  # sds of a 95 % interval
NARROW, TOLD = 0.15, 0.5  # sd of the logarithm, and its share of the prior's, up to which it is identified
REJECTED = 0.2  # of the samples
NOISY = 4.0  # variance of the residual over the stated noise beyond which the model does not hold


@dataclass(frozen=True)
class Value:
    """A value [its unit] with 95 % interval, sd of its logarithm, and that before the log."""

    value: float
    low: float
    high: float
    sd: float
    prior_sd: float
    unit: str


@dataclass(frozen=True, eq=False)
class Estimate:
    """What a log says.

    Parameters
    ----------
    t : (n,) [s].   value, low, high : (n,) the identified unknown along the log, 95 %.
    innovation, innovation_sd : (n,) output measured less predicted, and its sd [SI].
    status : (n,) codes of `similitude.status`.
    unknowns, parameters : name -> Value at the end; parameters that were uncertain.
    verdict, reason : one word, one sentence.
    consistency : mean squared normalised innovation, about 1 where model and noise hold.
    excess : variance of the residual over that of the stated noise.
    state : (fields,) after the last row.
    """

    name: str
    t: NDArray[np.float64]
    value: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    innovation: NDArray[np.float64]
    innovation_sd: NDArray[np.float64]
    status: NDArray[np.int32]
    unknowns: dict[str, Value]
    parameters: dict[str, Value]
    verdict: str
    reason: str
    consistency: float
    excess: float
    state: NDArray[np.float64]

    def __str__(self) -> str:
        return estimate_text(self)


def estimate_of(
    estimator: Any,
    t: NDArray,
    outputs: NDArray,
    status: NDArray,
    state: NDArray,
) -> Estimate:
    """Read an estimator's outputs and last state.

    Parameters
    ----------
    t : (n,) [s].   outputs : (n, fields), status : (n,), state : (fields,), as the step left them.
    """
    library = estimator.library

    def column(name: str) -> NDArray:
        return outputs[:, library.index("output", name)]

    value, sd = column("estimate"), np.sqrt(np.maximum(column("variance"), 0.0))
    innovation, spread = column("innovation"), np.sqrt(column("innovation_variance"))
    mean, covariance = _last(estimator, state, value[-1], sd[-1])
    used = innovation != 0
    late = used & (np.arange(len(t)) > len(t) // 5)
    consistency = float(np.mean((innovation[late] / spread[late]) ** 2)) if late.any() else float("nan")
    excess = float(
        state[library.index("state", "noise_scale" if estimator.choice.kind == "population" else "excess")]
    )
    verdict, reason = _verdict(estimator, status, float(np.sqrt(covariance[0, 0])), excess)
    return Estimate(
        estimator.unknowns[0],
        t,
        value,
        value * np.exp(-WIDE * sd),
        value * np.exp(WIDE * sd),
        innovation,
        spread,
        status,
        _unknowns(estimator, mean, covariance),
        _parameters(estimator, mean, covariance),
        verdict,
        reason,
        consistency,
        excess,
        state,
    )


def _last(estimator: Any, state: NDArray, value: float, sd: float) -> tuple[NDArray, NDArray]:
    """Unknowns (q,) in the estimator's order and covariance (q, q) of their logarithms."""
    prior, library = estimator.prior, estimator.library
    if estimator.choice.kind == "regression":
        mean, covariance = prior.mean.copy(), prior.covariance.copy()
        mean[0] = value
        covariance[0, :] = covariance[:, 0] = 0.0
        covariance[0, 0] = sd**2
        return mean, covariance
    order = list(library.layout.COORDINATES)
    n = len(order)
    upper = np.zeros((n, n))
    first = library.index("state", "P")
    upper[np.triu_indices(n)] = state[first : first + n * (n + 1) // 2]
    full = upper + np.triu(upper, 1).T
    at = [order.index(name) for name in prior.names]
    mean = np.array([state[library.index("state", name)] for name in prior.names])
    return mean, full[np.ix_(at, at)]


def _unknowns(estimator: Any, mean: NDArray, covariance: NDArray) -> dict[str, Value]:
    prior, units = estimator.prior, {u.name: u.unit for u in estimator.reduced.reduction.unknowns}
    sds = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    return {n: _value(mean[i], sds[i], prior.std[i], units[n]) for i, n in enumerate(prior.names)}


def _parameters(estimator: Any, mean: NDArray, covariance: NDArray) -> dict[str, Value]:
    fewest, model = estimator.fewest, estimator.model
    order = [estimator.prior.names.index(n) for n in fewest.prior.names]
    values, spread = fewest.parameters(mean[order], covariance[np.ix_(order, order)])
    knowledge = fewest.knowledge
    before, after = np.sqrt(np.diag(knowledge.covariance)), np.sqrt(np.maximum(np.diag(spread), 0.0))
    return {
        n: _value(values[i], after[i], before[i], model.quantity(n).unit)
        for i, n in enumerate(knowledge.names)
        if n in knowledge.uncertain
    }


def _value(value: float, sd: float, prior_sd: float, unit: str) -> Value:
    ends = sorted((float(value * np.exp(-WIDE * sd)), float(value * np.exp(WIDE * sd))))
    return Value(float(value), ends[0], ends[1], float(sd), float(prior_sd), unit)


def _verdict(estimator: Any, status: NDArray, sd: float, excess: float) -> tuple[str, str]:
    names = np.array(NAMES)[status]
    rejected = float(np.mean(np.isin(names, ("no_measurement", "bad_sample", "restarted"))))
    name, before = estimator.unknowns[0], float(estimator.prior.std[0])
    told = f"sd of ln {name} {sd:.3g}, {before:.3g} before"
    if not np.isfinite(sd):
        return "diverged", "the estimate is no number"
    if rejected > REJECTED:
        return "bad_data", f"{100 * rejected:.0f} % of the samples could not be used"
    if np.mean(names[-max(len(names) // 10, 1) :] == "at_limit") > 0.5:
        return "outside_population", f"an unknown sits at the edge of what the prior allows; {told}"
    if excess > NOISY:
        return (
            "outside_model",
            f"the residual is {np.sqrt(excess):.2g} times the stated noise: noise or model is not as stated",
        )
    if sd > TOLD * before:
        return "not_excited", f"the log says too little; {told}"
    return ("identified", told) if sd <= NARROW else ("weak", told)
