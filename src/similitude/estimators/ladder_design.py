"""Numbers of the ladder's own estimators for a sample time, a sensor and a prior.

Invariant: every number of a configuration is given by the caller, is a design constant below with its
reason, or follows from the filters; no scipy.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from similitude.estimators.bessel import bessel_sections, cascade_response
from similitude.population import Prior
from similitude.program.library import Library

GRAVITY = 9.80665  # m/s^2
HIGH_PASS = 45.0  # rad/s, as the paper's: a lower one lets in the slow part that `band` leaves out
LOW_PASS = 90.0  # rad/s: 60 to 120 read within 1 % of one another at 0.5 deg/s, see docs/estimators.md
STATE_FILTER = 40.0  # rad/s, above a car's yaw dynamics, below the noise
SETTLING = 10.0  # time constants that filters are given before they teach
MEMORY = (
    20.0  # s of excited driving: 90 % of a change is followed in 46 s, as by the paper's 0.99995 at 1 kHz
)
JUMP = (0.1, 8.0, 50.0)  # rad/s, noise sd, and rad/s^2 of yaw beyond any car, small ones included
EXCITATION_RATIO = 0.045  # mean square of the drive against the noise's: that of the population filter
SCATTER_SHARE = 1e-3  # of the sensor's own variance: no residual is quieter
SLOW_PI3 = 10.0  # beyond this pi3 the tyres do not show
LIMIT_SD = 3.0  # of ln K, prior and ...
ROOM = 0.5  # ... room for a halved stiffness, together

DESIGN = {
    "excitation_rate": 1 / 5.0,  # 1/s
    "block": 2.0,  # s: gusts, crowns and ruts are over
    "blocks_most": 10.0,
    "variance_limit": 1.0,  # of ln K: a factor e either way is nothing known
    "idle_drift": 2e-3,  # 1/s: unheard, tyre and road may change within minutes
    "input_limit": 1.3,  # rad
    "output_limit": 12.0,  # rad/s
    "signal_limit": 150.0,  # m/s
    "validity_limit": 0.3 * GRAVITY,  # m/s^2: the linear tyre (paper, section 2)
}
OUTPUT_ERROR = {
    "observer_rate": 0.3,  # 1/s: slow against steering, so that the sensitivity is that of the model
    "observer_margin": 4.0,  # 1/s^2: a stable car has 10 and more
    "offset_rate": 0.3,  # 1/s, the same
    "state_limit": 1.0,  # [-]: a sideslip of a radian, a corner of one wheelbase radius
    "move_limit": 0.1,
    "gap": 1.0,  # s
}
ROBUST = {
    "offset_rate": 0.3,  # 1/s: slow against steering
    "signal_least": 10.0,
    "signal_least_one": 1.0,
    "pivot_least": 3e-4,
    "move_limit": 0.1,
}
BAND = {"signal_least": 0.1}


def ladder_config(
    library: Library,
    prior: Prior,
    *,
    sample_time: float,
    L: float,
    noise_std: float,
    memory: float = MEMORY,
    compensated: bool = True,
    **changes: float,
) -> NDArray[np.float64]:
    """The flat configuration of ``bicycle_band``, ``bicycle_output_error`` or ``bicycle_robust``.

    Parameters
    ----------
    library : the compiled estimator.
    prior : of K, pi1, eta, rho; K starts at its mean, the rest is frozen there.
    sample_time : [s]; of ``band`` and ``robust`` a step from half to one and a half of it counts.
    L : wheelbase [m].
    noise_std : white noise of the yaw rate a sample [rad/s], > 0.
    memory : time of excited driving over which the past fades to 1/e [s].
    compensated : whether the noise's own share is taken out of the sums.
    changes : any field of the configuration to replace, by name.

    Raises
    ------
    ProgramError    a value is missing, not finite or not a field.
    """
    own: dict[str, Callable[[float, float, float], dict]] = {
        "bicycle_band": _band,
        "bicycle_output_error": _output_error,
        "bicycle_robust": _robust,
    }
    width = LIMIT_SD * math.hypot(prior.std[0], ROOM)
    start = float(prior.mean[0])
    values: dict = {**DESIGN, **own[library.name](sample_time, noise_std, memory)}
    if not compensated and library.name != "bicycle_output_error":
        values["noise_variance"] = 0.0
    values |= {name: float(prior.mean[i]) for i, name in enumerate(prior.names) if i}
    values |= {
        "L": L,
        "K_start": start,
        "U_least": math.sqrt(start / SLOW_PI3),
        "K_low": start * math.exp(-width),
        "K_high": start * math.exp(width),
        "block_keep": math.exp(-1.0 / DESIGN["blocks_most"]),
        "output_jump": JUMP[0] + JUMP[1] * noise_std + JUMP[2] * sample_time,
    }
    if library.name == "bicycle_output_error":
        values["start_variance"] = float(prior.covariance[0, 0])
    return library.config(values | changes)


def _timed(sample_time: float, memory: float, settling: float) -> dict[str, float]:
    return {
        "sample_time": sample_time,
        "forgetting": math.exp(-sample_time / memory),
        "settle_samples": max(3, math.ceil(settling / sample_time)),
        "dt_low": 0.5 * sample_time,
        "dt_high": 1.5 * sample_time,
    }


@lru_cache
def band_pass(sample_time: float) -> tuple[NDArray[np.float64], float, float]:
    """Sections of the band-pass (4, 5), and the autocorrelation of its impulse response at lags 0 and 1.

    Parameters
    ----------
    sample_time : [s].
    """
    kinds = (("high", HIGH_PASS), ("low", LOW_PASS))
    sections = np.vstack([bessel_sections(kind, corner, sample_time) for kind, corner in kinds])
    impulse = np.zeros(math.ceil(4 * SETTLING / HIGH_PASS / sample_time) + 64)
    impulse[0] = 1.0
    passed = cascade_response(sections, impulse)
    return sections, float(passed @ passed), float(passed[1:] @ passed[:-1])


def _band(sample_time: float, noise_std: float, memory: float) -> dict:
    sections, zero, one = band_pass(sample_time)
    own = 2 * (zero - one) * noise_std**2
    return {
        **_timed(sample_time, memory, SETTLING / HIGH_PASS),
        **BAND,
        **{f"biquad_{i}": row for i, row in enumerate(sections, start=1)},
        "noise_variance": noise_std**2,
        "noise_zero": zero,
        "noise_one": one,
        "excitation_least": EXCITATION_RATIO * own,
        "scatter_low": SCATTER_SHARE * own,
    }


@lru_cache
def state_filter_moments(sample_time: float, corner: float = STATE_FILTER) -> dict[str, float]:
    """Moments of white noise of unit variance behind the four stages and their derivatives.

    Parameters
    ----------
    sample_time : [s].
    corner : of each stage [rad/s].

    Returns
    -------
    moments : ``value``, ``rate``, ``change`` the variances of the output and its first and second
        derivative [1, 1/s^2, 1/s^4], ``value_rate``, ``value_change``, ``rate_change`` the covariances.
    """
    turn = corner * sample_time
    keep, share = (2 - turn) / (2 + turn), turn / (2 + turn)
    x = np.zeros(math.ceil(40 / turn) + 64)
    x[0] = 1.0
    stages = [x]
    for _ in range(4):
        passed, before, old = np.empty_like(x), 0.0, 0.0
        for i, now in enumerate(stages[-1].tolist()):
            before, old = keep * before + share * (now + old), now
            passed[i] = before
        stages.append(passed)
    value = stages[4]
    rate = corner * (stages[3] - stages[4])
    change = corner**2 * (stages[2] - 2 * stages[3] + stages[4])
    pairs = {
        "value": (value, value), "rate": (rate, rate), "change": (change, change),
        "value_rate": (value, rate), "value_change": (value, change), "rate_change": (rate, change),
    }  # fmt: skip
    return {name: float(a @ b) for name, (a, b) in pairs.items()}


def _robust(sample_time: float, noise_std: float, memory: float) -> dict:
    moments = state_filter_moments(sample_time)
    own = moments["change"] * noise_std**2
    return {
        **_timed(sample_time, memory, SETTLING / STATE_FILTER),
        **ROBUST,
        "corner": STATE_FILTER,
        "noise_variance": noise_std**2,
        **{f"noise_{name}": value for name, value in moments.items()},
        "excitation_least": EXCITATION_RATIO * own,
        "scatter_low": SCATTER_SHARE * own,
    }


def _output_error(sample_time: float, noise_std: float, memory: float) -> dict:
    gap = OUTPUT_ERROR["gap"]
    return {
        **{name: value for name, value in OUTPUT_ERROR.items() if name != "gap"},
        "forgetting_rate": 1.0 / memory,
        "settle_samples": max(3, math.ceil(0.5 / sample_time)),
        "dt_low": 1e-6,
        "dt_high": gap,
        "noise_variance": noise_std**2,
        "excitation_least": EXCITATION_RATIO * noise_std**2,
        "scatter_low": SCATTER_SHARE * noise_std**2,
    }
