"""Numbers of the population filter for a vehicle and a log: prior, sensor and design constants.

Invariant: every number of the configuration is either a design constant below, with its reason,
or comes from the prior, the vehicle or the log, and is reported under ``assumed``.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from similitude.accelerometer import Accelerometer
from similitude.population import Prior
from similitude.program.library import Library

GRAVITY = 9.80665  # m/s^2
MEASURED_STEER_SD = 0.02  # scale of a measured road-wheel angle, and of the wheelbase
COMMANDED_STEER_SD = 0.20  # a command, not a measurement: play, compliance and servo gain in between

DESIGN = {
    "input_offset_sd": 0.02,  # rad: alignment and centring
    "output_bias_sd": 0.005,  # rad/s: an automotive gyro after start-up
    "v_star_sd": 0.03,  # sideslip after a restart [-]; 0.1 would start a saturating tyre at its limit
    "r_star_sd": 0.1,  # path curvature times wheelbase after a restart [-]
    "drift": 1e-4,  # 1/s: tyre temperature and load, 8 % in a minute; jumps are found by surprise
    "idle_drift": 2e-3,  # 1/s: unheard, K returns to the population within minutes
    "jump_drift": 0.03,  # 1/s per unit of surprise: a halved stiffness is followed within a second
    "bias_drift": 1e-10,  # (rad/s)^2/s
    "timing_error": 0.010,  # s: steer and gyro are sampled by different clocks
    "companion_rate": 1.0,  # 1/s: slow against the gyro's noise, fast enough for an unstable car
    "offset_rate": 1 / 5.0,  # 1/s: an offset taken for steering teaches wrong; a faster one is noisy
    "structure_share": 0.01,  # the linear model is wrong by 1 % of the response ...
    "structure_time": 0.3,  # s ... and stays wrong the same way this long
    "activity_rate": 1 / 0.3,  # 1/s
    "disturbance_floor": 1e-3,  # rad: crosswind and camber
    "disturbance_share": 0.003,  # of the response; more, and whoever steers much is taken to be pushed
    "disturbance_rate": 1 / 1.2,  # 1/s: a gust, a crown, a rut
    "disturbance_adapt": 1 / 5.0,  # 1/s
    "disturbance_scale_start": 1.0,  # less takes a gust of the first seconds for the car, for good
    "disturbance_scale_low": 0.002,
    "disturbance_scale_high": 25.0,
    "noise_adapt": 1 / 20.0,  # 1/s
    "noise_scale_low": 0.01,  # noise stated ten times too large or too small is put right
    "noise_scale_high": 100.0,
    "excitation_ratio": 0.02,  # a sensitivity of a seventh of the noise, about 0.25 mrad of steer
    "excitation_rate": 1 / 5.0,  # 1/s
    "seldom": 0.015,  # s: every other sample of 100 a second; all of them would be overconfident
    "beyond_time": 0.2,  # s: past 0.3 g the tyre law errs first; 0.05 lets visits move K, 0.3 predicts worse
    "slow_doubt": 1.75,  # in 80 s errors of eta, rho and the steer scale grow to 2 to 3 of their sd
    "surprise_rate": 1 / 0.5,  # 1/s
    "jump_ratio": 8.0,  # a car that is always restless must surprise more
    "surprise_limit": 1.5,  # the mean of 50 squared innovations is 1 with sd sqrt(2/50) = 0.2
    "heard_rate": 1 / 5.0,  # 1/s: where a drive says little, a jump shows in seconds or not at all
    "faint_drift": 5e-3,  # 1/s: a jump that could not have shown may have come, one by half in 100 s
    "inv_telling": 1 / 60.0,  # from an information of 60 a halved stiffness shows at once
    "observed_least": 0.1,
    "outlier_ratio": 9.0,  # three sd, as the monitor's: kerbs and blows
    "gap": 1.0,  # s
    "input_limit": 1.3,  # rad
    "output_limit": 12.0,  # rad/s
    "signal_limit": 150.0,  # m/s
    "validity_limit": 0.3 * GRAVITY,  # m/s^2: the linear tyre (paper, section 2)
    "validity_rate": 2 / 0.3,  # 1/s
}
LIMIT_SD = 2.5  # of every slow unknown
ACCELEROMETER = {
    "ay_bias_sd": 0.436,  # m/s^2: mounting and roll that stays 0.3, a superelevated curve 0.3, wind 0.1
    "ay_bias_drift": 0.0785,  # (m/s^2)^2/s: twice variance over correlation time, of bank 5 s, of wind 0.5 s
    "ay_share": 0.05,  # roll of the body adds gravity, 5 % of what it feels
    "ay_time": 0.3,  # s: as structure does; after 0.1 a lost half shows up to 5 s late in a car that leans
    "ay_noise_scale_low": 1.0,  # less would undo that: what is alike looks as small as white, and is believed
    "ay_noise_scale_high": 100.0,
    "ay_limit": 60.0,  # m/s^2
}
# A small filter knows no scale or offset of the steer angle: ay makes up for it, where it is believed.
SMALL_ACCELEROMETER = ACCELEROMETER | {"ay_time": 0.1, "ay_noise_scale_low": 0.01}
GRIP = (GRAVITY, 0.15)  # m/s^2, and sd of its logarithm: dry roads to good tyres; never printed
LIMIT_SD_TARGET = 3.0  # of the first, with room for a halved stiffness
ROOM = 0.5  # of ln K


def longest(values: Mapping[str, float]) -> float:
    """Longest time a sample may count for in an average [s]: no weight exceeds one.

    Parameters
    ----------
    values : the rates [1/s] and times [s] of a small filter's configuration, by name.
    """
    from similitude.estimators.filter_lean import TURNS  # with symbolic algebra, for a small filter alone

    slow = ("disturbance_adapt", "noise_adapt", "excitation_rate")  # of so many samples at once
    rates = [v for n, v in values.items() if n.endswith("_rate")] + [TURNS * values[n] for n in slow]
    times = [values[n] for n in ("structure_time", "ay_time") if n in values]
    return min(1 / max(rates), 2 * min(times))


def filter_config(
    library: Library,
    prior: Prior,
    *,
    L: float,
    noise_std: float,
    input_scale_sd: float,
    accelerometer: Accelerometer | None = None,
    **changes: float,
) -> NDArray[np.float64]:
    """The flat configuration of the bicycle's population filter.

    Parameters
    ----------
    library : the compiled filter.
    prior : of K, pi1, eta, rho.
    L : wheelbase [m].
    noise_std : white noise of the yaw rate a sample [rad/s].
    input_scale_sd : sd of the steer angle's scale [-].
    accelerometer : of the filter that takes lateral acceleration; the others do not look at it.
    changes : design constants to replace, by name.
    """
    if "grip_prior" in library.names("config"):
        prior = prior.beside("grip", "log", *GRIP, "dry road")
    prior, further = _with_accelerometer(library, prior, accelerometer, L)
    widths = LIMIT_SD * prior.std
    widths[0] = LIMIT_SD_TARGET * np.hypot(prior.std[0], ROOM)
    low, high = prior.limits(widths)
    values = {
        "L": L,
        "P_prior": prior.covariance[np.triu_indices(len(prior.names))],
        "prior_information": 1 / prior.covariance[0, 0],
        "noise_variance": noise_std**2,
        "input_scale_sd": input_scale_sd,
        "input_scale_low": np.exp(-LIMIT_SD * input_scale_sd),
        "input_scale_high": np.exp(LIMIT_SD * input_scale_sd),
    }
    for i, name in enumerate(prior.names):
        values |= {f"{name}_prior": prior.mean[i], f"{name}_low": low[i], f"{name}_high": high[i]}
    told = {row[0] for row in library.layout.CONFIG}  # a small filter asks for less
    own = {name: value for name, value in {**DESIGN, **further, **values}.items() if name in told} | changes
    return library.config({**({"longest": longest(own)} if "longest" in told else {}), **own})


def _with_accelerometer(
    library: Library, prior: Prior, accelerometer: Accelerometer | None, L: float
) -> tuple[Prior, dict[str, float]]:
    """Prior and numbers of a filter that takes lateral acceleration; those of the others are left alone."""
    names = library.names("config")
    if "ay_limit" not in names or accelerometer is None:
        return prior, {}
    white = {"ay_variance": accelerometer.noise**2}
    behind, sd = accelerometer.behind / L, accelerometer.behind_sd / L
    if "place_prior" in names:
        return prior.beside("place", "linear", behind, sd, "stated"), ACCELEROMETER | white
    centre = prior.mean[prior.names.index("pi1")]  # a small filter: ahead of it
    small = SMALL_ACCELEROMETER | white
    return prior.beside("lead", "linear", centre - behind, sd, "stated", as_of="pi1"), small
