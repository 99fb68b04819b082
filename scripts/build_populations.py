"""Builds the shipped populations from data/ and prints what each rests on (`make populations`)."""

from __future__ import annotations

import sys
from pathlib import Path

from rich import box
from rich.console import Console
from rich.table import Table

from similitude.populations.building import build_populations, page_of
from similitude.systems.bicycle import bicycle_groups

ROOT = Path(__file__).parents[1]
KEPT = ROOT / "src" / "similitude" / "populations" / "shipped.json"


def main() -> None:
    """Build, print, and write where `--write` is given."""
    built = build_populations(ROOT / "data", bicycle_groups())
    console = Console(width=110)
    for name, one in built.items():
        console.print(show(name, one))
        for source in one["sources"]:
            console.print(f"  from {source}", highlight=False)
    if "--write" in sys.argv:
        KEPT.write_text(page_of(built), encoding="utf-8")
        console.print(f"written: {KEPT.relative_to(ROOT)}")


def show(name: str, one: dict) -> Table:
    """One population: what is used, and what the tables say."""
    table = Table(title=f"{name}: {one['rows']} rows", box=box.SIMPLE_HEAD)
    for head in ("unknown", "used", "sd", "tables", "95 %", "sd seen", "sd of the next", "95 %", "systems"):
        table.add_column(head, justify="left" if head == "unknown" else "right")
    for unknown, mean, sd in zip(one["names"], one["mean"], one["sd"], strict=True):
        said = one["tables"].get(unknown, {})
        ends = ["{} to {}".format(*said[key]) if said.get(key) else "" for key in
                ("mean_interval", "predictive_sd_interval")]  # fmt: skip
        seen = [str(said.get(key, "")) for key in ("mean", "sd", "predictive_sd", "systems")]
        table.add_row(unknown, str(mean), str(sd), seen[0], ends[0], seen[1], seen[2], ends[1], seen[3])
    return table


if __name__ == "__main__":
    main()
