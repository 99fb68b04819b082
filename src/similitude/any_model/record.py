"""An estimate as one JSON object: the same keys whatever the model.

Invariant: every number is finite or null, and each unknown has value, interval, sd and prior.
"""

from __future__ import annotations

import math
from typing import Any

SCHEMA = 1


def estimate_record(estimator: Any, found: Any, log: str) -> dict[str, Any]:
    """The object that `similitude estimate --json` prints.

    Parameters
    ----------
    estimator : Estimator.    found : Estimate.    log : its name.
    """
    return {
        "schema": SCHEMA,
        "log": log,
        "samples": len(found.t),
        "duration_s": _number(found.t[-1] - found.t[0]) if len(found.t) else 0.0,
        "model": estimator.model.name,
        "estimator": estimator.choice.kind,
        "why": estimator.choice.reason,
        "verdict": found.verdict,
        "reason": found.reason,
        "identified": found.name,
        "unknowns": {n: _value(v) for n, v in found.unknowns.items()},
        "parameters": {n: _value(v) for n, v in found.parameters.items()},
        "consistency": _number(found.consistency),
        "excess": _number(found.excess),
        "assumed": {
            n: {"value": _number(v), "unit": unit, "from": origin}
            for n, (v, unit, origin) in estimator.assumed.items()
        },
    }


def _value(one: Any) -> dict[str, Any]:
    numbers = {
        "value": one.value,
        "lo": one.low,
        "hi": one.high,
        "sd_log": one.sd,
        "prior_sd_log": one.prior_sd,
    }
    return {**{name: _number(v) for name, v in numbers.items()}, "unit": one.unit}


def _number(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
