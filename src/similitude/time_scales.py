"""Two time scales of K: the tyre's, slow and remembered over drives, and the road's, fast and forgotten.

The tyre's value is the mean of ln K over a drive, weighed with what was learnt when, and filtered over
drives with a drift of its own; the road is what K is now, relative to it.

Invariant: drives share what every drive gets wrong (steer scale, geometry), so many drives are never
surer than the surest of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from similitude.run import Trace

DRIFT = 0.05**2 / 86400.0  # 1/s of ln K: 5 % in a day of load, pressure and wear, 13 % in a week
ROAD_STD = 0.10  # of the mean over one drive: wet stretches, other surfaces
DAY = 86400.0  # s


@dataclass(frozen=True)
class TimeScales:
    """``K`` the tyre's [m^2/s^2] over ``drives``, ``road`` = K now over that; sds are of logarithms."""

    K: float
    ln_K_std: float
    drives: int
    least_std: float  # of ln K of the surest drive
    road: float
    road_std: float

    @property
    def record(self) -> dict[str, dict[str, float]]:
        """As JSON has it."""
        return {
            "tyre": {"K": self.K, "std": self.K * self.ln_K_std, "drives": self.drives},
            "road": {"factor": self.road, "std": self.road * self.road_std},
        }

    @property
    def kept(self) -> dict[str, float]:
        """What a state file keeps."""
        return {
            "ln_K": float(np.log(self.K)),
            "std": float(self.ln_K_std),
            "drives": float(self.drives),
            "least_std": float(self.least_std),
        }


def time_scales(trace: Trace, kept: Mapping[str, float] | None = None, elapsed: float = 0.0) -> TimeScales:
    """Fold a drive into the tyre's value.

    Parameters
    ----------
    trace : Trace     of the drive.
    kept : mapping    the tyre's value after earlier drives, or None.
    elapsed : float   since the last of them [s].
    """
    ln_K, last_std = np.log(trace.K), float(trace.ln_K_std[-1])
    weight = np.clip(np.diff(trace.information, prepend=trace.information[0]), 0.0, None)
    mean = float(np.average(ln_K, weights=weight)) if weight.sum() > 0 else float(ln_K[-1])
    own = float(np.hypot(last_std, ROAD_STD))
    drives, least, value, std = 1, last_std, mean, own
    if kept:
        before = kept["std"] ** 2 + DRIFT * max(elapsed, 0.0)
        gain = before / (before + own**2)
        value = kept["ln_K"] + gain * (mean - kept["ln_K"])
        least = min(last_std, kept["least_std"])
        std = max(float(np.sqrt(before * (1 - gain))), least)
        drives = int(kept["drives"]) + 1
    return TimeScales(
        K=float(np.exp(value)),
        ln_K_std=std,
        drives=drives,
        least_std=least,
        road=float(np.exp(ln_K[-1] - value)),
        road_std=float(np.hypot(last_std, std)),
    )
