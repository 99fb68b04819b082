"""Prediction as a judge: yaw rate one second ahead, with the estimate of that moment.

Invariant: the prediction is the estimator's own step run without measurements from a copied state;
nothing is simulated a second way.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.filter_run import Setup

HORIZON = 1.0  # s
FROZEN = {"excitation_ratio": 1e30, "idle_drift": 0.0, "drift": 0.0}  # groups held, biases follow


def predict_ahead(setup: Setup) -> dict[str, float]:
    """Root mean square error of the yaw rate one second ahead [rad/s].

    Against the frozen averages of the population (with offset and bias followed) and the
    kinematic yaw rate U delta/L; the steer and speed that were driven are used.

    Returns
    -------
    dict    ``horizon_s``, ``predictions``, ``rms_rad_s``, ``frozen_rms_rad_s``,
            ``kinematic_rms_rad_s``, ``ratio_to_frozen``; zeros where nothing could be judged.
    """
    own, measured, kinematic = _ahead(setup, setup.config())
    frozen, _, _ = _ahead(setup, setup.config(**FROZEN))
    fine = np.isfinite(own) & np.isfinite(frozen) & np.isfinite(measured) & np.isfinite(kinematic)
    rms = [
        float(np.sqrt(np.mean((x[fine] - measured[fine]) ** 2))) if fine.any() else 0.0
        for x in (own, frozen, kinematic)
    ]
    return {
        "horizon_s": HORIZON,
        "predictions": int(fine.sum()),
        "rms_rad_s": rms[0],
        "frozen_rms_rad_s": rms[1],
        "kinematic_rms_rad_s": rms[2],
        "ratio_to_frozen": rms[0] / rms[1] if rms[1] > 0 else 1.0,
    }


def _ahead(
    setup: Setup, config: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Predicted and measured yaw rate a second after every half second, and the kinematic one."""
    library, log = setup.library, setup.log
    samples = setup.samples()
    blind = samples.copy()
    blind[:, 3] = np.nan
    per_second = max(2, round(HORIZON / float(np.median(setup.dt))))
    starts = np.arange(0, len(samples) - per_second, max(1, per_second // 2))
    codes = library.layout.STATUS
    column = library.index("output", "predicted")
    bias = library.index("state", "output_bias")
    state = library.start(config)
    predicted, kinematic = np.full(len(starts), np.nan), np.full(len(starts), np.nan)
    at = 0
    for i, start in enumerate(starts):
        _, status = library.run(config, state, samples[at : start + 1])
        at = start + 1
        if status[-1] in (codes["too_slow"], codes["bad_sample"], codes["no_measurement"]):
            continue
        ahead = state.copy()
        end = start + per_second
        outputs, later = library.run(config, ahead, blind[at : end + 1])
        if log.t[end] - log.t[start] > 1.5 * HORIZON or (later == codes["too_slow"]).any():
            continue
        predicted[i] = outputs[-1, column]
        kinematic[i] = log.U[end] * samples[end, 1] / setup.L + state[bias]
    return predicted, log.r[starts + per_second], kinematic
