"""Prints how accurate and how honest the population filter is, cell by cell (`make accuracy`).

The same experiment and cells as tests/montecarlo, as one table; a minute on two cores.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from rich.console import Console
from rich.table import Table
from tests.montecarlo.drift_bound import DRIFT, rms_and_bound
from tests.montecarlo.experiment import fleet, score
from tests.montecarlo.test_batch import NO_LAG, coverage, fits, nuisance_fleet
from tests.montecarlo.test_cells import DRIVES

from similitude.steer_lag import MEASURED_LAG


def main() -> None:
    """Score every cell and print the table."""
    table = Table(title="Population filter: 95 % interval of ln K, cell by cell")
    for name in ("cell", "steer", "rms ln K", "covered", "half-way", "within 15 %", "identified", "wrong"):
        table.add_column(name, justify="left" if name == "cell" else "right")
    for steer_rms in (3e-3, 10e-3):
        for name, (drawn, assumed) in DRIVES.items():
            row(table, name, steer_rms, score(fleet(2, steer_rms=steer_rms, **drawn), **assumed))
        hour = fleet(7, cars=40, duration=3600.0, step=1800.0, steer_rms=steer_rms)
        row(table, "one hour", steer_rms, score(hour, step=1800.0))
    straight = fleet(5, steer_rms=1e-4, duration=600.0, halve=False)
    for factor in (0.1, 1.0, 10.0):
        result = score(straight, noise_factor=factor)
        row(table, f"straight road, noise assumed x {factor:g}", 1e-4, result)
    console = Console(width=110)
    console.print(table)
    console.print(batch_table())
    console.print(bound_table())


def bound_table() -> Table:
    """The filter with a fixed drift of ln K against the bound for that drift."""
    table = Table(title=f"ln K taken to drift by {DRIFT:g} /s: rms against the Cramér-Rao bound, 40 cars")
    for name in ("steer", "rms", "bound", "ratio"):
        table.add_column(name, justify="right")
    for steer_rms in (3e-3, 10e-3):
        rms, bound = (
            float(np.sqrt(np.mean(x**2))) for x in rms_and_bound(fleet(2, cars=40, steer_rms=steer_rms))
        )
        table.add_row(
            f"{1000 * steer_rms:g} mrad", f"{100 * rms:.1f} %", f"{100 * bound:.1f} %", f"{rms / bound:.2f}"
        )
    return table


def batch_table() -> Table:
    """The batch fit without a change of stiffness, on the reference plant and on the nuisance plant."""
    table = Table(title="Batch fit: 95 % interval of ln K, 120 cars a cell")
    for name in ("cell", "steer", "median error of ln K", "covered"):
        table.add_column(name, justify="left" if name == "cell" else "right")
    for steer_rms in (3e-3, 10e-3):
        plain = fleet(31, cars=120, steer_rms=steer_rms, halve=False)
        dirty = nuisance_fleet(32, cars=120, steer_rms=steer_rms)
        for name, cars, lag in (
            ("reference, lag known", plain, NO_LAG),
            ("reference, lag not known", plain, MEASURED_LAG),
            ("scale, lag, offset, disturbance", dirty, MEASURED_LAG),
        ):
            covered, error = coverage([(cars, list(fits(cars, lag)))])
            table.add_row(
                name, f"{1000 * steer_rms:g} mrad", f"{100 * error:.1f} %", f"{100 * covered:.1f} %"
            )
    return table


def row(table: Table, name: str, steer_rms: float, result) -> None:
    """One cell of the table; delays only where the stiffness was halved."""
    halved = result.half_way > 0
    table.add_row(
        name,
        f"{1000 * steer_rms:g} mrad",
        f"{100 * result.rms:.1f} %",
        f"{100 * result.coverage:.1f} %",
        f"{result.half_way:.2f} s" if halved else "",
        f"{result.within_15:.2f} s" if halved else "",
        f"{100 * result.identified:.0f} %",
        str(result.wrong),
    )


if __name__ == "__main__":
    main()
