"""Passes over a log whose steer acts late, by as much as nobody stated: what that leaves open of K.

Invariant: the pass that is reported is that of the chosen lag and servo; the others only widen its interval.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.filter_run import Pass, Setup, side_by_side
from similitude.steer_lag import LagScan


def passes(setup: Setup, scan: LagScan) -> tuple[Pass, NDArray[np.float64]]:
    """The pass over a log, and the sd of ln K from what is open of lag and servo, (n,).

    Parameters
    ----------
    setup : Setup      with the chosen lag and servo.
    scan : LagScan     its sd, for a measured steer; its other servos, for a command.

    Returns
    -------
    done, ln_K_std     half the difference of the passes at one sd of lag to both sides, or the weighted
                       spread of those behind the other servos; zeros where the lag was stated.
    """
    if scan.others:
        return _behind_others(setup, scan)
    if scan.std == 0:
        return setup.run(), np.zeros(setup.log.samples)
    lags = [scan.chosen, scan.chosen + scan.std, scan.chosen - scan.std]
    at_lags = [setup.with_lag(lag, setup.input_scale_sd) for lag in lags]
    done, *sides = side_by_side([at_lag.run for at_lag in at_lags])
    later, earlier = (np.log(side.output("estimate")) for side in sides)
    return done, np.abs(later - earlier) / 2


def behind_servos(setup: Setup, scan: LagScan) -> float:
    """Sd of ln K at the end of a log over the servos it may have been; 0 where the steer was measured."""
    return float(_behind_others(setup, scan)[1][-1]) if scan.others else 0.0


def _behind_others(setup: Setup, scan: LagScan) -> tuple[Pass, NDArray[np.float64]]:
    others = [
        setup.with_servo(x.servo).with_lag(max(scan.chosen + x.later, 0.0), setup.input_scale_sd)
        for x in scan.others
    ]
    done, *behind = side_by_side([one.run for one in (setup, *others)])
    chosen = np.log(done.output("estimate"))
    squares = [
        x.weight * (np.log(one.output("estimate")) - chosen) ** 2
        for x, one in zip(scan.others, behind, strict=True)
    ]
    return done, np.sqrt(np.sum(squares, axis=0))
