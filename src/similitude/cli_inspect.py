"""The command `similitude inspect`: look at logs before anything is estimated.

Invariant: exit code 0 when it could look, whatever it found; 3 when there was nothing to look at.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Annotated

import typer

from similitude.cli_complaint import RAN, complain, exit_code
from similitude.cli_usage import no_such_vehicle, read_mapping
from similitude.errors import SimilitudeError, UsageError

READ = 'docs/inspect.md, "The command"'


def inspect(
    logs: Annotated[list[Path], typer.Argument(metavar="LOG...", help="Any tables, CSV or Parquet.")],
    vehicle: Annotated[
        Path | None,
        typer.Option(metavar="FILE.toml", help="Vehicle file; its wheelbase tells what can be learnt."),
    ] = None,
    renamed: Annotated[
        list[str] | None,
        typer.Option("--map", metavar="delta=SWA", help="Our name = the log's name; repeatable."),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print one line of JSON a log instead of the page.")
    ] = False,
    html: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the page with charts; of one log."),
    ] = None,
) -> None:
    """Look at logs before estimating: columns, clock, noise, lag, offsets, what they can show."""
    mapping = read_mapping(renamed or ())
    if vehicle is not None and not vehicle.is_file():
        raise no_such_vehicle(vehicle, logs)
    if html is not None and len(logs) > 1:
        raise _one_page(html, logs)
    raise typer.Exit(_inspect(logs, vehicle, mapping, as_json=as_json, html=html))


def _inspect(
    logs: list[Path], vehicle: Path | None, mapping: dict[str, str], *, as_json: bool, html: Path | None
) -> int:
    """Look at each log by itself; one that is no table does not stop the others."""
    from similitude.inspection.inspection import inspect_log
    from similitude.vehicle_file import read_vehicle

    car = None if vehicle is None else read_vehicle(vehicle)
    worst = RAN
    for log in logs:
        try:
            look = inspect_log(log, vehicle=car, mapping=mapping)
        except SimilitudeError as error:
            complain(error)
            worst = max(worst, exit_code(error))
            continue
        if html is not None:
            _write_html(look, html)
        _show(look, as_json=as_json)
    return worst


def _show(look, *, as_json: bool) -> None:
    if as_json:
        from similitude.report.inspect_json import inspect_line

        typer.echo(inspect_line(look))
        return
    from rich.console import Console

    from similitude.report.inspect_terminal import print_inspection

    print_inspection(look, Console(highlight=False))


def _write_html(look, path: Path) -> None:
    """Write the page beside its place and move it there, so that no half of it is ever seen."""
    from similitude.report.inspect_html import inspect_html

    part = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, part = tempfile.mkstemp(prefix=".similitude-", dir=path.parent)
        with open(handle, "w", encoding="utf-8") as file:
            file.write(inspect_html(look))
        os.chmod(part, 0o644)
        os.replace(part, path)
    except OSError as fault:
        if part is not None:
            Path(part).unlink(missing_ok=True)
        raise UsageError(
            f"--html '{path}' cannot be written: {fault.strerror or fault}",
            usually="the name is that of a folder, or the folder belongs to somebody else.",
            paste="--html inspection.html",
            read=READ,
        ) from fault


def _one_page(html: Path, logs: list[Path]) -> UsageError:
    return UsageError(
        f"--html '{html}' is one page, and {len(logs)} logs were given",
        usually="a page for each is wanted: look at them one by one.",
        paste=f"similitude inspect {logs[0]} --html {logs[0].with_suffix('.html').name}",
        read=READ,
    )
