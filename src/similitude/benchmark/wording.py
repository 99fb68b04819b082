"""Numbers of the benchmark as people read them, and the columns of its tables."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

Column = Callable[[Mapping[str, Any]], str]
COLUMNS: dict[str, Column] = {
    "rms ln K": lambda row: percent(row["rms"]),
    "median": lambda row: percent(row["rms_median"]),
    "bias": lambda row: percent(row["bias"], sign=True),
    "covered": lambda row: percent(row["coverage"]),
    "identified": lambda row: "" if row["coverage"] is None else percent(row["identified"]),
    "wrong": lambda row: "" if row["coverage"] is None else str(row["wrong"]),
    "half-way": lambda row: seconds(row["half_way_s"]),
    "detected": lambda row: seconds(row["step_delay_s"]),
    "diverged": lambda row: str(row["diverged"]),
}
ALARM: dict[str, Column] = {
    "alarm": lambda row: seconds(row["alarm_s"]),
    "p90": lambda row: seconds(row["alarm_p90_s"]),
    "missed": lambda row: percent(row["missed"]),
    "false": lambda row: f"{row['false_alarms']} in {row['hours']:.1f} h",
    "an hour, at most (95 %)": lambda row: (
        "" if row["false_per_hour_95"] is None else f"{row['false_per_hour_95']:.2g}"
    ),
}
COST: dict[str, Column] = {
    "ns a sample": lambda row: "" if row["step_ns"] is None else f"{row['step_ns']:.0f}",
    "ns, whole call": lambda row: "" if row["call_ns"] is None else f"{row['call_ns']:.0f}",
    "operations": lambda row: str(row["operations"] or ""),
}
# Short enough for eighty characters: units in the heading.
TERMINAL: dict[str, Column] = {
    "rms %": lambda row: bare(row["rms"]),
    "med. %": lambda row: bare(row["rms_median"]),
    "bias %": lambda row: bare(row["bias"]),
    "cover %": lambda row: bare(row["coverage"]),
    "wrong": COLUMNS["wrong"],
    "half s": lambda row: seconds(row["half_way_s"]).removesuffix(" s"),
    "ns": lambda row: "" if row["step_ns"] is None else f"{row['step_ns']:.0f}",
}
TERMINAL_CELL: dict[str, Column] = {
    "rms %": TERMINAL["rms %"],
    "cover %": TERMINAL["cover %"],
    "wrong": TERMINAL["wrong"],
    "alarm s": lambda row: seconds(row["alarm_s"]).removesuffix(" s"),
    "false": lambda row: str(row["false_alarms"]),
}
MEANING = {
    "rms ln K": "of all drives together, over the last 20 s before the change and the last 20 s",
    "median": "of the rms of one drive, over the drives",
    "bias": "mean error of ln K in the same seconds",
    "covered": "rows after 10 s whose 95 % interval holds the truth, those just after the change too",
    "identified": "drives that end with K said to be known (±15 %)",
    "wrong": "of those, drives that are off by more than 30 %",
    "half-way": "median time after the change until the estimate is half-way in ln K",
    "detected": "median delay of one and the same test on every estimator's ln K (its fall against 10 s "
    "earlier), the threshold such that it rings falsely once an hour in cells without a fault",
    "diverged": "drives with an error, no number or a K that is not positive",
    "alarm": "median delay of the estimator's own alarm",
}


def percent(value: float | None, *, sign: bool = False) -> str:
    """Return a share as per cent, nothing for None."""
    if value is None:
        return ""
    digits = 0 if abs(value) >= 0.9995 or value == 0 else 1
    return f"{100 * value:{'+' if sign else ''}.{digits}f} %"


def bare(value: float | None) -> str:
    """Return a share in per cent without the sign for it."""
    return percent(value).removesuffix(" %")


def seconds(value: float | None) -> str:
    """Return a delay; what never came is "never", and what was not asked for nothing."""
    if value is None:
        return ""
    return "never" if math.isinf(value) else f"{value:.2f} s"


def summary_line(record: dict[str, Any]) -> str:
    """Return how much was driven: cells, drives, seeds, seed and time."""
    seeds = " or ".join(str(n) for n in record["seeds"])
    return (
        f"{record['cells']} cells, {record['drives']} drives of 80 s ({seeds} seeds a cell, the first "
        f"{record['seed']}), {record['seconds']:.0f} s with {record['processes']} processes"
    )


def over_bound(row: dict[str, Any], bound: dict[str, Any] | None) -> str:
    """Return rms over the bound's, for a cell that has one."""
    return "" if not bound or row["rms"] is None else f"{row['rms'] / bound['rms']:.2f}"
