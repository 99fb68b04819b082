"""Prints the population filter in the benchmark's cells on own plants, without the rivals: some minutes.

`python scripts/benchmark_cells.py gusts straight` prints only cells whose names hold one of the words; with
`--small` it is the small filter of docs/embedded.md that drives, without an alarm; `--seeds 60 --first 60000`
drives sixty other cars a cell.
A full run with every estimator is `similitude bench`.
"""

from __future__ import annotations

import argparse
from dataclasses import replace

import numpy as np
from rich.console import Console
from rich.table import Table

from similitude.benchmark.cells import SEEDS, cells
from similitude.benchmark.drives import Drive, drives
from similitude.benchmark.entrant import Answer, Entrant
from similitude.benchmark.ladder_entrants import ladder, prepared
from similitude.benchmark.running import SEED, answer_scored
from similitude.benchmark.tally import tally
from similitude.program.library import shipped

COLUMNS = {
    "rms": ("rms ln K", "{:.1%}"),
    "bias": ("bias", "{:+.1%}"),
    "coverage": ("covered", "{:.1%}"),
    "identified": ("identified", "{:.0%}"),
    "wrong": ("wrong", "{}"),
    "half_way_s": ("half-way", "{:.2f} s"),
    "alarm_s": ("alarm", "{:.2f} s"),
    "missed": ("missed", "{:.0%}"),
    "false_alarms": ("false", "{}"),
}


def small(drive: Drive) -> Answer:
    """The small filter, with the lag that all of ours have."""
    done = replace(prepared(drive).setup, library=shipped("bicycle_small_population")).run()
    return Answer(K=done.output("estimate"), ln_K_std=np.sqrt(done.output("variance")))


def asked() -> argparse.Namespace:
    """What the command line says."""
    parser = argparse.ArgumentParser(
        description="The population filter in the benchmark's cells on own plants."
    )
    parser.add_argument("words", nargs="*", help="print only cells whose names hold one of these")
    parser.add_argument("--small", action="store_true", help="the small filter in its place")
    parser.add_argument("--seeds", type=int, default=SEEDS, help="drives a cell")
    parser.add_argument("--first", type=int, default=SEED, help="seed of the first")
    return parser.parse_args()


def main() -> None:
    """Print a line a cell as it is done, and the table at the end."""
    told = asked()
    one = next(entrant for entrant in ladder() if entrant.name == "population")
    if told.small:
        one = Entrant("small", "the small filter", small)
    table = Table(title=f"The {one.name} filter, cell by cell")
    for name in ("cell", *(title for title, _ in COLUMNS.values())):
        table.add_column(name, justify="left" if name == "cell" else "right")
    for cell in cells(quick=False, foreign=False):
        if told.words and not any(word in cell.name for word in told.words):
            continue
        driven = drives(replace(cell, seeds=told.seeds), told.first)
        row = tally([answer_scored(one, drive, truth) for drive, truth in driven], 1.0)
        texts = ["" if row[n] is None else how.format(row[n]) for n, (_, how) in COLUMNS.items()]
        print(cell.name, *texts, sep=" | ", flush=True)
        table.add_row(cell.name, *texts)
    Console(width=130).print(table)


if __name__ == "__main__":
    main()
