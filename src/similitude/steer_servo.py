"""The servo behind a commanded steer, found from the log together with the lag.

A command reaches the wheels late (bus, computer) and then as fast as a motor turns them. A pure lag in
place of both is right on average and wrong at every quick turn of the wheel.

Invariant: a measured steer angle has no servo; where the log says nothing, a command's is the usual one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from similitude.filter_config import COMMANDED_STEER_SD
from similitude.filter_run import Setup
from similitude.servo import DIRECT, Servo
from similitude.steer_lag import RATE, STEP, LagScan, Otherwise, costs, lag_behind, losses

CONSTANTS = (0.0, 0.015, 0.03, 0.045, 0.06, 0.08, 0.11)  # s
SLEWS = (0.5, 0.8, 1.2, 1.8, 2.5, 3.2, 4.2, 6.0, np.inf)  # rad/s of the road wheels
# Small servos turn 60 degrees in 0.1 to 0.2 s; 3.2 rad/s is what F1/10 simulators have for the road wheels.
USUAL = Servo(0.040, 3.2)
CONSTANT_LOG_SD, SLEW_LOG_SD = 0.7, 0.8
QUICKEST = Servo(0.010, 10.0)  # no servo at all is as unusual as one so quick
STEPS = (-STEP, -STEP / 2, STEP / 2, STEP)  # s
ROUNDS = 3
MOST = 12  # other servos that K is worked out with


@dataclass(frozen=True)
class _Trial:
    servo: Servo
    lag: float  # s

    @property
    def unusual(self) -> float:
        """Negative log of the prior, up to a constant [-]."""
        constant = np.log(max(self.servo.constant, QUICKEST.constant) / USUAL.constant) / CONSTANT_LOG_SD
        slew = np.log(min(self.servo.slew, QUICKEST.slew) / USUAL.slew) / SLEW_LOG_SD
        return 0.5 * float(constant**2 + slew**2)


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
    best = _Trial(DIRECT, scan.chosen)
    best, _ = _best(coarse, best, _with_constants(best, CONSTANTS))
    best, _ = _best(coarse, best, [replace(best, servo=replace(best.servo, slew=slew)) for slew in SLEWS])
    for _ in range(ROUNDS):
        # any time constant: one that was found for another lag or slew may lie behind a rise of the cost
        trials = list(dict.fromkeys(_near(best) + _with_constants(best, CONSTANTS)))
        before, (best, cost) = best, _best(coarse, best, trials)
        if best == before:
            break
    behind = lag_behind(setup.with_servo(best.servo))
    return replace(behind, early=scan.early, others=_others(best, cost))


def _others(best: _Trial, cost: Mapping[_Trial, float]) -> tuple[Otherwise, ...]:
    """The most probable of the other trials of the last round."""
    weights = {trial: float(np.exp(cost[best] - x)) for trial, x in cost.items()}
    total = sum(weights.values())
    likely = sorted((x for x in weights if x != best), key=weights.__getitem__, reverse=True)[:MOST]
    return tuple(Otherwise(x.servo, x.lag - best.lag, weights[x] / total) for x in likely)


def _near(trial: _Trial) -> list[_Trial]:
    """One step of time constant, slew and lag to either side: what one loses the others may make up for."""

    def beside(values: tuple[float, ...], value: float) -> tuple[float, ...]:
        at = values.index(value)
        return values[max(at - 1, 0) : at + 2]

    lags = [replace(trial, lag=max(trial.lag + step, 0.0)) for step in STEPS]
    near = _with_constants(trial, beside(CONSTANTS, trial.servo.constant))
    slews = beside(SLEWS, trial.servo.slew)
    return [
        replace(x, servo=replace(x.servo, slew=slew)) for x in dict.fromkeys(lags + near) for slew in slews
    ]


def _with_constants(trial: _Trial, constants: Iterable[float]) -> list[_Trial]:
    """Other time constants with the lag as it was, and as it would have to be for the same delay in all."""
    return [
        _Trial(replace(trial.servo, constant=T), max(trial.lag - share * (T - trial.servo.constant), 0.0))
        for T in constants
        for share in (0.0, 0.5, 1.0)
    ]


def _best(setup: Setup, best: _Trial, others: list[_Trial]) -> tuple[_Trial, dict[_Trial, float]]:
    """The most probable of the trials, and the cost of each, on the rows that all of them can show."""
    tried = [best, *(trial for trial in others if trial != best and trial.lag >= 0)]
    setups = [setup.with_servo(x.servo).with_lag(x.lag, COMMANDED_STEER_SD) for x in tried]
    cost = costs(losses(setups), setup) + [x.unusual for x in tried]
    return tried[int(np.argmin(cost))], dict(zip(tried, cost.tolist(), strict=True))
