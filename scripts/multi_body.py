"""Prints how the population filter and its alarm do on the multi-body plant (`make multi-body`).

Three cars that nobody here wrote, each at 50, 80 and 120 km/h, ordinary sensors: a loss of half the stiffness
in slalom and sweep, a loss of peak friction alone, and an hour in which nothing happens. Beside each drive
stands the same car driven alike on the linear plant: what is the car's, and what the plant's. Ten minutes of
two cores; drives are kept in the cache.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
from rich.console import Console
from rich.table import Table

from similitude.benchmark.cells import CHANGED, Cell
from similitude.benchmark.drives import Drive, Truth, columns, foreign_drive, told
from similitude.benchmark.kept_drives import foreign_version
from similitude.benchmark.ladder_entrants import ladder
from similitude.benchmark.scoring import Score, score
from similitude.simulation.foreign import VEHICLES, foreign_car
from similitude.simulation.recording import run_scenario
from similitude.simulation.scenario import read_scenario

SEED = 90_000
SPEEDS = (50, 80, 120)  # km/h
GENTLER = 1.25  # steer goes with this power of the slowness: peaks of 1.4 to 3.3 m/s^2 before the change
CHANGES = {  # name -> manoeuvres, seeds of each, length [s], what the road does
    "half the stiffness": (("slalom", "sweep"), 9, 80, [CHANGED]),
    "peak alone": (("slalom", "highway"), 3, 80, [{"begin": CHANGED["begin"], "friction": 0.5}]),
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
        "linear: rms",
        "covered",
    ):
        table.add_column(name, justify="left" if name in ("change", "manoeuvre", "estimator") else "right")
    for what, (manoeuvres, _, length, _) in CHANGES.items():
        for manoeuvre in manoeuvres:
            for name in ESTIMATORS:
                here = [
                    f[name] for (w, m, _), f in zip(jobs, found, strict=True) if (w, m) == (what, manoeuvre)
                ]
                mine, twins = ([pair[i] for pair in here] for i in (0, 1))
                table.add_row(what, manoeuvre, name, *cells(mine, length), *accuracy(twins))
    Console(width=140).print(table)


def cells(mine: list[Score], length: float) -> list[str]:
    """A row of the table: accuracy, delay, false alarms in the time driven."""
    late = np.array([s.found for s in mine])
    hours = sum(s.hours if np.isfinite(s.found) else length / 3600 for s in mine)
    delay = ["", "", ""]
    if not np.isnan(late).all():
        p50, p90 = (np.quantile(late, q, method="higher") for q in (0.5, 0.9))
        delay = [f"{p50:.2f} s", f"{p90:.2f} s", f"{np.isinf(late).sum()} of {late.size}"]
    return [*accuracy(mine), *delay, f"{sum(s.false for s in mine)} in {hours:.2f} h"]


def accuracy(mine: list[Score]) -> list[str]:
    """Error of ln K and share of rows whose interval holds it."""
    rms = np.sqrt(np.mean([s.rms**2 for s in mine]))
    return [f"{100 * rms:.1f} %", f"{100 * np.mean([s.coverage for s in mine]):.0f} %"]


def scores(job: tuple[str, str, int]) -> dict[str, tuple[Score, Score]]:
    """Score the estimators on one drive and on its twin, which has no peak to lose."""
    what, manoeuvre, seed = job
    i = seed - SEED  # three seeds are each car and each speed once, nine are all pairs
    vehicle, speed = list(VEHICLES)[i % 3], SPEEDS[(i + i // 3) % 3]
    changes = scenario(what, manoeuvre, vehicle, speed)
    drive, truth = foreign_drive(read_scenario("slalom", changes=changes), seed, {"scenario": changes})
    by_name = {one.name: one for one in ladder()}
    both = [
        {name: score(*pair, by_name[name].estimate(pair[0]), seconds=0.0) for name in ESTIMATORS}
        for pair in ((drive, truth), twin(changes, vehicle, seed))
    ]
    return {name: (both[0][name], both[1][name]) for name in ESTIMATORS}


def twin(changes: Mapping[str, Any], vehicle: str, seed: int) -> tuple[Drive, Truth]:
    """The same drive on the linear plant, with the car that the plant is at small slip."""
    car = foreign_car("mb", vehicle)
    said = {**changes, "plant": {"kind": "linear"}, "run": {**changes["run"], "step": "10 ms"}}
    del said["vehicle"]
    (one,) = run_scenario(read_scenario("slalom", changes=said), [seed], car=car)
    return told(columns(one), car.L)


def scenario(what: str, manoeuvre: str, vehicle: str, speed: int) -> Mapping[str, Any]:
    """The benchmark's cell with another road, length and speed [km/h]."""
    _, _, length, surface = CHANGES[what]
    said = Cell(manoeuvre, "multi_body", "none", 1).changes
    said["run"]["duration"] = f"{length} s"
    said["road"] = {"friction": 1.0, "surface": [dict(one) for one in surface]}
    said["plant"]["vehicle"] = vehicle
    said["driver"], said["speed"] = at_speed(said["driver"], said["speed"], speed)
    said["vehicle"] = {"name": vehicle, "population": "passenger_cars", "known": ["L"]}
    return said


def at_speed(driver: Mapping[str, Any], usual: Mapping[str, Any], speed: int) -> tuple[dict[str, Any], ...]:
    """A driver who steers as much less as the car goes faster than usual, and the speed [km/h]."""
    (size,) = {"amplitude", "rms"} & driver.keys()
    steer, kmh = (float(text.split()[0]) for text in (driver[size], usual["value"]))
    less = (kmh / speed) ** GENTLER
    return {**driver, size: f"{steer * less:.2f} mrad"}, {**usual, "value": f"{speed} km/h"}


if __name__ == "__main__":
    main()
