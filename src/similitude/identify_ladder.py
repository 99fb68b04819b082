"""The ladder's regressions applied to a log: band, output_error and robust, each with an honest interval.

Invariant: what an estimator takes for granted stands in its interval, row by row (`ladder_passes.doubts`).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.estimators import ladder_design as design
from similitude.identify_setup import Prepared, assumed_of, average_lag, prepare, seen_speed
from similitude.ladder_passes import WORDS, RungPass, doubts, rung
from similitude.log import Log
from similitude.prediction import predict_ahead
from similitude.run import Assumed, Group, Run, Trace, axle_stiffness, held, positive_estimate
from similitude.status import STATUS
from similitude.vehicle_file import Vehicle
from similitude.verdict import evidence, verdict

UNUSED = ("no_measurement", "too_slow", "bad_sample", "restarted", "not_excited")
MEANING = "Caf L/m, the one unknown of the regression"
SMALL = 0.02  # of ln K: a doubt below it is not worth a line


def identify_ladder(log: Log, vehicle: Vehicle, *, estimator: str) -> Run:
    """Run ``band``, ``output_error`` or ``robust`` over a log; see `similitude.identification.identify`."""
    ready = prepare(log, vehicle)
    prior = ready.prior
    done = rung(estimator, ready.setup, prior).run()
    found = doubts(done, ready.scan)
    total = np.sqrt(sum(part**2 for part in found.values()))
    untaught = np.cumsum(done.output("unknowns") > 0) == 0
    total[untaught] = prior.std[0]  # until something is learnt, K is the population's
    trace = trace_of(ready, done, total)
    code, reason = verdict(evidence(log, trace, prior))
    K = positive_estimate(trace.K[-1], trace.ln_K_std[-1], "m^2/s^2")
    mean = float(prior.mean[0])
    return Run(
        log=log,
        vehicle=vehicle,
        estimator=estimator,
        trace=trace,
        verdict=code,
        reason=reason,
        K=K,
        pi3={
            "value": trace.pi3[-1],
            "std": trace.pi3_std[-1],
            "at_speed": float(seen_speed(trace.U[-1], prior)),
        },
        groups={"K": Group(K.value, K.std, mean, mean * float(prior.std[0]), MEANING)},
        nuisance={},
        lag=ready.scan,
        prediction=predict_ahead(ready.setup, K=trace.K, average_lag=average_lag(ready)),
        handling={},
        warnings=(*log.warnings, *_warnings(ready, done, found)),
        assumed=_assumed(ready, estimator, found),
        Caf=axle_stiffness(vehicle, K),
    )


def trace_of(ready: Prepared, done: RungPass, ln_K_std: NDArray[np.float64]) -> Trace:
    """Rows of the log with the pass's outputs; ``ln_K_std`` (n,) is the whole of the doubt."""
    log = ready.setup.log
    U, K = held(log.U), done.output("estimate")
    pi3 = K / seen_speed(U, ready.prior) ** 2
    used = np.isfinite(log.r) & ~np.isin(done.status, [STATUS[n] for n in ("too_slow", "bad_sample")])
    predicted = done.output("predicted")
    return Trace(
        t=log.t,
        K=K,
        ln_K_std=ln_K_std,
        pi3=pi3,
        pi3_std=pi3 * ln_K_std,
        r_measured=log.r,
        r_predicted=predicted,
        innovation=np.where(used, done.output("innovation"), np.nan),
        innovation_std=np.sqrt(done.output("innovation_variance")),
        information=done.output("information_gained"),
        U=U,
        ay_kinematic=U * predicted,
        status=done.status,
    )


def _warnings(ready: Prepared, done: RungPass, found: dict[str, NDArray[np.float64]]) -> list[str]:
    """What a reader should know before the number."""
    unknowns = done.output("unknowns")
    learnt = unknowns > 0
    lines = [_parts(found)] if learnt.any() else []
    if not learnt.any():
        lines.append(_never_learnt(done))
    elif done.rung.library.name == "bicycle_robust" and (unknowns[learnt] < 2).any():
        share = float(np.mean(unknowns[learnt] < 2))
        lines.append(
            f"in {100 * share:.0f} % of the rows that taught, the steer carried one unknown only: K then "
            "rests on all frozen groups, not on two; steering that is less of one frequency carries four"
        )
    if ready.commanded:
        lines.append(
            f"the steer acts {1000 * ready.scan.chosen:.0f} ms after its column says so: it looks like a "
            "command, so its scale is taken as uncertain by 20 %; measure the road wheel to do better"
        )
    if ready.setup.library.why_slow:
        lines.append(f"running the scalar Python twin, {ready.setup.library.why_slow}")
    return lines


def _parts(found: dict[str, NDArray[np.float64]]) -> str:
    ends = {name: float(part[-1]) for name, part in found.items()}
    named = sorted((n for n in ends if ends[n] >= SMALL), key=lambda n: -ends[n])
    if not named:
        return "K is known to its scatter: frozen groups, noise and steer scale move it by less than 2 %"
    return "of the interval's width (one sd of ln K): " + "; ".join(
        f"{100 * ends[n]:.0f} % {WORDS[n]}" for n in named
    )


def _never_learnt(done: RungPass) -> str:
    if done.rung.library.name == "bicycle_band":
        return (
            f"nothing was learnt: this regression listens between {design.HIGH_PASS:.0f} and "
            f"{design.LOW_PASS:.0f} rad/s only, and the steer said too little there; hands on a wheel seldom "
            "do, robust and population hear them"
        )
    return "nothing was learnt: the steer never moved enough against the yaw rate's noise, and K was held"


def _assumed(ready: Prepared, estimator: str, found: dict[str, NDArray[np.float64]]) -> dict[str, Assumed]:
    filters = {
        "band": {
            "high_pass": Assumed(design.HIGH_PASS, "rad/s", "as the paper's"),
            "low_pass": Assumed(design.LOW_PASS, "rad/s", "design constant of the estimator"),
        },
        "robust": {"state_filter": Assumed(design.STATE_FILTER, "rad/s", "design constant of the estimator")},
    }
    own = {
        f"doubt_{name}": Assumed(float(part[-1]), "-", f"sd of ln K: {WORDS[name]}")
        for name, part in found.items()
    }
    memory = Assumed(design.MEMORY, "s", "design constant of the estimator, of excited driving")
    return assumed_of(ready) | {"memory": memory} | filters.get(estimator, {}) | own
