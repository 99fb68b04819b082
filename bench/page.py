"""The measurements as a page for the terminal and as a record for JSON."""

from __future__ import annotations

import platform
from dataclasses import asdict

from rich.console import Console, Group
from rich.table import Table

from bench.measurements import Bound, Row
from similitude.program.compile import FLAGS, cache_directories
from similitude.program.compiler import find_compiler

UNIT = {"process": (1e-6, "s"), "sample": (1.0, "µs"), "list": (1e-3, "ms"), "system": (1e-6, "s")}


def record(rows: list[Row], bounds: list[Bound]) -> dict:
    """Everything that was measured, and on what, ready for `json.dumps`; times in microseconds."""
    compiler = find_compiler(cache_directories())
    return {
        "machine": {
            "processor": _processor(),
            "system": f"{platform.system()} {platform.machine()}",
            "python": platform.python_version(),
            "compiler": compiler.version.splitlines()[0],
            "flags": list(FLAGS),
        },
        "times": [asdict(row) for row in rows],
        "bounds": [asdict(bound) | {"holds": bound.holds} for bound in bounds],
    }


def show(rows: list[Row], bounds: list[Bound], console: Console) -> None:
    """Print both tables."""
    console.print(Group(_times(rows), _bounds(bounds)))


def _times(rows: list[Row]) -> Table:
    table = Table(title="Time taken", title_justify="left", box=None, pad_edge=False)
    table.add_column("")
    for column in ("median", "least", ""):
        table.add_column(column, justify="right" if column else "left")
    for row in rows:
        factor, unit = UNIT[row.per]
        cells = [f"{factor * value:.3g}" for value in (row.median_us, row.least_us)]
        table.add_row(row.name, *cells, f"{unit} a {row.per}")
    return table


def _bounds(bounds: list[Bound]) -> Table:
    table = Table(title="\nRatios inside this run", title_justify="left", box=None, pad_edge=False)
    table.add_column("")
    for column in ("medians", "least", "bound", ""):
        table.add_column(column, justify="right" if column else "left")
    for b in bounds:
        verdict = "[green]pass[/]" if b.holds else "[bold red]missed[/]"
        table.add_row(b.name, f"{b.ratio:.2f}", f"{b.ratio_of_least:.2f}", f"{b.bound:g}", verdict)
    return table


def _processor() -> str:
    """The processor's own name where the system tells it."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            named = [line for line in file if line.startswith("model name")]
    except OSError:
        named = []
    return named[0].partition(":")[2].strip() if named else platform.processor()
