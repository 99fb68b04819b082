"""Verdict: what a result is worth, as a code and one sentence in the user's terms.

Invariant: the sentence holds the numbers the verdict was decided on.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.log import Log
from similitude.log_cells import slower_by
from similitude.population import Prior
from similitude.run import Trace
from similitude.status import STATUS

VERDICTS = (
    "identified",
    "weak",
    "not_excited",
    "outside_model",
    "outside_population",
    "bad_data",
    "diverged",
)
LINEAR = 0.3 * 9.80665  # m/s^2, the linear range of a tyre (paper, section 2)
IDENTIFIED_STD = 0.15  # of ln K
PRIOR_SHARE = 0.5  # of the prior's sd
REJECTED_SHARE = 0.20
NOTED_SHARE = 0.10  # of the information: where it is more, softer tyres have a say in K
OUTSIDE_SHARE = 0.50  # of the information, beyond the linear range
CONTRADICTION = 25.0  # noise variance against what the sensor explains: five sd for one
POPULATION_SD = 2.5
WORDS = {
    "pi1": "the centre of gravity (pi1)",
    "eta": "the rear axle's stiffness against the front's (eta)",
    "rho": "the yaw inertia (rho)",
}
ROAD_ROOM = np.log(4.0)  # ln K may lie this much further down: ice is a road too


@dataclass(frozen=True, eq=False)
class Evidence:
    """What a verdict rests on; arrays are (n,) over the log."""

    ln_K_std: float
    prior_std: float
    ln_K_away: float  # ln of K over the population's
    information: NDArray[np.float64]  # cumulative
    outside: NDArray[np.bool_]  # rows beyond the linear range
    status: NDArray[np.int32]
    rejected: float  # share of rows that could not be used for want of a value
    noise_scale: float  # against the sensor's noise
    at_limit: tuple[str, ...] = ()  # groups that ended at the edge of the population
    finite: bool = True


def evidence(
    log: Log, trace: Trace, prior: Prior, *, noise_scale: float = 1.0, at_limit: tuple[str, ...] = ()
) -> Evidence:
    """Collect what a verdict rests on from an estimator's trace over a log."""
    missing = _unmeasured(log.r) | ~(np.isfinite(log.delta) & np.isfinite(log.U))
    return Evidence(
        ln_K_std=float(trace.ln_K_std[-1]),
        prior_std=float(prior.std[0]),
        ln_K_away=float(np.log(trace.K[-1] / prior.mean[0])),
        information=trace.information,
        outside=np.abs(trace.ay_kinematic) > LINEAR,
        status=trace.status,
        rejected=float(np.mean(missing | (trace.status == STATUS["bad_sample"]))),
        noise_scale=noise_scale,
        at_limit=at_limit,
        finite=bool(np.isfinite(trace.K).all() and np.isfinite(trace.ln_K_std).all()),
    )


def _unmeasured(rate: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Rows without a yaw rate, save those between two values of a sensor that is slower than the file."""
    missing = ~np.isfinite(rate)
    every = slower_by(rate) if missing.any() else None
    if every is None:
        return missing
    known = np.flatnonzero(~missing)
    last = np.searchsorted(known, np.arange(rate.size), side="right") - 1
    return (last < 0) | (np.arange(rate.size) - known[np.maximum(last, 0)] > every + 1)


def verdict(e: Evidence) -> tuple[str, str]:
    """Code and reason; the first that applies in the order of severity."""
    sd = f"{100 * e.ln_K_std:.3g} %"
    if e.rejected > REJECTED_SHARE:
        return "bad_data", (
            f"{100 * e.rejected:.3g} % of the samples had no usable value, more than 20 %; "
            "mend the recording first."
        )
    if not e.finite:
        return "diverged", "The estimate is not finite; please report this log."
    slow = float(np.mean(e.status == STATUS["too_slow"]))
    strange = _outside_the_population(
        e
    )  # no straight road drives an estimate there, however wide it is by now
    if e.ln_K_std > PRIOR_SHARE * e.prior_std and not strange:
        return "not_excited", _not_excited(e, sd, slow)
    share = _outside_share(e)
    if share > OUTSIDE_SHARE:
        return "outside_model", (
            f"{100 * share:.3g} % of what was learnt came from beyond 0.3 g, where tyres are no longer "
            f"linear; K, ± {sd} (one sd), is an average slope, not the stiffness at small slip."
        )
    if e.noise_scale > CONTRADICTION:
        return "outside_model", (
            f"The yaw rate differs from every car of the population by {np.sqrt(e.noise_scale):.3g} times "
            "the sensor's noise; steer scale, units or a saturating tyre are the usual causes."
        )
    if strange:
        return "outside_population", _outside_population(e)
    if e.ln_K_std <= IDENTIFIED_STD:
        return "identified", f"The drive shows the stiffness to ± {sd} (one sd)."
    return "weak", (
        f"The drive shows the stiffness to ± {sd} (one sd), which is not yet the 15 % that counts as "
        "identified; more steering or a measured steer angle would help."
    )


def is_usual(ln_K_away: float, prior_std: float) -> bool:
    """Whether a K so far from the population's (logarithms) is one that its cars have on some road."""
    room = POPULATION_SD * prior_std
    return -room - ROAD_ROOM < ln_K_away < room


def _outside_the_population(e: Evidence) -> bool:
    return bool(e.at_limit) or not is_usual(e.ln_K_away, e.prior_std)


def linear_doubts(e: Evidence) -> tuple[str, ...]:
    """A warning where much, but not most, of the information came from beyond the linear range."""
    share = _outside_share(e)
    if not NOTED_SHARE < share <= OUTSIDE_SHARE:
        return ()
    return (
        f"{100 * share:.2g} % of what was learnt came from beyond 0.3 g, where tyres give way: K may read "
        "low, and further off than its interval says; a gentler drive would settle it",
    )


def _not_excited(e: Evidence, sd: str, slow: float) -> str:
    if slow > 0.5:
        return (
            f"The vehicle was too slow for its tyres to show in {100 * slow:.3g} % of the log; K is known to "
            f"± {sd}, hardly better than the population's ± {100 * e.prior_std:.0f} %."
        )
    return (
        f"The steering says too little: K is known to ± {sd}, against ± {100 * e.prior_std:.0f} % before the "
        "drive. A lane change or two at speed would settle it."
    )


def _outside_population(e: Evidence) -> str:
    if e.at_limit:
        which = " and ".join(WORDS.get(name, name) for name in e.at_limit)
        return (
            f"{which[:1].upper()}{which[1:]} ended at the edge of what the population allows; a wrong "
            "wheelbase, steering ratio or population is the usual cause."
        )
    return (
        f"K is {np.exp(e.ln_K_away):.3g} times the population's, further than its spread allows; the "
        "scale of the steer angle is the usual cause, since K and steer scale trade."
    )


def _outside_share(e: Evidence) -> float:
    """Share of the information gained on rows beyond the linear range."""
    gained = np.diff(e.information, prepend=0.0)
    total = float(gained.sum())
    return float(gained[e.outside].sum()) / total if total > 0 else 0.0
