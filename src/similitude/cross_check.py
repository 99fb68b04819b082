"""The population filter checked by an estimator of another kind: `robust` on the same log.

    d  = K of robust, its frozen groups at what the filter found, over K of the filter, less one
    d0 = the same with robust's groups at the population's averages
    sd^2 of d  = g' P g + own;     sd^2 of d0 = g' P0 g + own,     g = d(ln K of robust)/dx, -1 for ln K

P is the filter's covariance of (ln K, frozen groups, steer scale), so an error that both share, the steer
scale's among them, is counted once; P0 has the population's covariance of the groups in place of the
filter's. ``own`` is robust's scatter, noise and form, the lag's part of the difference, how the filter's K
moved over the stretch, and `STRUCTURE`.

d0 counts where four unknowns are carried: one unknown takes all groups from the averages, far off linear.

d asks whether one car explains both the whole response and the answer to a change of steer; d0 whether a
car of the population does. What either cannot explain is an error of the structure.

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
STRUCTURE = 0.015  # of K: what sound estimators differ by for reasons of discretisation and form
UNSEEN_LAG = 0.010  # s: greatest sd of a lag that the log does not speak for
LEAST_KNOWN = 0.25  # sd of ln K of robust beyond which it says too little to check anything
RATE = 100.0  # Hz: quicker logs are averaged, a car's yaw motion does not notice
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
    ready = replace(ready, setup=ready.setup.at_rate(RATE))
    one, passes = _passes(ready, done)
    weights = _weights(one)
    if not weights.any():
        return None
    weights /= weights.sum()
    along = np.interp(ready.setup.log.t, done.setup.log.t, np.log(done.output("estimate")))
    filtered = float(weights @ along)
    gradient = np.array([-1.0, *_slopes(passes, done, ready)])
    ratio = float(np.exp(one.ln_K[-1] - filtered))
    alone = (
        float(one.output("variance")[-1])
        + (NOISE_DOUBT * float(one.ln_K[-1] - passes["noise"])) ** 2
        + float(form_error(one)[-1]) ** 2
    ) * min(ratio, 1.0) ** 2  # of K of the filter: one that reads next to nothing is sure of that
    if alone > LEAST_KNOWN**2:
        return None
    own = alone + _lag(one, passes, done, ready) ** 2 + STRUCTURE**2
    own += float(weights @ (along - filtered) ** 2)
    P = done.covariance([*NAMES, SCALE])
    P0 = P.copy()
    P0[1:4, 1:4] = ready.prior.covariance[1:, 1:]
    std, average_std = (float(np.sqrt(gradient @ Q @ gradient + own)) for Q in (P, P0))
    average = _relative(passes["averages"] - filtered)
    taught = one.output("unknowns")
    unknowns = int(taught[taught > 0][-1])
    within = gradient[1:] @ P[1:, 1:] @ gradient[1:]
    known = float(np.sqrt(alone / min(ratio, 1.0) ** 2 + within))
    return CrossCheck(
        K=positive_estimate(ratio * float(np.exp(filtered)), known, UNITS["K"]),
        population=positive_estimate(float(np.exp(filtered)), float(np.sqrt(P[0, 0])), UNITS["K"]),
        apart=_relative(float(np.log(ratio))),
        std=std,
        average_apart=average,
        average_std=average_std,
        unknowns=unknowns,
        structure_error=_beyond(_relative(float(np.log(ratio))), std)
        or (unknowns == 4 and _beyond(average, average_std)),
    )


def _beyond(apart: float, std: float) -> bool:
    return abs(apart) > APART * std


def _relative(away: float) -> float:
    """A difference of logarithms as a share of the filter's K; upwards it stays the logarithm."""
    return float(np.expm1(away)) if away < 0 else away


def sentence(check: CrossCheck) -> str:
    """What a disagreement means, for people."""
    groups = "" if abs(check.apart) > APART * check.std else " with the population's average groups"
    apart, std = (check.average_apart, check.average_std) if groups else (check.apart, check.std)
    return (
        f"two estimators disagree: the population filter reads K = {check.population.value:.3g} m^2/s^2; "
        f"what a change of steer does at once reads {100 * apart:+.0f} % of that{groups}, "
        f"{abs(apart) / std:.1f} sd of their difference. That is an error of the structure, which no "
        "interval holds: steer lag, scale of the steer angle or a wrong wheelbase are the usual causes"
    )


def _passes(ready: Prepared, done: Pass) -> tuple[RungPass, dict[str, float]]:
    """Robust with the filter's groups, and its last ln K with each thing taken for granted changed."""
    found = np.array([done.value(name) for name in NAMES])
    start = rung("robust", ready.setup, replace(ready.prior, mean=found))
    acting = done.value(SCALE)
    changes = {"K_start": found[0], **_limits(start, ready)}
    start = replace(start, steer_factor=acting, changes=changes)
    changed: dict[str, Rung] = {"noise": replace(start, compensated=False)}
    sd = np.sqrt(np.diag(done.covariance(list(NAMES))))
    for i, name in enumerate(NAMES[1:]):
        step = np.zeros(3)
        step[i] = sd[1 + i]
        changed |= {f"{name} up": start.at(step), f"{name} down": start.at(-step)}
    scale = 1.0 + ready.setup.input_scale_sd
    changed |= {
        "scale up": replace(start, steer_factor=acting * scale),
        "scale down": replace(start, steer_factor=acting / scale),
        "lag": start.at_lag(ready.scan.chosen + _lag_sd(ready)),
        "averages": replace(start, prior=ready.prior),
    }
    ends = side_by_side([lambda each=each: float(each.run().ln_K[-1]) for each in changed.values()])
    return start.run(), dict(zip(changed, ends, strict=True))


def _limits(start: Rung, ready: Prepared) -> dict[str, float]:
    """Limits of K as the prior has them, not around where the filter ended."""
    mean, found = float(ready.prior.mean[0]), float(start.prior.mean[0])
    width = 3.0 * float(np.hypot(ready.prior.std[0], 0.5))
    return {"K_low": min(mean, found) * np.exp(-width), "K_high": max(mean, found) * np.exp(width)}


def _slopes(passes: dict[str, float], done: Pass, ready: Prepared) -> NDArray[np.float64]:
    """d(ln K of robust)/dx of pi1, ln eta, ln rho and the steer scale, (4,)."""
    steps = [*np.sqrt(np.diag(done.covariance(list(NAMES[1:])))), np.log(1.0 + ready.setup.input_scale_sd)]
    names = (*NAMES[1:], "scale")
    return np.array(
        [(passes[f"{n} up"] - passes[f"{n} down"]) / (2 * s) for n, s in zip(names, steps, strict=True)]
    )


def _lag_sd(ready: Prepared) -> float:
    """Sd of the lag [s]; of one that the log does not speak for, as the scan's cost rises from none."""
    scan = ready.scan
    if scan.origin != "assumed":
        return max(scan.std, 1e-4)
    chance = np.gradient(scan.lags) * np.exp(-(scan.cost - scan.cost.min()))  # far lags lie wider apart
    wide = float(np.sqrt(chance @ scan.lags**2 / chance.sum()))
    rise = float(scan.cost[1] - scan.cost[0])
    narrow = float(scan.lags[1]) / np.sqrt(2 * rise) if rise > 0 else np.inf
    return min(max(wide, narrow) if np.isfinite(narrow) else wide, UNSEEN_LAG)


def _lag(one: RungPass, passes: dict[str, float], done: Pass, ready: Prepared) -> float:
    """How the difference moves with the lag, for one sd of it."""
    later = done.setup.with_lag(ready.scan.chosen + _lag_sd(ready), ready.setup.input_scale_sd).run()
    moved = np.log(later.output("estimate")[-1] / done.output("estimate")[-1])
    return float(passes["lag"] - one.ln_K[-1] - moved)


def _weights(one: RungPass) -> NDArray[np.float64]:
    """What each row weighs in the estimate at the end, (n,)."""
    gained = np.diff(one.output("information_gained"), prepend=0.0)
    taught = one.output("unknowns") > 0
    ago = (np.cumsum(taught[::-1])[::-1] - 1) * one.rung.sample_time
    return np.where(taught, gained * np.exp(-ago / MEMORY), 0.0)
