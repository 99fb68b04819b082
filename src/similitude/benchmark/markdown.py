"""The result as tables in Markdown, as docs/benchmark.md holds them; a test compares."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from similitude.benchmark.page import bound_of, cell_name
from similitude.benchmark.running import BOUND, Result
from similitude.benchmark.wording import ALARM, COLUMNS, COST, Column, summary_line

CELL = ("rms ln K", "bias", "covered", "identified", "wrong", "half-way")


def markdown(result: Result) -> str:
    """Return how much was driven, the totals, alarms, cost, and the population filter cell by cell."""
    record = result.record
    totals = record["totals"]
    ours = [{**r, "cell": cell_name(r)} for r in result.rows(estimator="population")]
    columns: dict[str, Column] = {
        **{name: COLUMNS[name] for name in CELL},
        "over bound": lambda row: bound_of(result, row),
        "alarm": ALARM["alarm"],
        "missed": ALARM["missed"],
        "false": lambda row: str(row["false_alarms"]),
    }
    parts = [summary_line(record) + "."]
    parts.append(table(totals, "estimator", COLUMNS))
    parts.append(table([r for r in totals if r["estimator"] == "population"], "estimator", ALARM))
    parts.append(table([r for r in totals if r["estimator"] != BOUND], "estimator", COST))
    parts.append(table(ours, "cell", columns))
    return "\n\n".join(parts) + "\n"


def table(rows: Sequence[Mapping[str, Any]], first: str, columns: Mapping[str, Column]) -> str:
    """Return one table; the first column names the row."""
    lines = [[first, *columns], ["---"] * (len(columns) + 1)]
    lines += [[row[first], *(make(row) for make in columns.values())] for row in rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)
