"""A Run as one JSON object, the contract other programs rely on.

Invariant: strict JSON. A number that is not finite becomes null; the tokens NaN and Infinity never
appear. Keys are added over time, never renamed or removed while `SCHEMA` stays.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from similitude.run import Run

SCHEMA = 1


def summary(run: Run, files: Mapping[str, str] | None = None) -> dict[str, Any]:
    """Gather what a run found, in plain Python values.

    Parameters
    ----------
    run : Run
        A finished identification; SI units throughout.
    files : mapping of str to str, optional
        Kind of file ("estimate", "summary", "plot") to the path it was written to.

    Returns
    -------
    dict
        Only dict, list, str, int, float and None. `K` [m^2/s^2] is at the end of the log and
        `lo`, `hi` bound 95 %; the standard deviations of groups are in the group's own unit [-].
    """
    return plain_values(
        {
            "schema": SCHEMA,
            "log": run.log.path if run.log.path is not None else run.log.name,
            "samples": run.log.samples,
            "duration_s": run.log.duration,
            "estimator": run.estimator,
            "vehicle": run.vehicle.name,
            "verdict": run.verdict,
            "reason": run.reason,
            "K": _estimate(run.K),
            "pi3": run.pi3,
            "Caf": None if run.Caf is None else _estimate(run.Caf),
            "batch": None if run.batch is None else _batch(run.batch),
            "cross_check": None if run.cross_check is None else _cross_check(run.cross_check),
            "groups": {name: _group(group) for name, group in run.groups.items()},
            "nuisance": {
                name: {"value": found.value, "std": found.std, "unit": found.unit}
                for name, found in run.nuisance.items()
            },
            "lag": {
                "value": run.lag.chosen,
                "servo": run.lag.servo.constant,
                "servo_slew": run.lag.servo.slew,
                "unit": "s",
                "from": run.lag.origin,
                "scanned_s": run.lag.lags,
                "cost": run.lag.cost,
            },
            "alarms": run.alarms,
            "monitor": run.monitor,
            "information": run.information,
            "time_scales": run.time_scales,
            "prediction": run.prediction,
            "handling": run.handling,
            "fixes": run.log.fixes,
            "warnings": run.warnings,
            "assumed": {
                name: {"value": given.value, "unit": given.unit, "from": given.origin}
                for name, given in run.assumed.items()
            },
            "files": dict(files or {}),
        }
    )


def json_line(record: Mapping[str, Any]) -> str:
    """Write a record on one line of ASCII, as `--json` prints it.

    Parameters
    ----------
    record : mapping
        What `summary` returned.

    Returns
    -------
    str
        Strict JSON without a line break.

    Raises
    ------
    ValueError
        A value is not finite; `summary` never leaves one.
    """
    return json.dumps(record, allow_nan=False)


def json_page(record: Mapping[str, Any]) -> str:
    """Write the same record over several lines, as `summary.json` holds it.

    Parameters
    ----------
    record : mapping
        What `summary` returned.

    Returns
    -------
    str
        Strict JSON, indented, ending with a line break; to be encoded as UTF-8.

    Raises
    ------
    ValueError
        A value is not finite; `summary` never leaves one.
    """
    return json.dumps(record, allow_nan=False, ensure_ascii=False, indent=2) + "\n"


def _estimate(found) -> dict[str, Any]:
    return {
        "value": found.value,
        "std": found.std,
        "lo": found.lo,
        "hi": found.hi,
        "unit": found.unit,
    }


def _batch(found) -> dict[str, Any]:
    return {
        **_estimate(found.K),
        "correlation": found.correlation,
        "widened": found.widened,
        "halves": {**found.halves, "unit": found.K.unit},
    }


def _cross_check(found) -> dict[str, Any]:
    return {
        "estimator": "robust",
        **_estimate(found.K),
        "population": _estimate(found.population),
        "apart": found.apart,
        "apart_std": found.std,
        "average_apart": found.average_apart,
        "average_apart_std": found.average_std,
        "unknowns": found.unknowns,
        "structure_error": found.structure_error,
    }


def _group(group) -> dict[str, Any]:
    return {
        "value": group.value,
        "std": group.std,
        "prior": group.prior_value,
        "prior_std": group.prior_std,
        "meaning": group.meaning,
    }


def plain_values(value: Any) -> Any:
    """Reduce paths, tuples, NumPy scalars and arrays to what JSON knows; not finite to None."""
    if value is None or isinstance(value, str | bool | int):
        return value
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return {str(key): plain_values(part) for key, part in value.items()}
    if hasattr(value, "tolist"):  # a NumPy scalar or array
        return plain_values(value.tolist())
    return [plain_values(part) for part in value]
