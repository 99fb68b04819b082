"""Prints how the population filter and its alarm do on the multi-body plant (`make multi-body`).

Three cars that nobody here wrote, ordinary sensors: a loss of half the stiffness in slalom and sweep, a loss
of peak friction alone, and an hour in which nothing happens. Twenty minutes; drives are kept in the cache.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from rich.console import Console
from rich.table import Table

from similitude.benchmark.cells import CHANGED, Cell
from similitude.benchmark.drives import foreign_drive
from similitude.benchmark.kept_drives import foreign_version
from similitude.benchmark.ladder_entrants import ladder
from similitude.benchmark.scoring import Score, score
from similitude.simulation.foreign import VEHICLES
from similitude.simulation.scenario import read_scenario

SEED = 90_000
CHANGES = {  # name -> manoeuvres, seeds of each, length [s], what the road does
    "half the stiffness": (("slalom", "sweep"), 6, 80, [CHANGED]),
    "peak alone": (("slalom", "highway"), 6, 80, [{"begin": CHANGED["begin"], "friction": 0.5}]),
    "nothing": (("slalom", "sweep", "highway", "turns"), 3, 300, []),
}
ESTIMATORS = ("population", "with_ay")


def main() -> None:
    """Drive everything and print a table."""
    if foreign_version() is None:
        sys.exit("commonroad-vehicle-models is missing: pip install 'similitude[plants]'")
    jobs = [
        (what, manoeuvre, SEED + i)
        for what, (manoeuvres, seeds, *_) in CHANGES.items()
        for manoeuvre in manoeuvres
        for i in range(seeds)
    ]
    with ProcessPoolExecutor(2) as pool:
        found = list(pool.map(scores, jobs))
    table = Table(title=f"Multi-body plant, {len(jobs)} drives of {len(VEHICLES)} cars")
    for name in (
        "change",
        "manoeuvre",
        "estimator",
        "rms ln K",
        "covered",
        "median",
        "p90",
        "missed",
        "alarms",
    ):
        table.add_column(name, justify="left" if name in ("change", "manoeuvre", "estimator") else "right")
    for what, (manoeuvres, _, length, _) in CHANGES.items():
        for manoeuvre in manoeuvres:
            for name in ESTIMATORS:
                mine = [
                    f[name] for (w, m, _), f in zip(jobs, found, strict=True) if (w, m) == (what, manoeuvre)
                ]
                table.add_row(what, manoeuvre, name, *cells(mine, length))
    Console(width=120).print(table)


def cells(mine: list[Score], length: float) -> list[str]:
    """A row of the table: accuracy, delay, false alarms in the time driven."""
    rms = np.sqrt(np.mean([s.rms**2 for s in mine]))
    late = np.array([s.found for s in mine])
    hours = sum(s.hours if np.isfinite(s.found) else length / 3600 for s in mine)
    delay = ["", "", ""]
    if not np.isnan(late).all():
        p50, p90 = (np.quantile(late, q, method="higher") for q in (0.5, 0.9))
        delay = [f"{p50:.2f} s", f"{p90:.2f} s", f"{np.isinf(late).sum()} of {late.size}"]
    covered = np.mean([s.coverage for s in mine])
    return [
        f"{100 * rms:.1f} %",
        f"{100 * covered:.0f} %",
        *delay,
        f"{sum(s.false for s in mine)} in {hours:.2f} h",
    ]


def scores(job: tuple[str, str, int]) -> dict[str, Score]:
    """Score the estimators on one drive."""
    what, manoeuvre, seed = job
    vehicle = list(VEHICLES)[seed % len(VEHICLES)]
    changes = scenario(what, manoeuvre, vehicle)
    drive, truth = foreign_drive(read_scenario("slalom", changes=changes), seed, {"scenario": changes})
    by_name = {one.name: one for one in ladder()}
    return {name: score(drive, truth, by_name[name].estimate(drive), seconds=0.0) for name in ESTIMATORS}


def scenario(what: str, manoeuvre: str, vehicle: str) -> Mapping[str, Any]:
    """The benchmark's cell with another road and another length."""
    _, _, length, surface = CHANGES[what]
    said = Cell(manoeuvre, "multi_body", "none", 1).changes
    said["run"]["duration"] = f"{length} s"
    said["road"] = {"friction": 1.0, "surface": [dict(one) for one in surface]}
    said["plant"]["vehicle"] = vehicle
    said["vehicle"] = {"name": vehicle, "population": "passenger_cars", "known": ["L"]}
    return said


if __name__ == "__main__":
    main()
