"""Numbers of a population filter for any model: prior, sensor, units, and constants paced by the system.

What the filter counts in samples (averages of innovations) is scaled by the sample time against the 10 ms
its constants were found at; what it counts in the system's own time by how long the output keeps to itself.

Invariant: every field of the configuration gets a value, and each that a user may want to state is listed
with its origin.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from similitude.any_model.fewest_unknowns import FewestUnknowns
from similitude.any_model.trial import Trial
from similitude.filter_config import DESIGN
from similitude.population import Prior
from similitude.program.library import Library

SAMPLE = 0.01  # s, and time a yaw rate keeps to itself [s]: what DESIGN was found at
KEPT = 0.3
LIMIT_SD = 4.0  # of every unknown: beyond it the population does not hold
ROOM = 20.0  # times the greatest value of the trial: what is believed of input and output
HEAT = 300.0  # noise variance the first sample is weighed with, over its own, at least
WARM_TOLD = 1000.0  # information about an unknown, in its prior's, that the warm part may bring
WARM = 0.1  # of the planned drive: how long that takes to fall by e
BY_SAMPLE = ("noise_adapt", "surprise_rate", "gap", "seldom")
BY_OUTPUT = ("activity_rate", "structure_time", "disturbance_rate", "disturbance_adapt", "excitation_rate",
             "companion_rate", "heard_rate")  # fmt: skip


@dataclass(frozen=True)
class Doubts:
    """What may be wrong besides the unknowns, each an sd; None is filled in and said.

    Parameters
    ----------
    noise : of the output a sample, white [SI].
    input_error : scale of the input [-].    input_offset : [SI].    output_bias : [SI].
    disturbance : equivalent input that nobody measured [SI].
    model_error : of the response, share that stays wrong the same way [-].
    drift : of the identified unknown's logarithm in one second [1/sqrt(s)]; 0: it does not change.
    """

    noise: float
    input_error: float | None = None
    input_offset: float | None = None
    output_bias: float | None = None
    disturbance: float | None = None
    model_error: float | None = None
    drift: float | None = None


def filter_numbers(
    library: Library, fewest: FewestUnknowns, prior: Prior, trial: Trial, doubts: Doubts
) -> tuple[np.ndarray, dict[str, tuple[float, str, str]]]:
    """The flat configuration, and what was taken from where.

    Parameters
    ----------
    library : the compiled filter.
    prior : of the unknowns in the filter's order.

    Returns
    -------
    config (fields,), assumed : name -> value, unit, where from.
    """
    model = fewest.reduction.groups.model
    units = {row[0]: row[1] for row in library.layout.CONFIG}
    swing = float(np.sqrt(np.mean((trial.u - trial.u.mean()) ** 2))) or float(np.abs(trial.u).max()) or 1.0
    told, assumed = _doubts(doubts, swing, model.inputs[0].unit, model.outputs[0].unit)
    values: dict[str, float | np.ndarray] = {n: v for n, v in DESIGN.items() if n in units}
    by_sample, by_output = trial.step / SAMPLE, max(trial.step / SAMPLE, trial.slowest / KEPT)
    for names, pace in ((BY_SAMPLE, by_sample), (BY_OUTPUT, by_output)):
        values |= {n: values[n] * (pace if units[n] == "s" else 1 / pace) for n in names if n in units}
    values |= _prior_values(prior)
    values |= {n: v for n, v in fewest.units.items() if n in units}
    values |= _sensor_values(told, swing, trial)
    for k, q in enumerate(model.states):
        spread = float(np.ptp(trial.states[:, k])) / 2 / fewest.units[f"{q.name}_unit"]
        values[f"{q.name}_star_sd"] = spread or 1e-3
    values |= {
        "heat_start": _heat(fewest, trial, doubts.noise),
        "heat_rate": 1 / (WARM * trial.step * len(trial.u)),
    }
    values |= {
        "signal_limit": ROOM * max([0.05, *fewest.signals.values()]),
        "validity_rate": 2 / (KEPT * by_output),
    }
    if model.validity is not None:
        values["validity_limit"] = _limit_of(model)
    else:
        values["validity_limit"] = 1.0
    return library.config({n: v for n, v in values.items() if n in units}), assumed


def _doubts(doubts: Doubts, swing: float, unit_in: str, unit_out: str) -> tuple[dict, dict]:
    usual = {
        "input_error": (1e-3, "-", "taken: a calibrated input"),
        "input_offset": (0.01 * swing, unit_in, "taken: 1 % of the planned input's rms"),
        "output_bias": (doubts.noise, unit_out, "taken: as large as the noise"),
        "disturbance": (0.01 * swing, unit_in, "taken: 1 % of the planned input's rms"),
        "model_error": (1e-3, "-", "taken: the model is right to 0.1 %"),
        "drift": (0.0, "1/sqrt(s)", "taken: the system does not change"),
    }
    told = {"noise": doubts.noise}
    assumed = {"noise": (doubts.noise, unit_out, "stated")}
    for name, (value, unit, origin) in usual.items():
        own = getattr(doubts, name)
        told[name] = value if own is None else own
        assumed[name] = (told[name], unit, origin if own is None else "stated")
    return told, assumed


def _prior_values(prior: Prior) -> dict[str, float | np.ndarray]:
    low, high = prior.limits(LIMIT_SD * prior.std)
    values: dict[str, float | np.ndarray] = {
        "P_prior": prior.covariance[np.triu_indices(len(prior.names))],
        "prior_information": 1 / prior.covariance[0, 0],
    }
    for i, name in enumerate(prior.names):
        values |= {f"{name}_prior": prior.mean[i], f"{name}_low": low[i], f"{name}_high": high[i]}
    return values


def _sensor_values(told: Mapping[str, float], swing: float, trial: Trial) -> dict[str, float]:
    scale, drift = max(told["input_error"], 1e-6), told["drift"] ** 2
    return {
        "noise_variance": told["noise"] ** 2,
        "input_scale_sd": scale,
        "input_scale_low": float(np.exp(-LIMIT_SD * scale)),
        "input_scale_high": float(np.exp(LIMIT_SD * scale)),
        "input_offset_sd": told["input_offset"],
        "output_bias_sd": told["output_bias"],
        "bias_drift": 0.0,
        "slow_doubt": 0.0,  # the constants' priors are the user's own, and the intervals cover as they are
        "disturbance_floor": max(told["disturbance"], 1e-9 * swing),
        "disturbance_share": 0.0,
        "structure_share": told["model_error"],
        "timing_error": 0.0,
        "drift": drift,
        "idle_drift": drift,
        "jump_drift": 300 * drift,
        "faint_drift": 0.0,  # a stated drift is no jump
        "excitation_ratio": 1e-4,
        "input_limit": ROOM * float(np.abs(trial.u).max()),
        "output_limit": ROOM
        * (float(np.abs(trial.output).max()) + 5 * told["noise"] + 5 * told["output_bias"]),
    }


def _heat(fewest: FewestUnknowns, trial: Trial, noise: float) -> float:
    """So much that what the drive tells most is not pinned while all unknowns are still guesses."""
    squares = (trial.slopes**2).sum(axis=0) / noise**2 * np.diag(fewest.prior.covariance)
    return max(HEAT, WARM * float(squares.max(initial=0.0)) / WARM_TOLD)


def _limit_of(model) -> float:
    return model.validity[1].value or 1.0
