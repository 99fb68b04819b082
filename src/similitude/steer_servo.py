"""The servo behind a commanded steer: its time constant, found from the log together with the lag.

A command reaches the wheels late (bus, computer) and then as fast as a motor turns them. A pure lag in
place of both is right on average and wrong at every quick turn of the wheel.

Invariant: a measured steer angle has no servo; where the log says nothing, a command's is the usual one.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from similitude.filter_config import COMMANDED_STEER_SD
from similitude.filter_run import Setup
from similitude.steer_lag import RATE, LagScan, costs, lag_behind, losses

SERVO = (
    0.040,
    0.7,
)  # s, and sd of its logarithm: 60 degrees in 0.1 to 0.2 s, as hobby and EPS servos have it
TRIED = (0.0, 0.015, 0.03, 0.045, 0.06, 0.08, 0.11)  # s
NONE_IS_LIKE = 0.010  # s: no servo at all is as unusual as one so quick
TRIED_LAGS = (0.0, 0.3, 0.6)  # of the servo, before the lag that was best without one


def find_servo(setup: Setup, scan: LagScan) -> LagScan:
    """Lag and servo of a command; ``scan`` is that of a lag alone.

    Parameters
    ----------
    setup : Setup    of the log, without lag.
    scan : LagScan   whose lag says that the steer is a command.

    Returns
    -------
    LagScan          of the lags behind the servo that was chosen.
    """
    coarse = setup.at_rate(RATE)
    tried = [(T, max(scan.chosen - share * T, 0.0)) for T in TRIED for share in TRIED_LAGS if T or not share]
    cost = costs(losses([coarse.with_servo(T).with_lag(lag, COMMANDED_STEER_SD) for T, lag in tried]), coarse)
    servo = tried[int(np.argmin(cost + [_unusual(T) for T, _ in tried]))][0]
    return replace(lag_behind(setup.with_servo(servo)), early=scan.early)


def _unusual(servo: float) -> float:
    """Negative log of the prior, up to a constant [-]."""
    usual, log_sd = SERVO
    return 0.5 * (float(np.log(max(servo, NONE_IS_LIKE) / usual)) / log_sd) ** 2
