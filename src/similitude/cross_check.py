"""The population filter checked by an estimator of another kind: `robust` on the same log.

    d = ln K of robust, its frozen groups at what the filter found - ln K of the filter over the same time
    sd(d)^2 = g' P g + scatter + noise + lag + form + STRUCTURE^2,   g = d(ln K of robust)/dx, -1 for ln K

P is the filter's own covariance of (ln K, frozen groups, steer scale), so what both take from the
population or the steer angle is counted once: an error they share cancels. What is left between two
estimators that read a log so differently, one its whole response and one its answer to a change of steer,
is an error of the structure: steer scale, lag, saturated tyres, a wrong wheelbase.

Invariant: nothing is said where robust was not carried by the drive.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from similitude.estimators.ladder_design import MEMORY
from similitude.filter_run import Pass, side_by_side
from similitude.identify_setup import UNITS, Prepared
from similitude.ladder_passes import NOISE_DOUBT, Rung, RungPass, form_error, rung
from similitude.run import CrossCheck, positive_estimate
from similitude.vehicle_prior import NAMES

APART = 3.0  # sd of the difference beyond which it is the structure's
STRUCTURE = 0.04  # of ln K: what two sound estimators may differ by for reasons of discretisation and form
UNSEEN_LAG = 0.010  # s: sd of a lag that the log does not speak for
LEAST_KNOWN = 0.25  # sd of ln K of robust beyond which it says too little to check anything
SCALE = "input_scale"


def cross_check(ready: Prepared, done: Pass) -> CrossCheck | None:
    """Compare the filter's K with that of robust over the same stretch of the log.

    Parameters
    ----------
    ready : Prepared    the log with prior, noise and lag.
    done : Pass         of the population filter over it.

    Returns
    -------
    CrossCheck          None where the drive does not carry robust, or there is no compiler.
    """
    if ready.setup.library.why_slow:
        return None
    one, passes = _passes(ready, done)
    weights = _weights(one)
    if not weights.any():
        return None
    now = one.ln_K[-1]
    filtered = float(weights @ np.log(done.output("estimate")) / weights.sum())
    gradient = np.array([-1.0, *_slopes(one, passes, ready)])
    P = done.covariance([*NAMES, SCALE])
    spread = {
        "both": float(gradient @ P @ gradient),
        "scatter": float(one.output("variance")[-1]),
        "noise": (NOISE_DOUBT * (now - passes["noise"].ln_K[-1])) ** 2,
        "lag": _lag(one, passes, done, ready) ** 2,
        "form": float(form_error(one)[-1]) ** 2,
        "structure": STRUCTURE**2,
    }
    own = np.sqrt(spread["scatter"] + spread["noise"] + spread["form"])
    if own > LEAST_KNOWN:
        return None
    apart, std = float(now - filtered), float(np.sqrt(sum(spread.values())))
    known = np.sqrt(own**2 + gradient[1:] @ P[1:, 1:] @ gradient[1:])
    taught = one.output("unknowns")
    return CrossCheck(
        K=positive_estimate(float(np.exp(now)), float(known), UNITS["K"]),
        population=positive_estimate(float(np.exp(filtered)), float(np.sqrt(P[0, 0])), UNITS["K"]),
        apart=apart,
        std=std,
        unknowns=int(taught[taught > 0][-1]),
        structure_error=abs(apart) > APART * std,
    )


def sentence(check: CrossCheck) -> str:
    """What a disagreement means, for people."""
    return (
        f"two estimators disagree: the population filter reads K = {check.population.value:.3g} m^2/s^2, a "
        f"regression on what a change of steer does at once {check.K.value:.3g} ({100 * np.expm1(check.apart):+.0f} "
        f"%, {abs(check.apart) / check.std:.1f} sd of their difference): an error of the structure, which no "
        "interval holds; the scale of the steer angle, a steer lag, saturated tyres or a wrong wheelbase are "
        "the usual causes"
    )


def _passes(ready: Prepared, done: Pass) -> tuple[RungPass, dict[str, RungPass]]:
    """Robust with the filter's groups, and again with each of what it takes for granted changed."""
    found = np.array([done.value(name) for name in NAMES])
    start = rung("robust", ready.setup, replace(ready.prior, mean=found))
    start = replace(start, changes={"K_start": found[0], **_limits(start, ready)})
    changed: dict[str, Rung] = {"one": start, "noise": replace(start, compensated=False)}
    sd = np.sqrt(np.diag(done.covariance(list(NAMES))))
    for i, name in enumerate(NAMES[1:]):
        step = np.zeros(3)
        step[i] = sd[1 + i]
        changed |= {f"{name} up": start.at(step), f"{name} down": start.at(-step)}
    scale = 1.0 + ready.setup.input_scale_sd
    changed |= {
        "scale up": replace(start, steer_factor=scale),
        "scale down": replace(start, steer_factor=1 / scale),
        "lag": start.at_lag(ready.scan.chosen + _lag_sd(ready)),
    }
    ends = side_by_side([each.run for each in changed.values()])
    passes = dict(zip(changed, ends, strict=True))
    return passes.pop("one"), passes


def _limits(start: Rung, ready: Prepared) -> dict[str, float]:
    """Limits of K as the prior has them, not around where the filter ended."""
    mean, found = float(ready.prior.mean[0]), float(start.prior.mean[0])
    width = 3.0 * float(np.hypot(ready.prior.std[0], 0.5))
    return {"K_low": min(mean, found) * np.exp(-width), "K_high": max(mean, found) * np.exp(width)}


def _slopes(one: RungPass, passes: dict[str, RungPass], ready: Prepared) -> NDArray[np.float64]:
    """d(ln K of robust)/dx of pi1, ln eta, ln rho and the steer scale, (4,)."""
    base = one.rung.prior.coordinates(one.rung.prior.mean)
    slopes = []
    for i, name in enumerate(NAMES[1:], start=1):
        up, down = passes[f"{name} up"], passes[f"{name} down"]
        step = (up.rung.prior.coordinates(up.rung.prior.mean) - base)[i]
        slopes.append((up.ln_K[-1] - down.ln_K[-1]) / (2 * step))
    scale = np.log(1.0 + ready.setup.input_scale_sd)
    slopes.append((passes["scale up"].ln_K[-1] - passes["scale down"].ln_K[-1]) / (2 * scale))
    return np.array(slopes)


def _lag_sd(ready: Prepared) -> float:
    if ready.scan.origin == "assumed":
        return UNSEEN_LAG
    return max(ready.scan.std, 1e-4)


def _lag(one: RungPass, passes: dict[str, RungPass], done: Pass, ready: Prepared) -> float:
    """How the difference moves with the lag, for one sd of it."""
    later = ready.setup.with_lag(ready.scan.chosen + _lag_sd(ready), ready.setup.input_scale_sd).run()
    moved = np.log(later.output("estimate")[-1] / done.output("estimate")[-1])
    return float(passes["lag"].ln_K[-1] - one.ln_K[-1] - moved)


def _weights(one: RungPass) -> NDArray[np.float64]:
    """What each row weighs in the estimate at the end, (n,)."""
    gained = np.diff(one.output("information_gained"), prepend=0.0)
    taught = one.output("unknowns") > 0
    ago = (np.cumsum(taught[::-1])[::-1] - 1) * one.rung.sample_time
    return np.where(taught, gained * np.exp(-ago / MEMORY), 0.0)
