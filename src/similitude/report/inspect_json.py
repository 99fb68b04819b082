"""An Inspection as one JSON object, for other programs.

Invariant: strict JSON, one line a log; what is not known is null. Angles are in rad, rates in
rad/s, columns in the unit of the file. Keys are added over time, never renamed while `SCHEMA` stays.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from similitude.inspection.advice import outlook
from similitude.inspection.excitation import seconds_by_kind
from similitude.report.summary import json_line, plain_values

if TYPE_CHECKING:
    from similitude.inspection.inspection import Inspection

SCHEMA = 1
MOST_PAUSES = 100  # of a kind; a torn clock has as many as rows


def inspect_record(look: Inspection) -> dict[str, Any]:
    """Gather what a look showed, in plain Python values.

    Parameters
    ----------
    look : Inspection    a log that was looked over

    Returns
    -------
    dict                 only dict, list, str, int, float, bool and None
    """
    return plain_values(
        {
            "schema": SCHEMA,
            "log": look.survey.path,
            "vehicle": look.vehicle.name if look.vehicle else None,
            "usable": not look.survey.certain,
            "columns": [asdict(one) for one in look.channels],
            "clock": _clock(look),
            "relations": _relations(look),
            "windows": [asdict(one) for one in look.windows],
            "seconds": seconds_by_kind(look.windows),
            "prospects": _prospects(look),
            "missing": look.missing,
            "findings": [_finding(one) for one in look.findings],
            "faults": dict(Counter(one.fault for one in look.findings)),
        }
    )


def inspect_line(look: Inspection) -> str:
    """The record on one line of ASCII."""
    return json_line(inspect_record(look))


def _clock(look: Inspection) -> dict[str, Any] | None:
    if look.clock is None:
        return None
    clock = asdict(look.clock)
    for kind in ("gaps", "jumps"):
        clock[f"{kind}_in_all"] = len(clock[kind])
        clock[kind] = clock[kind][:MOST_PAUSES]
    return {**clock, "rate": look.clock.rate, "rises": look.clock.is_usable}


def _relations(look: Inspection) -> dict[str, Any]:
    slow, ratio = look.slow, look.ratio
    at_wheel = look.signals is not None and look.signals.at_wheel
    found: dict[str, Any] = {
        "steer": "steering_wheel" if at_wheel else "delta",
        "yaw_behind_steer": None if look.behind_steer is None else asdict(look.behind_steer),
        "ay_behind_yaw": None if look.behind_yaw is None else asdict(look.behind_yaw),
        "steer_when_straight": None,
        "yaw_bias": None,
        "slow_length": None,
        "steering_ratio": None,
    }
    if slow is not None:
        found["steer_when_straight"] = None if slow.straight is None else asdict(slow.straight)
        found["yaw_bias"] = None if slow.bias is None else asdict(slow.bias)
        if slow.length is not None:
            std = abs(slow.length) * slow.length_std
            found["slow_length"] = {"value": slow.length, "std": std, "unit": "m"}
    if ratio is not None:
        found["steering_ratio"] = {"value": ratio[0], "std": ratio[1], "unit": "-"}
    return found


def _prospects(look: Inspection) -> dict[str, Any] | None:
    plan = look.prospects
    if plan is None:
        return None
    return {
        "verdict": plan.verdict,
        "unknowns": {name: {**asdict(one), "word": one.word} for name, one in plan.unknowns.items()},
        "half": {
            "ln_K_std": plan.goal,
            "steer_times": plan.steer_times,
            "long_times": plan.long_times,
        },
        "stays_linear": plan.is_linear,
        "ln_K_std_with_known_steer_scale": plan.known_scale,
        "too_slow": plan.too_slow,
        "steer_lag": {"value": plan.scan.total, "std": plan.scan.std, "unit": "s", "from": plan.scan.origin},
        "commanded": plan.commanded,
        "in_words": outlook(plan),
    }


def _finding(one) -> dict[str, Any]:
    return {
        "fault": one.fault,
        "refuses": one.certain,
        "what": one.what,
        "usually": one.usually,
        "paste": one.paste,
        "read": one.read,
        "column": one.column or None,
        "value": one.value,
        "rows": one.rows,
        "fix": one.fix,
    }
