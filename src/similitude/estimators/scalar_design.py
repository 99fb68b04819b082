"""Numbers of the one-unknown filter: what the population's averages leave open, and the constants.

Invariant: what freezing costs is computed from the population's covariance, not chosen.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from similitude.estimators.ladder_design import DESIGN, EXCITATION_RATIO, JUMP, LIMIT_SD, ROOM, SLOW_PI3
from similitude.population import Prior
from similitude.program.library import Library

CONSTANTS = {
    "drift": 1e-3,  # 1/s: a tyre warms, a road changes
    "structure_time": 0.3,  # s: gusts and what the model leaves out last so long
    "scatter_rate": 1 / 5.0,  # 1/s
    "offset_rate": 0.3,  # 1/s: slow against steering
    "observer_rate": 0.3,  # 1/s: the same
    "move_limit": 0.1,
    "excitation_rate": DESIGN["excitation_rate"],
    **{
        n: DESIGN[n]
        for n in ("variance_limit", "input_limit", "output_limit", "signal_limit", "validity_limit")
    },
}
SETTLING = 0.5  # s
STEERING = np.linspace(0.2, 1.0, 17)  # Hz, in which people steer
SPEED = 25.0  # m/s at which it is worked out
SMALL = 1e-4  # relative step of a difference


def scalar_config(
    library: Library, prior: Prior, *, sample_time: float, L: float, noise_std: float, **changes: float
) -> NDArray[np.float64]:
    """The flat configuration of ``bicycle_scalar_population``.

    Parameters
    ----------
    library : the estimator.
    prior : of K, pi1, eta, rho; the last three are frozen at their means.
    sample_time : [s]; steps from half to one and a half of it count as one sample.
    L : wheelbase [m].
    noise_std : white noise of the yaw rate a sample [rad/s], > 0.
    changes : any field of the configuration to replace, by name.

    Raises
    ------
    ProgramError    a value is missing, not finite or not a field.
    """
    start, width = float(prior.mean[0]), LIMIT_SD * math.hypot(prior.std[0], ROOM)
    values = {
        **CONSTANTS,
        **{name: float(prior.mean[i]) for i, name in enumerate(prior.names) if i},
        "L": L,
        "sample_time": sample_time,
        "K_start": start,
        "K_low": start * math.exp(-width),
        "K_high": start * math.exp(width),
        "start_variance": float(prior.covariance[0, 0]),
        "frozen_variance": frozen_variance(prior, L),
        "noise_variance": noise_std**2,
        "excitation_least": EXCITATION_RATIO * noise_std**2,
        "settle_samples": max(3, math.ceil(SETTLING / sample_time)),
        "dt_low": 0.5 * sample_time,
        "dt_high": 1.5 * sample_time,
        "U_least": math.sqrt(start / SLOW_PI3),
        "output_jump": JUMP[0] + JUMP[1] * noise_std + JUMP[2] * sample_time,
    }
    return library.config(values | changes)


def frozen_variance(prior: Prior, L: float) -> float:
    """Variance of ln K that comes of holding pi1, eta and rho at the population's means [-].

    A car whose other groups are off by dg answers a steer differently; the K that explains the answer best is
    off by b dg with b = <G_K, G_g>/<G_K, G_K>, G_x the response's slope by ln K or g over what people steer.
    """
    point = np.array([math.log(prior.mean[0]), *map(float, prior.mean[1:])])
    slopes = []
    for i in range(len(point)):
        step = SMALL * (1.0 if i == 0 else point[i])
        ends = [response(point + sign * step * np.eye(len(point))[i], L) for sign in (-1, 1)]
        slopes.append((ends[1] - ends[0]) / (2 * step))
    own = slopes[0]
    by = [(np.vdot(own, s) / np.vdot(own, own)).real for s in slopes[1:]]
    to_log = [
        1.0 if name == "pi1" else float(m) for name, m in zip(prior.names[1:], prior.mean[1:], strict=True)
    ]
    b = np.array(by) * np.array(to_log)
    return float(b @ prior.covariance[1:, 1:] @ b)


def response(point: NDArray[np.float64], L: float) -> NDArray[np.complex128]:
    """Yaw rate per steer [1/s] at ln K, pi1, eta, rho over `STEERING` (science: eq 20 in these groups)."""
    K, pi1, eta, rho = math.exp(point[0]), *point[1:]
    rear = 1 - pi1
    k, pi5, pi3 = eta * pi1 / rear, rho * pi1 * rear, K / SPEED**2
    s = 2j * np.pi * STEERING * L / SPEED
    damping = 1 + k + (pi1**2 + rear**2 * k) / pi5
    above = pi3 * pi1 / pi5 * s + pi3**2 * k / pi5
    below = s**2 + pi3 * damping * s + pi3 * (rear * k - pi1) / pi5 + pi3**2 * k / pi5
    return SPEED / L * above / below
