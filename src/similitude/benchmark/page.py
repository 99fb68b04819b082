"""The benchmark as one HTML page and as text for a terminal: the totals first, then every cell.

Invariant: both are made from the record alone, so a file of long ago gives its page again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from similitude.benchmark.running import BOUND, Result
from similitude.benchmark.wording import (
    ALARM,
    COLUMNS,
    COST,
    MEANING,
    TERMINAL,
    TERMINAL_CELL,
    over_bound,
    summary_line,
)
from similitude.report.html_page import Html, bullets, details, page, paragraph, section, table


def page_of(result: Result) -> str:
    """Return the page as HTML."""
    record = result.record
    parts: list[Html] = [
        paragraph(summary_line(record)),
        *(paragraph(note) for note in record["notes"]),
        section("Estimators", _html(record["totals"], "estimator", COLUMNS), _about(record)),
        section("Alarms and cost", _html(_of_alarms(record), "estimator", ALARM),
                _html([r for r in record["totals"] if r["estimator"] != BOUND], "estimator", COST)),
        section("Manoeuvre and plant", *_cells(result, fault=False)),
        section("One fault at a time", *_cells(result, fault=True)),
        section("What the columns say", bullets(f"{name}: {words}" for name, words in MEANING.items())),
    ]  # fmt: skip
    return page("Benchmark", parts, {})


def print_result(result: Result, console: Any) -> None:
    """Print totals, the default's cells and how much was driven."""
    record = result.record
    console.print(_rich("Estimators, over every cell", record["totals"], "estimator", TERMINAL))
    for alarms in _of_alarms(record):
        told = ", ".join(f"{name} {make(alarms)}" for name, make in ALARM.items())
        console.print(f"alarms of {alarms['estimator']}: {told}", soft_wrap=True)
    own = [{**r, "cell": cell_name(r)} for r in result.rows(estimator="population")]
    console.print(_rich("The population filter, cell by cell", own, "cell", TERMINAL_CELL))
    console.print(summary_line(record), soft_wrap=True)
    for note in record["notes"]:
        console.print(note, soft_wrap=True)


def cell_name(row: dict[str, Any]) -> str:
    """Return the cell of a row in words."""
    fault = "" if row["fault"] == "none" else f", {row['fault']}"
    return f"{row['manoeuvre']}, {row['plant']}{fault}".replace("_", " ")


def _of_alarms(record: dict[str, Any]) -> list[dict[str, Any]]:
    """Estimators that rang at least once."""
    return [r for r in record["totals"] if r["missed"] is not None and (r["missed"] < 1 or r["false_alarms"])]


def bound_of(result: Result, row: dict[str, Any]) -> str:
    """Return a row's rms over the bound of its cell, nothing where there is none."""
    where = {key: row[key] for key in ("manoeuvre", "plant", "fault")}
    return over_bound(row, next(iter(result.rows(estimator=BOUND, **where)), None))


def _cells(result: Result, *, fault: bool) -> list[Html]:
    names = [one["estimator"] for one in result.record["totals"]]
    found = []
    for name in names:
        rows = [r for r in result.rows(estimator=name) if (r["fault"] != "none") == fault]
        if not rows:
            continue
        columns = {**COLUMNS, "over bound": lambda row: bound_of(result, row)}
        if any(r["missed"] is not None and r["missed"] < 1 for r in rows):
            columns |= ALARM
        shown = _html([{**r, "cell": cell_name(r)} for r in rows], "cell", columns)
        found.append(details(name, shown))
    return found


def _about(record: dict[str, Any]) -> Html:
    lines = [f"{name}: {words}" for name, words in record["about"].items()]
    lines.append(f"{BOUND}: posterior Cramér-Rao bound on the linear plant; it knows when the change comes")
    lines += [
        f"{one['estimator']} failed with: {fault}" for one in record["totals"] for fault in one["faults"]
    ]
    return bullets(lines)


def _html(rows: Sequence[dict[str, Any]], first: str, columns: dict[str, Any]) -> Html:
    lines = [[row[first], *(make(row) for make in columns.values())] for row in rows]
    return table([first, *columns], lines, numeric=range(1, len(columns) + 1))


def _rich(title: str, rows: Sequence[dict[str, Any]], first: str, columns: dict[str, Any]) -> Any:
    from rich import box
    from rich.table import Table

    made = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD)
    made.add_column(first, no_wrap=True)
    for name in columns:
        made.add_column(name, justify="right")
    for row in rows:
        made.add_row(row[first], *(make(row) for make in columns.values()))
    return made
