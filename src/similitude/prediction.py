"""Prediction as a judge: yaw rate one second ahead, with the estimate of that moment.

Invariant: the prediction is the estimator's own step run without measurements from a copied state;
nothing is simulated a second way.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.filter_run import Setup

HORIZON = 1.0  # s
FROZEN = {"excitation_ratio": 1e30, "idle_drift": 0.0, "drift": 0.0}  # groups held, biases follow


def predict_ahead(setup: Setup) -> dict[str, Any]:
    """Root mean square error of the yaw rate one second ahead [rad/s].

    Against the frozen averages of the population (with offset and bias followed) and the
    kinematic yaw rate U delta/L; the steer and speed that were driven are used.

    Returns
    -------
    dict    ``horizon_s``, ``predictions`` (how many were judged), ``unit``, ``rms`` by what
            predicted (``estimate``, ``frozen_averages``, ``kinematic``) and ``ratio_to_frozen``;
            None where nothing could be judged.
    """
    own, measured, kinematic = _ahead(setup, setup.config())
    frozen, _, _ = _ahead(setup, setup.config(**FROZEN))
    fine = np.isfinite(own) & np.isfinite(frozen) & np.isfinite(measured) & np.isfinite(kinematic)
    predicted = {"estimate": own, "frozen_averages": frozen, "kinematic": kinematic}
    rms = {name: _rms((x - measured)[fine]) for name, x in predicted.items()}
    judged = bool(fine.any()) and rms["frozen_averages"] > 0
    return {
        "horizon_s": HORIZON,
        "predictions": int(fine.sum()),
        "unit": "rad/s",
        "rms": rms,
        "ratio_to_frozen": rms["estimate"] / rms["frozen_averages"] if judged else None,
    }


def _rms(errors: NDArray[np.float64]) -> float | None:
    return float(np.sqrt(np.mean(errors**2))) if errors.size else None


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
