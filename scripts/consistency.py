"""Prints how far the population filter's unknowns are off, over their own standard deviations.

Forty cars a cell of the benchmark: at 15 s, before the change at 50 s and after it. 1 is what a filter
reaches that knows what it does not know. `docs/filter.md`, "The interval".
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from rich.console import Console
from rich.table import Table

from similitude.benchmark.cells import cells
from similitude.benchmark.drives import Drive, Truth, drives
from similitude.benchmark.ladder_entrants import prepared

CELLS = (
    "slalom, linear",
    "sweep, linear",
    "double_lane_change, linear",
    "turns, linear",
    "highway, linear",
    "slalom, linear, bias",
    "highway, linear, kerbs",
)
CARS, SEED = 40, 61_000
TIMES = (15.0, 49.0, 79.0)  # s
NAMES = ("K", "pi1", "eta", "rho", "input_scale")


def off(drive: Drive, truth: Truth) -> np.ndarray:
    """Error over standard deviation of every unknown at every time, (times, unknowns)."""
    setup, rows = prepared(drive).setup, []
    for until in TIMES:
        kept = setup.log.t <= until
        columns = {name: getattr(setup.log, name)[kept] for name in ("t", "delta", "r", "U")}
        done = replace(setup, log=replace(setup.log, ay=None, **columns)).run()
        true = {**truth.groups, "K": truth.K[: kept.size][kept][-1], "input_scale": 1.0}
        error = [
            done.value(n) - true[n] if n == "pi1" else float(np.log(done.value(n) / true[n])) for n in NAMES
        ]
        rows.append(error / np.sqrt(np.diag(done.covariance(list(NAMES)))))
    return np.array(rows)


def main() -> None:
    """Drive every cell and print the table."""
    table = Table(title=f"rms of error over standard deviation, {CARS} cars a cell")
    for name in ("cell", "after", "K", "π1", "η", "ρ", "steer scale"):
        table.add_column(name, justify="left" if name == "cell" else "right")
    every = []
    for cell in cells(quick=False, foreign=False):
        if cell.name not in CELLS:
            continue
        found = np.array([off(*one) for one in drives(replace(cell, seeds=CARS), SEED)])
        rms = np.sqrt(np.mean(found**2, axis=0))
        every.append(rms)
        for at, row in zip(TIMES, rms, strict=True):
            table.add_row(cell.name, f"{at:g} s", *(f"{x:.1f}" for x in row))
    for k, at in enumerate(TIMES):
        table.add_row(
            "median", f"{at:g} s", *(f"{x:.1f}" for x in np.median([rms[k] for rms in every], axis=0))
        )
    Console(width=110).print(table)


if __name__ == "__main__":
    main()
