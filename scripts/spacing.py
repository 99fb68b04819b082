"""Prints what rows at equal distances give against rows at equal times, on the same logs (`make spacing`).

The bundled logs, and a simulated car whose speed swings between 8 and 26 m/s: there the truth is known. A log
that is not excited leaves K near the population's by either way, and cannot judge them.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table
from tests.simulated_drive import CAR, drive, vehicle

from similitude import identify, read_log, read_vehicle
from similitude.run import Run

ROOT = Path(__file__).parents[1]
SHARE = 0.15  # of the wheelbase between two rows
DRIVES = 6
LOGS = {
    "rav4_straight": "rav4",
    "bmw_m8_double_lane_change": "bmw_m8",
    **{f"f1tenth_ds{i}": "f1tenth" for i in range(1, 6)},
}


def main() -> None:
    """Identify every log both ways and print one table."""
    table = Table(title="Rows at equal times (t) and at equal distances (s)", box=box.SIMPLE_HEAD)
    for name in ("log", "rows t", "rows s", "K t", "K s", "sd t", "sd s", "apart", "says t", "says s"):
        table.add_column(name, justify="left" if name in ("log", "says t", "says s") else "right")
    for stem, car in LOGS.items():
        known = read_vehicle(ROOT / "data" / f"{car}.toml")
        row(table, stem, read_log(ROOT / "data" / f"{stem}.csv", vehicle=known), known)
    for seed in range(DRIVES):
        log = drive(seconds=120, U=lambda t: 17 + 9 * np.sin(2 * np.pi * t / 20), seed=seed)
        row(table, f"simulated, K = {CAR['K']:.0f}", log, vehicle())
    Console(width=130).print(table)


def row(table: Table, name: str, log, car) -> None:
    """One log both ways."""
    by_time = identify(log, car)
    by_way = identify(log, car, spacing=SHARE * car.L.value)
    travelled = np.sum(np.maximum(log.U[1:], 0.0) * np.diff(log.t))
    table.add_row(
        name,
        str(log.samples),
        f"{travelled / (SHARE * car.L.value):.0f}",
        *(f"{run.K.value:.3g}" for run in (by_time, by_way)),
        *(f"{100 * run.K.std / run.K.value:.1f} %" for run in (by_time, by_way)),
        _apart(by_time, by_way),
        by_time.verdict,
        by_way.verdict,
    )


def _apart(by_time: Run, by_way: Run) -> str:
    """How far the second K lies from the first, in the larger of their sds; nothing where neither learnt."""
    if "not_excited" in (by_time.verdict, by_way.verdict):
        return "cannot judge"
    sd = max(run.K.std / run.K.value for run in (by_time, by_way))
    return f"{np.log(by_way.K.value / by_time.K.value) / sd:+.1f} sd"


if __name__ == "__main__":
    main()
