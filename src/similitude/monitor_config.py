"""Numbers of the change alarm: thresholds for a wanted time between false alarms, design constants.

Invariant: every number stands here with its reason; the threshold is the measured one (`make alarms`).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.errors import UsageError
from similitude.program.library import Library

DESIGN = {
    "v_star_sd": 0.1,  # as in the filter
    "r_star_sd": 0.1,
    "disturbance_rate": 1 / 1.2,  # 1/s, as in the filter
    "companion_rate": 0.5,  # 1/s: an unstable car's drive along the steer alone stays near the measured one
    "evidence_floor": 0.5,  # half of it, and the next change is looked for
    "evidence_leak": 1 / 50.0,  # 1/s: a reference that is a little wrong does not add up
    "age_most": 10.0,  # s: what takes longer is not a jump; the reference follows it
    "gain_rate": 1 / 0.1,  # 1/s
    "gain_most": 60.0,  # 1/s: a kerb is over after a tenth of a second
    "piece_most": 5.2,  # so it takes two half-waves
    "piece_share": 0.04,  # or one that says 25 times as much again
    "piece_fit": 0.15,
    "size_least": 0.3,  # ln: less than 26 % is not looked for
    "size_most": 1.2,  # ln: a factor of 3.3
    "size_large": 0.6,  # ln: 45 %
    "small_price": 20.0,  # nine in ten false alarms told less than that before it
    "size_guess": 0.45,
    "size_weight": 20.0,  # the guess is worth an sd of 0.22
    "outlier_ratio": 9.0,  # three sd
    "smooth_rate": 1 / 0.15,  # 1/s: slower than the gyro's noise, faster than the driver
    "rough_rate": 1 / 0.5,  # 1/s
    "rough_free": 10.0,
    "rough_share": 0.2,
    "score_rate": 1.0,  # 1/s
    "distrust_rate": 1 / 60.0,  # 1/s
    "distrust_share": 0.3,
    "sizes_squared": 9.0,  # three sd: less may be the reference's error
    "reference_rate": 1 / 15.0,  # 1/s: slow against an alarm, fast against tyres that warm up
    "known_least": 500.0,  # sd of 4 %, the other unknowns given
    "variance_most": 0.20**2,  # a little more than the verdict "identified" allows
    "heard_least": 20.0,  # s: what a filter has learnt in less may still move
    "heard_spare": 6.0,  # s
    "heard_again": 6.0,  # s
    "hearing_rate": 1 / 5.0,  # 1/s
    "hearing_least": 15.0,  # 1/s: less would take longer than age_most to tell
    "input_limit": 1.3,  # rad, as in the filter
    "output_limit": 12.0,  # rad/s
    "signal_limit": 150.0,  # m/s
    "validity_limit": 4.0,  # m/s^2: a saturating tyre looks like a softer one
    "validity_rate": 1.0,  # 1/s
}
THRESHOLD = 9.5
BETWEEN_FALSE_ALARMS = 16.0  # h, with that threshold: 3 in 48 h, at least 6.2 h with 95 %
MEASURED = (
    (6.5, 1.6),
    (7.5, 3.7),
    (8.5, 12.0),
    (9.5, 16.0),
)  # threshold, h between alarms
RISE_MORE = 4.0  # a fall is a danger, a rise is not


def threshold_for(hours: float) -> float:
    """Threshold of a fall with so long between two false alarms; that of a rise is `RISE_MORE` higher.

    Parameters
    ----------
    hours : float    mean time between false alarms on simulated roads with speed changes, kerbs and gusts.

    Raises
    ------
    UsageError       the hours are outside what was measured.
    """
    thresholds, between = zip(*MEASURED, strict=True)
    if not between[0] <= hours <= between[-1]:
        raise UsageError(
            f"{hours:g} h between false alarms were not measured; {between[0]:g} to {between[-1]:g} h were",
            usually="longer times take more simulated hours than `make alarms` drives.",
            paste=f"threshold_for({BETWEEN_FALSE_ALARMS:g})   # the default; make alarms measures others",
            read='docs/monitor.md, "False alarms"',
        )
    return float(np.interp(np.log(hours), np.log(between), thresholds))


def monitor_config(library: Library, *, L: float, **changes: float) -> NDArray[np.float64]:
    """The flat configuration of the bicycle's monitor.

    Parameters
    ----------
    library : the compiled monitor.
    L : wheelbase [m].
    changes : constants to replace, by name.
    """
    thresholds = {"threshold_fall": THRESHOLD, "threshold_rise": THRESHOLD + RISE_MORE}
    return library.config({**DESIGN, **thresholds, "L": L, **changes})
