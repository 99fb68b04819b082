"""Does the steer turn the car as its wheelbase asks, and does it move as freely as a wheel?

Invariant: only said; neither the log nor the estimate is changed. The same checks stand on the page
of `inspect`, here they reach the reader who asks for a stiffness at once.

    delta road wheel angle [rad];  r yaw rate [rad/s];  U speed [m/s];  L wheelbase [m]
"""

from __future__ import annotations

import numpy as np

from similitude.inspection.channels import channel
from similitude.inspection.doubts import find_coarse_steer, find_cut_steer, find_wrong_scale
from similitude.inspection.follow import yaw_behind_steer
from similitude.inspection.signals import even_signals
from similitude.inspection.slow_relation import slow_relation, usual_understeer
from similitude.inspection.timing import timing
from similitude.log import Log
from similitude.vehicle_file import Vehicle


# Angles near 1e308 are damage and stay damage when they are squared.
@np.errstate(over="ignore", invalid="ignore")
def steer_scale_doubts(log: Log, vehicle: Vehicle) -> tuple[str, ...]:
    """Compare steer and yaw rate where the car drives gently.

    Parameters
    ----------
    log : Log            t [s], delta [rad], r [rad/s], U [m/s]
    vehicle : Vehicle    with L [m], else only the steer by itself is judged

    Returns
    -------
    tuple of str         warnings: the steer is cut off or coarse; a scale of steer or speed that is wrong
    """
    header = log.sources.get("delta", "delta [rad]")
    found = []
    steer = channel(log.delta, header=header, unit="rad", taken_for="delta")
    if not any(one.fault == "clipped" for one in log.findings):
        found += find_cut_steer(steer)
    if np.isfinite(log.delta).any():
        found += find_coarse_steer(steer, float(np.nanstd(log.delta)))
    signals = even_signals({"t": log.t, "delta": log.delta, "r": log.r, "U": log.U}, timing(log.t))
    if signals is not None and vehicle.L is not None:
        behind = yaw_behind_steer(signals)
        lag = behind.lag if behind is not None and behind.lag is not None else 0.0
        slow = slow_relation(signals, lag=lag, understeer=usual_understeer(vehicle))
        found += find_wrong_scale(slow, vehicle.L.value, header, at_wheel=False)
    return tuple(one.warning for one in found)
