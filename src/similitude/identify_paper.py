"""The paper's regression applied to a log, with the bias it will have said before its number.

The paper's interval would be the scatter of its least squares alone, a per cent or two. Reported is
the root sum of squares of that scatter, the bias predicted from the noise, the worst error of the
lines in place of the z-coefficients, and what freezing the groups at their averages costs.

Invariant: a number known to be biased is never called identified.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.estimators import paper_design as design
from similitude.estimators.paper_bias import NoiseBias, predicted_bias
from similitude.filter_config import COMMANDED_STEER_SD, MEASURED_STEER_SD
from similitude.filter_run import population_setup
from similitude.log import Log
from similitude.noise import SensorNoise, gyro_noise
from similitude.population import Prior
from similitude.program.library import Library, shipped
from similitude.run import Assumed, Group, Run, Trace, axle_stiffness, held, positive_estimate
from similitude.status import STATUS
from similitude.steer_lag import LagScan, find_lag, is_command
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import vehicle_prior
from similitude.verdict import evidence, verdict

FROZEN_SD = 0.12  # of ln K: groups frozen at averages, over cars of the population
COMMAND_SD = 2 * COMMANDED_STEER_SD  # K answers a wrong steer scale about twice over
UNUSED = ("no_measurement", "too_slow", "bad_sample", "not_excited")


def identify_paper(log: Log, vehicle: Vehicle) -> Run:
    """Run the paper's regression over a log; see `similitude.identification.identify`."""
    prior = vehicle_prior(vehicle)
    library = shipped("bicycle_paper")
    noise, L = gyro_noise(log.r, vehicle.yaw_rate_noise), vehicle.L.value
    sample_time = float(np.median(np.diff(log.t)))
    config = design.paper_config(
        library,
        sample_time=sample_time,
        L=L,
        speed=float(np.nanmedian(log.U)),
        noise_std=noise.std,
        K_start=float(prior.mean[0]),
        **design.PAPER_GROUPS,
    )
    state = library.start(config)
    setup = population_setup(log, prior, L=L, noise_std=noise.std, input_scale_sd=MEASURED_STEER_SD)
    scan = find_lag(setup, vehicle)
    samples = setup.with_lag(scan.chosen, MEASURED_STEER_SD).samples()
    outputs, status = library.run(config, state, samples)
    speed = float(state[library.index("state", "last_U")]) or 1.0
    bias = predicted_bias(library, config, state, L=L, noise_std=noise.std, pi3=prior.mean[0] / speed**2)
    T = design.dimensionless_step(sample_time, speed, L)
    off = known_errors(T, bias, is_command(scan, vehicle))
    trace = _trace(library, log, outputs, status, off)
    code, reason = verdict(evidence(log, trace, prior))
    K = positive_estimate(trace.K[-1], trace.ln_K_std[-1], "m^2/s^2")
    return Run(
        log=log,
        vehicle=vehicle,
        estimator="paper",
        trace=trace,
        verdict=code,
        reason=reason,
        K=K,
        pi3={"value": trace.pi3[-1], "std": trace.pi3_std[-1], "at_speed": speed},
        groups={"K": _group(K.value, K.std, prior)},
        nuisance={},
        lag=scan,
        prediction=_one_step(trace, sample_time),
        handling={},
        warnings=(*log.warnings, *_warnings(library, bias, T)),
        assumed=_assumed(vehicle, noise, bias, sample_time, scan),
        Caf=axle_stiffness(vehicle, K),
    )


def _line_error(T: float) -> float:
    """Worst relative error of the lines over the paper's range of pi3 [-]."""
    groups = design.PAPER_GROUPS
    return design.linearity_error(T, groups["pi1"], groups["pi4_slope"], groups["pi5"])["worst"]


def known_errors(T: float, bias: NoiseBias, command: bool) -> float:
    """Sd of ln K from what is known to be wrong, beside the scatter."""
    noise = np.log(max(1.0 + bias.relative, 1e-3))
    return float(np.sqrt(noise**2 + _line_error(T) ** 2 + FROZEN_SD**2 + (COMMAND_SD * command) ** 2))


def _trace(library: Library, log: Log, outputs: NDArray, status: NDArray[np.int32], off: float) -> Trace:
    def output(name: str) -> NDArray[np.float64]:
        return outputs[:, library.index("output", name)]

    K, std = output("estimate"), np.hypot(np.sqrt(output("variance")), off)
    U = held(log.U)
    used = ~np.isin(status, [STATUS[name] for name in UNUSED])
    return Trace(
        t=log.t,
        K=K,
        ln_K_std=std,
        pi3=output("pi3"),
        pi3_std=output("pi3") * std,
        r_measured=log.r,
        r_predicted=output("predicted"),
        innovation=np.where(used, output("innovation"), np.nan),
        innovation_std=np.sqrt(output("innovation_variance")),
        information=_gained(K, output("variance"), output("innovation_variance"), used),
        U=U,
        ay_kinematic=U * output("predicted"),
        status=status,
    )


def _gained(K: NDArray, variance: NDArray, spread: NDArray, used: NDArray) -> NDArray[np.float64]:
    """Information gained about ln K up to each row, from what the estimator hands out, (n,) [-].

    1/variance is K^2/spread times the weighted sum of squared regressors; of that sum each update forgets a
    share and adds its own square.
    """
    squares = spread / (variance * K**2)
    kept = design.DESIGN["forgetting"] * np.concatenate([squares[:1], squares[:-1]])
    return np.cumsum(np.where(used, np.maximum(squares - kept, 0.0) * K**2 / spread, 0.0))


def _group(value: float, std: float, prior: Prior) -> Group:
    mean = float(prior.mean[0])
    return Group(value, std, mean, mean * float(prior.std[0]), "Caf L/m, pi3 U^2 of the regression")


def _one_step(trace: Trace, sample_time: float) -> dict[str, Any]:
    fine = np.isfinite(trace.innovation)
    rms = float(np.sqrt(np.mean(trace.innovation[fine] ** 2))) if fine.any() else None
    return {
        "horizon_s": sample_time,
        "predictions": int(fine.sum()),
        "unit": "rad/s",
        "rms": {"estimate": rms},
    }


def _warnings(library: Library, bias: NoiseBias, T: float) -> list[str]:
    groups = design.PAPER_GROUPS
    lines = [
        f"before the number: {bias.text}",
        design.linearity_warning(T, groups["pi1"], groups["pi4_slope"], groups["pi5"]),
        f"groups frozen at their averages: K is off by {100 * FROZEN_SD:.0f} % (one sd) from car to car",
    ]
    if library.why_slow:
        lines.append(f"running the scalar Python twin, {library.why_slow}")
    return [line for line in lines if line]


def _assumed(
    vehicle: Vehicle, noise: SensorNoise, bias: NoiseBias, sample_time: float, scan: LagScan
) -> dict[str, Assumed]:
    stated = vehicle.yaw_rate_noise is not None
    frozen = {name: Assumed(value, "-", design.SOURCE) for name, value in design.PAPER_GROUPS.items()}
    return frozen | {
        "L": Assumed(vehicle.L.value, "m", vehicle.origins.get("L", "vehicle file")),
        "sample_time": Assumed(sample_time, "s", "median step of the log"),
        "yaw_rate_noise": Assumed(noise.std, "rad/s", "vehicle file" if stated else "the log itself"),
        "noise_bias": Assumed(bias.relative, "-", "predicted from the noise and the regressor's power"),
        "steer_lag": Assumed(scan.chosen, "s", scan.origin),
        "forgetting_factor": Assumed(design.DESIGN["forgetting"], "-", "the paper, section 6"),
        "dead_zone": Assumed(design.DESIGN["dead_zone"], "rad/s", "the paper, section 5"),
    }
