"""Many scores of one estimator as one row: medians, shares, rates with bounds.

Detection at a fixed false-alarm rate: every estimator is given the same test, the fall of its ln K against
10 s earlier, with the threshold at which it would have rung falsely so many times an hour in this run's own
sound driving; then the delay at that threshold is read.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from similitude.benchmark.scoring import THRESHOLDS, Score

FALSE_PER_HOUR = 1.0
UNSURE = 0.95  # of the upper bound of a rate


def tally(scores: Sequence[Score], threshold: float) -> dict[str, Any]:
    """Return one row of numbers; None where there is nothing to say.

    Parameters
    ----------
    scores : of one estimator, some cells
    threshold : float   of the test of steps, from `threshold_of` [-]
    """
    fine = [s for s in scores if not s.fault]
    hours, false = sum(s.hours for s in fine), sum(s.false for s in fine)
    changed = [s for s in fine if not math.isnan(s.half_way)]
    return {
        "drives": len(scores),
        "diverged": len(scores) - len(fine),
        "rms": _mean([s.rms**2 for s in fine], root=True),
        "rms_median": _median([s.rms for s in fine]),
        "rms_p90": _quantile([s.rms for s in fine], 0.9),
        "bias": _mean([s.bias for s in fine]),
        "coverage": _mean([s.coverage for s in fine]),
        "half_way_s": _median([s.half_way for s in changed]),
        "step_delay_s": _median([delay_at(s, threshold) for s in changed]),
        "alarm_s": _median([s.found for s in changed]),
        "alarm_p90_s": _quantile([s.found for s in changed], 0.9),
        "missed": float(np.mean([math.isinf(s.found) for s in changed])) if changed else None,
        "false_alarms": false,
        "hours": hours,
        "false_per_hour": false / hours if hours else None,
        "false_per_hour_95": upper_bound(false) / hours if hours else None,
        "identified": float(np.mean([s.identified for s in fine])) if fine else None,
        "wrong": sum(s.wrong for s in fine),
        "call_ns": _least([1e9 * s.seconds / s.rows for s in scores if s.rows]),
        "step_ns": _least([1e9 * s.step_seconds / s.rows for s in fine if s.step_seconds]),
        "operations": next((s.operations for s in fine if s.operations), None),
    }


def threshold_of(scores: Sequence[Score]) -> tuple[float, float]:
    """Return the threshold of the test of steps at `FALSE_PER_HOUR`, and the sound hours it rests on.

    At most one false alarm is counted a drive.
    """
    largest = sorted((s.largest for s in scores if not math.isnan(s.largest)), reverse=True)
    hours = sum(max(s.hours - 20.0 / 3600, 0.0) for s in scores if not math.isnan(s.largest))
    if not largest:
        return math.inf, 0.0
    return largest[min(int(hours * FALSE_PER_HOUR + 1e-6), len(largest) - 1)], hours


def delay_at(score: Score, threshold: float) -> float:
    """Return the delay at the next of `THRESHOLDS` that is not lower [s]."""
    at = int(np.searchsorted(THRESHOLDS, threshold))
    return math.inf if score.late is None or at >= THRESHOLDS.size else float(score.late[at])


def upper_bound(count: int) -> float:
    """Return the 95 % upper bound of a Poisson mean of which ``count`` were seen."""
    from scipy.stats import chi2

    return float(chi2.ppf(UNSURE, 2 * (count + 1)) / 2)


def _mean(values: Sequence[float], *, root: bool = False) -> float | None:
    known = [v for v in values if not math.isnan(v)]
    if not known:
        return None
    return float(np.sqrt(np.mean(known))) if root else float(np.mean(known))


def _median(values: Sequence[float]) -> float | None:
    return _quantile(values, 0.5)


def _quantile(values: Sequence[float], q: float) -> float | None:
    """The order statistic at a share q, so that never (inf) stays never; None for nothing."""
    known = sorted(v for v in values if not math.isnan(v))
    return known[min(int(q * len(known)), len(known) - 1)] if known else None


def _least(values: Sequence[float]) -> float | None:
    return min(values, default=None)
