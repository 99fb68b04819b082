"""Prints one estimator in the benchmark's cells on own plants, without the rivals: some minutes.

`python scripts/benchmark_cells.py gusts straight` prints only cells whose names hold one of the words;
`--estimator with_ay` another than the population filter, `--estimator small` the small filter of
docs/embedded.md, without an alarm; `--seeds 60 --first 60000` drives sixty other cars a cell; `--foreign`
adds the plants of the extra `plants`. A full run with every estimator is `similitude bench`.
"""

from __future__ import annotations

import argparse
from dataclasses import replace

import numpy as np
from rich.console import Console
from rich.table import Table

from similitude.benchmark.cells import cells
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


def estimators() -> dict[str, Entrant]:
    """Those that can be asked for, by name."""
    return {one.name: one for one in (*ladder(), Entrant("small", "the small filter", small))}


def asked() -> argparse.Namespace:
    """What the command line says."""
    parser = argparse.ArgumentParser(description="One estimator in the benchmark's cells on own plants.")
    parser.add_argument("words", nargs="*", help="print only cells whose names hold one of these")
    parser.add_argument("--estimator", choices=list(estimators()), default="population")
    parser.add_argument("--foreign", action="store_true", help="foreign plants too")
    parser.add_argument("--seeds", type=int, help="drives a cell; without it as many as the benchmark has")
    parser.add_argument("--first", type=int, default=SEED, help="seed of the first")
    return parser.parse_args()


def main() -> None:
    """Print a line a cell as it is done, and the table at the end."""
    told = asked()
    one = estimators()[told.estimator]
    table = Table(title=f"{one.name}, cell by cell")
    for name in ("cell", *(title for title, _ in COLUMNS.values())):
        table.add_column(name, justify="left" if name == "cell" else "right")
    for cell in cells(quick=False, foreign=told.foreign):
        if told.words and not any(word in cell.name for word in told.words):
            continue
        driven = drives(replace(cell, seeds=told.seeds or cell.seeds), told.first)
        row = tally([answer_scored(one, drive, truth) for drive, truth in driven], 1.0)
        texts = ["" if row[n] is None else how.format(row[n]) for n, (_, how) in COLUMNS.items()]
        print(cell.name, *texts, sep=" | ", flush=True)
        table.add_row(cell.name, *texts)
    Console(width=130).print(table)


if __name__ == "__main__":
    main()
