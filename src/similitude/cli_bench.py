"""The command `similitude bench`: every estimator over the same drives, whose truth is known.

Invariant: exit code 0 when the result was written, whatever it says; 2 when the command must be written
otherwise. Nothing heavy is imported until the work begins.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from similitude.errors import UsageError

DEFAULT = "similitude-out/bench"
PARTS = ("all", "table", "faults")


def bench(
    quick: Annotated[
        bool, typer.Option("--quick", help="A few cells and seeds, in a minute, instead of all.")
    ] = False,
    part: Annotated[
        str, typer.Option(metavar="|".join(PARTS), help="Manoeuvres × plants, faults, or both.")
    ] = "all",
    entrants: Annotated[
        list[Path] | None,
        typer.Option(
            "--entrant", metavar="FILE.py", help="An estimator of your own, estimate(drive); repeatable."
        ),
    ] = None,
    out: Annotated[Path, typer.Option(metavar="DIR", help="Folder for the numbers and the page.")] = Path(
        DEFAULT
    ),
    seed: Annotated[
        int, typer.Option(metavar="N", min=0, help="Of the first drive of each cell; the same N, the same.")
    ] = 20_000,
    processes: Annotated[
        int | None, typer.Option(metavar="N", min=1, help="Cells at a time.", show_default="2")
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print one line of JSON instead of the tables.")
    ] = False,
) -> None:
    """Benchmark estimators of the tyre stiffness: manoeuvres, plants, faults, alarms, cost."""
    if out.exists() and not out.is_dir():
        raise UsageError(
            f"--out '{out}' is a file, and the result is a folder",
            usually="the name of the page was given; it is called benchmark.html inside the folder.",
            paste=f"similitude bench --quick --out {DEFAULT}",
            read='docs/benchmark.md, "The command"',
        )
    if part not in PARTS:
        raise UsageError(
            f"--part '{part}' is none of {', '.join(PARTS)}",
            usually="it is a matter of spelling.",
            paste="similitude bench --part faults",
            read='docs/benchmark.md, "The command"',
        )
    # Before NumPy: cells run side by side, and small matrices gain nothing from threads of their own.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    from rich.console import Console

    from similitude.benchmark.running import run_benchmark

    with Console(stderr=True).status("cars are drawn") as status:
        result = run_benchmark(
            quick=quick, part=part, seed=seed, files=entrants or (), processes=processes, tell=status.update
        )
    from similitude.benchmark.result_files import plain, write_result

    files = write_result(result, out)
    if as_json:
        import json

        typer.echo(json.dumps(plain(result.record) | {"files": files}, ensure_ascii=False))
        return
    from similitude.benchmark.page import print_result

    console = Console(highlight=False)
    print_result(result, console)
    for kind, path in files.items():
        console.print(f"{kind}: {path}", soft_wrap=True)
