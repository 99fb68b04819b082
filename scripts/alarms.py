"""Prints how often the change alarm rings for nothing and how late it rings for something (`make alarms`).

Forty-eight hours of simulated roads with speed changes, kerbs and gusts, and the delays over the size of
the change and the lateral acceleration; ten minutes on two cores. A whole number after the name is
another seed.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from rich.console import Console
from rich.table import Table
from tests.montecarlo.alarms import CLEAN, delays, false_alarms, upper_bound
from tests.montecarlo.road import NUISANCE

from similitude.monitor_config import RISE_MORE, THRESHOLD

SEED = 80_000
CARS = 36  # of each kind and installation, ten minutes each: 48 h
THRESHOLDS = (6.5, 7.5, 8.5, THRESHOLD, 10.5)
SIZES = (0.5, 0.6, 0.7, 0.3, 1.5, 2.0)
LATERAL = (0.2, 0.4, 0.8, 1.2)  # m/s^2 rms


def main() -> None:
    """Print both tables."""
    console = Console(width=120)
    seed = int(sys.argv[1]) if len(sys.argv) > 1 else SEED
    console.print(delay_table(seed))
    console.print(false_alarm_table(seed))


def false_alarm_table(seed: int) -> Table:
    """Alarms in sound drives, and hours between two of them."""
    found = false_alarms(seed, cars=CARS, thresholds=[(h, h + RISE_MORE) for h in THRESHOLDS])
    hours = sum(one for one, _ in found.values())
    table = Table(title=f"False alarms in {hours:.0f} h by threshold ({THRESHOLD:g} is used)")
    table.add_column("drives")
    for h in THRESHOLDS:
        table.add_column(f"{h:g}", justify="right")
    for (kind, installation), (driven, counts) in found.items():
        table.add_row(f"{kind}, {installation}, {driven:.0f} h", *map(str, counts))
    total = sum(counts for _, counts in found.values())
    table.add_section()
    table.add_row("all", *map(str, total))
    table.add_row("in 10 h", *(f"{10 * n / hours:.2f}" for n in total))
    table.add_row("in 10 h, 95 % upper bound", *(f"{10 * upper_bound(n) / hours:.2f}" for n in total))
    return table


def delay_table(seed: int) -> Table:
    """Delay, misses and the size told, over the size of the change and the lateral acceleration."""
    table = Table(title="Delay of the alarm after K changed by a factor, 100 cars a row")
    for name in (
        "K x",
        "plant",
        "rms ay",
        "median",
        "p90",
        "missed",
        "armed",
        "told",
        "sd told",
        "sd claimed",
    ):
        table.add_column(name, justify="right")
    cells = [(f, "clean", CLEAN, ay) for f in SIZES for ay in LATERAL]
    cells += [(f, "nuisance", NUISANCE, ay) for f in (0.5, 0.7) for ay in (0.4, 1.2)]
    for number, (factor, plant, installation, lateral) in enumerate(cells):
        d = delays(seed + 1000 + number, cars=100, factor=factor, lateral=lateral, installation=installation)
        table.add_row(
            f"{factor:g}", plant, f"{lateral:g} m/s²", f"{d.quantile(0.5):.2f} s", f"{d.quantile(0.9):.2f} s",
            f"{100 * d.missed:.0f} %", f"{100 * d.armed:.0f} %",
            *((f"{100 * d.change.mean():+.0f} %", f"{100 * d.change.std():.0f} %",
               f"{100 * d.std.mean():.0f} %") if d.change.size else ("", "", "")),
        )  # fmt: skip
    return table


if __name__ == "__main__":
    main()
