"""The command `similitude compare`: how far an estimate is from the truth of a simulated drive.

Invariant: nothing heavy is imported until both files were named.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def compare(
    estimate: Annotated[
        Path, typer.Argument(metavar="ESTIMATE", help="estimate.parquet, or the folder it lies in.")
    ],
    truth: Annotated[Path, typer.Argument(metavar="TRUTH", help="The truth that `simulate` wrote.")],
    as_json: Annotated[
        bool, typer.Option("--json", help="Print one line of JSON instead of the page.")
    ] = False,
) -> None:
    """Compare an estimate with the truth of the drive: error, coverage, delay after a change."""
    from similitude.simulation.comparison import SETTLING, compare

    found = compare(estimate, truth)
    if as_json:
        import json
        from dataclasses import asdict

        typer.echo(json.dumps({"schema": 1, **asdict(found)}))
        return
    typer.echo(f"K at the end   {found.estimate_end:.1f} m^2/s^2 where {found.truth_end:.1f} is true")
    typer.echo(
        f"error of ln K  {100 * found.rms:.1f} % rms after {SETTLING:g} s; over the last 20 s "
        f"{100 * found.rms_end:.1f} %, of which {100 * found.bias_end:+.1f} % are bias"
    )
    typer.echo(f"95 % interval  covers {100 * found.coverage:.1f} % of {found.rows} rows")
    for change in found.changes:
        delay = "never half-way" if change.half_way is None else f"half-way after {change.half_way:.2f} s"
        typer.echo(f"at {change.t:.2f} s     {change.before:.1f} to {change.after:.1f} m^2/s^2: {delay}")
