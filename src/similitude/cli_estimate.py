"""The command `similitude estimate`: the estimator that a Python file makes, over logs.

Invariant: exit code 0 when every log could be read, whatever the verdict; 3 when one could not; one bad log
does not stop the others.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from similitude.cli_complaint import RAN, complain, exit_code


def estimate(
    file: Annotated[Path, typer.Argument(metavar="FILE.py", help="A file that makes an estimator.")],
    logs: Annotated[list[Path], typer.Argument(metavar="LOG...", help="Logs, CSV or Parquet.")],
    as_json: Annotated[bool, typer.Option("--json", help="Print one line of JSON a log.")] = False,
) -> None:
    """Estimate the unknowns of a model of your own from logs."""
    from similitude.any_model.record import estimate_record
    from similitude.embedded.system import find_estimator
    from similitude.errors import SimilitudeError
    from similitude.report.summary import json_line

    estimator = find_estimator(file)
    if not as_json:
        typer.echo(str(estimator))
    worst = RAN
    for log in logs:
        try:
            found = estimator.run(log)
        except SimilitudeError as error:
            complain(error)
            worst = max(worst, exit_code(error))
            continue
        typer.echo(json_line(estimate_record(estimator, found, str(log))) if as_json else f"\n{log}\n{found}")
    if worst != RAN:
        raise typer.Exit(worst)
