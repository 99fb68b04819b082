"""Prediction as a judge: yaw rate one second ahead, with the estimate of that moment.

Invariant: the prediction is the estimator's own step run without measurements from a copied state;
nothing is simulated a second way.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.batch_fit import BatchFit
from similitude.batch_pass import FROZEN
from similitude.filter_run import LINEAR, Setup, side_by_side
from similitude.program.library import shipped
from similitude.servo import DIRECT

HORIZON = 1.0  # s
MOST = 600  # predictions, about: five minutes twice a second; of a longer log they lie further apart


@dataclass(frozen=True, eq=False)
class _Start:
    """Configuration, state before the first row, and rows (n, 4) of what predicts."""

    setup: Setup
    config: NDArray[np.float64]
    state: NDArray[np.float64]
    rows: NDArray[np.float64]
    K: NDArray[np.float64] | None = None  # (n,) put in place of the state's own before each prediction


def predict_ahead(
    setup: Setup,
    batch: BatchFit | None = None,
    *,
    average_lag: float | None = None,
    recursive: bool = True,
    K: NDArray[np.float64] | None = None,
) -> dict[str, Any]:
    """Root mean square error of the yaw rate one second ahead [rad/s].

    Against the average car with linear tyres (with offset and bias followed), the same with the steer
    lag and servo of this log, the batch fit's car with its own offset and bias (it has seen the whole
    log, the future included), and the kinematic yaw rate U delta/L; the steer and speed that were driven
    are used.

    Parameters
    ----------
    setup : Setup        of the log.
    batch : BatchFit     of the same log, or None.
    average_lag : float  steer lag of the average car [s]; without one the lag and servo of the log.
    recursive : bool     whether the estimate that is judged is the filter's; else it is the batch fit's.
    K : (n,)             another estimator's K at every row [m^2/s^2], to be judged in place of the filter's;
                         the other groups are the population's averages, offset and bias are followed.

    Returns
    -------
    dict    ``horizon_s``, ``predictions`` (how many were judged), ``unit``, ``rms`` by what predicted
            (``estimate``, ``frozen_averages``, ``averages_with_lag``, ``batch``, ``kinematic``),
            ``ratio_to_frozen``, ``ratio_to_averages_with_lag`` and ``ratio_to_batch``; None where
            nothing could be judged.
    """
    in_step = replace(setup, library=shipped(LINEAR))
    usual = in_step
    if average_lag is not None:
        usual = in_step.with_servo(DIRECT).with_lag(average_lag, setup.input_scale_sd)
    starts = {
        "frozen_averages": _started(usual, **FROZEN),
        "averages_with_lag": _started(in_step, **FROZEN),
    }
    if K is not None:
        starts["estimate"] = replace(_started(in_step, **FROZEN), K=K)
    elif recursive:
        starts["estimate"] = _started(setup)
    if batch is not None:
        held = replace(batch.frozen, setup=replace(setup, library=batch.frozen.setup.library))
        config, state = held.ready(batch.x, batch.scales, zero=batch.zero, held=True)
        starts["batch"] = _Start(held.setup, config, state, held.rows(batch.x))
    done = side_by_side([lambda start=start: _ahead(start) for start in starts.values()])
    ahead = dict(zip(starts, done, strict=True))
    if not recursive and K is None:
        ahead["estimate"] = ahead["batch"]
    _, measured, kinematic = ahead["estimate"]
    order = ("estimate", "frozen_averages", "averages_with_lag", *(["batch"] if batch is not None else []))
    predicted = {name: ahead[name][0] for name in order} | {"kinematic": kinematic}
    fine = np.isfinite(measured) & np.logical_and.reduce([np.isfinite(x) for x in predicted.values()])
    rms = {name: _rms((x - measured)[fine]) for name, x in predicted.items()}
    return {
        "horizon_s": HORIZON,
        "predictions": int(fine.sum()),
        "unit": "rad/s",
        "rms": rms,
        "ratio_to_frozen": _ratio(rms["estimate"], rms["frozen_averages"]),
        "ratio_to_averages_with_lag": _ratio(rms["estimate"], rms["averages_with_lag"]),
        "ratio_to_batch": _ratio(rms["estimate"], rms.get("batch")),
    }


def _started(setup: Setup, **changes: float) -> _Start:
    config = setup.config(**changes)
    return _Start(setup, config, setup.library.start(config), setup.samples())


def _ratio(one: float | None, other: float | None) -> float | None:
    return one / other if one is not None and other else None


def _rms(errors: NDArray[np.float64]) -> float | None:
    return float(np.sqrt(np.mean(errors**2))) if errors.size else None


def _ahead(start: _Start) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Predicted and measured yaw rate a second after every half second, and the kinematic one."""
    setup = start.setup
    library, log = setup.library, setup.log
    config, state, samples = start.config, start.state, start.rows
    blind = samples.copy()
    blind[:, 3] = np.nan
    per_second = max(2, round(HORIZON / setup.usual_step))
    last = len(samples) - per_second
    moments = np.arange(0, last, max(1, per_second // 2, last // MOST))
    codes = library.layout.STATUS
    column = library.index("output", "predicted")
    bias = library.index("state", "output_bias")
    predicted, kinematic = np.full(len(moments), np.nan), np.full(len(moments), np.nan)
    at, own = 0, library.index("state", "K")
    for i, moment in enumerate(moments):
        if start.K is not None:
            state[own] = start.K[moment]
        _, status = library.run(config, state, samples[at : moment + 1])
        at = moment + 1
        if status[-1] in (codes["too_slow"], codes["bad_sample"], codes["no_measurement"]):
            continue
        ahead = state.copy()
        end = moment + per_second
        outputs, later = library.run(config, ahead, blind[at : end + 1])
        if log.t[end] - log.t[moment] > 1.5 * HORIZON or (later == codes["too_slow"]).any():
            continue
        predicted[i] = outputs[-1, column]
        kinematic[i] = log.U[end] * samples[end, 1] / setup.L + state[bias]
    return predicted, log.r[moments + per_second], kinematic
