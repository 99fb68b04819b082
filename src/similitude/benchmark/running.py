"""A run of the benchmark: every cell simulated once, every entrant over each of its drives.

Invariant: a cell's drives depend on the cell and the seed alone, so the order of the work and the number of
processes change nothing but the times.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from similitude.benchmark.bound import bound_score
from similitude.benchmark.cells import CHANGE_AT, Cell, cells
from similitude.benchmark.drives import Drive, Truth, drives
from similitude.benchmark.entrant import Entrant, read_entrant
from similitude.benchmark.kept_drives import foreign_version
from similitude.benchmark.ladder_entrants import ladder
from similitude.benchmark.rivals import rivals
from similitude.benchmark.scoring import Score, score
from similitude.benchmark.tally import FALSE_PER_HOUR, tally, threshold_of

SEED = 20_000
BOUND = "bound"
NOT_INSTALLED = (
    "multi-body and drift plants are left out: pip install 'similitude[plants]' brings them "
    "(commonroad-vehicle-models)"
)


@dataclass(frozen=True, eq=False)
class Result:
    """What a run found; ``record`` is what its JSON file holds."""

    record: dict[str, Any]

    def rows(self, **where: str) -> list[dict[str, Any]]:
        """Return the rows of the table of cells that have these values."""
        return [row for row in self.record["rows"] if all(row[k] == v for k, v in where.items())]


def entrants(files: Sequence[str]) -> list[Entrant]:
    """Return every entrant: the ladder, the rivals, and those of files."""
    return [*ladder(), *rivals(), *(read_entrant(path) for path in files)]


def run_benchmark(
    *,
    quick: bool,
    part: str = "all",
    seed: int = SEED,
    files: Sequence[str | Path] = (),
    processes: int | None = None,
    tell: Callable[[str], None] = lambda _: None,
) -> Result:
    """Run the benchmark.

    Parameters
    ----------
    quick : bool              a few cells and seeds
    part : str                "all", "table" or "faults"; a quick run has both
    seed : int                of the first drive of each cell
    files : sequence          Python files with an entrant each
    processes : int or None   None: two, or one where there is one core
    tell : function           is told what is done, a line at a time

    Raises
    ------
    UsageError   an entrant's file cannot be used
    """
    files, begun = [str(path) for path in files], time.perf_counter()
    taking_part = entrants(files)
    foreign = foreign_version()
    wanted = cells(quick=quick, foreign=foreign is not None, part=part)
    found: dict[Cell, dict[str, list[Score]]] = {}
    workers = processes or min(2, os.cpu_count() or 1)
    for done, (cell, scores) in enumerate(_all_cells(wanted, seed, files, workers), 1):
        found[cell] = scores
        tell(f"{done} of {len(wanted)} cells: {cell.name}")
    names = [*(one.name for one in taking_part), BOUND]
    record = _record(wanted, found, names, taking_part) | {
        "schema": 1,
        "seed": seed,
        "quick": quick,
        "part": part,
        "seconds": round(time.perf_counter() - begun, 1),
        "processes": workers,
        "foreign": foreign,
        "notes": [] if foreign or quick or part == "faults" else [NOT_INSTALLED],
        "false_per_hour": FALSE_PER_HOUR,
    }
    return Result(record)


def _all_cells(
    wanted: Sequence[Cell], seed: int, files: Sequence[str], workers: int
) -> Iterator[tuple[Cell, dict[str, list[Score]]]]:
    """Every cell with its scores as it is done; one worker is this process itself."""
    if workers == 1:
        for cell in wanted:
            yield cell, run_cell(cell, seed, files)
        return
    with ProcessPoolExecutor(workers) as pool:
        jobs = {pool.submit(run_cell, cell, seed, files): cell for cell in wanted}
        for job in as_completed(jobs):
            yield jobs[job], job.result()


def run_cell(cell: Cell, seed: int, files: Sequence[str]) -> dict[str, list[Score]]:
    """Simulate a cell and score every entrant on it: name -> one score a drive."""
    taking_part = entrants(files)
    found: dict[str, list[Score]] = {one.name: [] for one in taking_part}
    found[BOUND] = []
    for drive, truth in drives(cell, seed):
        for one in taking_part:
            found[one.name].append(answer_scored(one, drive, truth))
        if cell.plant == "linear" and cell.fault == "none":
            found[BOUND].append(bound_score(drive, truth))
    return found


def answer_scored(one: Entrant, drive: Drive, truth: Truth) -> Score:
    """Ask an entrant and score its answer; what it raises is its score."""
    shown = drive.until(CHANGE_AT) if one.whole_log else drive
    begun = time.perf_counter()
    try:
        answer = one.estimate(shown)
    except Exception as error:  # an entrant's failure is its result
        return Score(f"{type(error).__name__}: {error}", rows=shown.t.size)
    return score(shown, truth, answer, seconds=time.perf_counter() - begun)


def _record(
    wanted: Sequence[Cell],
    found: dict[Cell, dict[str, list[Score]]],
    names: Sequence[str],
    taking_part: Sequence[Entrant],
) -> dict[str, Any]:
    rows, totals = [], []
    for name in names:
        everywhere = [s for cell in wanted for s in found[cell][name]]
        sound = [s for cell in wanted if cell.fault == "none" for s in found[cell][name]]
        threshold, hours = threshold_of(sound)
        total = tally(everywhere, threshold) if everywhere else {}
        faults = sorted({s.fault for s in everywhere if s.fault})
        totals.append({"estimator": name, "threshold": threshold, "sound_hours": hours, **total,
                       "faults": faults[:3]})  # fmt: skip
        rows += [
            {"manoeuvre": cell.manoeuvre, "plant": cell.plant, "fault": cell.fault, "estimator": name,
             **tally(found[cell][name], threshold)}
            for cell in wanted if found[cell][name]
        ]  # fmt: skip
    return {
        "cells": len(wanted),
        "drives": sum(cell.seeds for cell in wanted),
        "seeds": sorted({cell.seeds for cell in wanted}),
        "about": {one.name: one.about for one in taking_part},
        "totals": [one for one in totals if one.get("drives")],
        "rows": rows,
    }
