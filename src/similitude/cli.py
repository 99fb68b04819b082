"""The command `similitude`: reads arguments, calls one function a command, sets the exit code.

Exit codes: 0 it ran, whatever the verdict; 2 the command cannot be carried out as written; 3 some
log or the vehicle file cannot be used. Only the standard library and typer are imported at the top,
so that `--help` answers at once.
"""

from __future__ import annotations

import contextlib
import gc
import signal
import sys
from collections.abc import Iterator, Sequence
from importlib import import_module
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Annotated

import typer

from similitude.cli_analyze import analyze
from similitude.cli_bench import bench
from similitude.cli_compare import compare
from similitude.cli_complaint import RAN, complain, exit_code
from similitude.cli_estimate import estimate
from similitude.cli_export import export
from similitude.cli_inspect import inspect
from similitude.cli_paper import paper
from similitude.cli_population import population
from similitude.cli_simulate import simulate
from similitude.cli_usage import (
    ESTIMATORS,
    check_estimator,
    check_state,
    list_fixes,
    no_such_vehicle,
    no_vehicle,
    out_is_a_file,
    read_mapping,
    read_spacing,
)
from similitude.errors import SimilitudeError, UsageError

if TYPE_CHECKING:
    from rich.console import Console

app = typer.Typer(
    help="Identify physical systems with the fewest unknowns physics allows.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command and leave with its exit code; errors of ours become messages on stderr.

    Parameters
    ----------
    arguments : sequence of str, optional
        The words after `similitude`; those of the process when left out.

    Raises
    ------
    SystemExit
        Always: 0 ran, 2 usage, 3 an input that cannot be used.
    """
    with contextlib.suppress(ValueError):  # not in the main thread
        # As an exception, so that half-written files are cleared away.
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # a terminal without Greek letters shows "?"
            stream.reconfigure(errors="replace")
    try:
        app(args=None if arguments is None else list(arguments), prog_name="similitude")
    except SimilitudeError as error:
        complain(error)
        raise SystemExit(exit_code(error)) from None


@app.command()
def identify(
    logs: Annotated[list[Path], typer.Argument(metavar="LOG...", help="Driving logs, CSV or Parquet.")],
    vehicle: Annotated[
        Path | None,
        typer.Option(metavar="FILE.toml", help="Vehicle file; start one with `vehicle --new`."),
    ] = None,
    estimator: Annotated[
        str, typer.Option(metavar="|".join(ESTIMATORS), help="How to estimate.")
    ] = "population",
    renamed: Annotated[
        list[str] | None,
        typer.Option("--map", metavar="delta=SWA", help="Our name = the log's name; repeatable."),
    ] = None,
    fixes: Annotated[
        list[str] | None,
        typer.Option(
            "--fix",
            metavar="NAME",
            callback=list_fixes,
            is_eager=True,
            help="Repair the log as a message proposes; repeatable, `--fix list` names them.",
        ),
    ] = None,
    spacing: Annotated[
        str | None,
        typer.Option(metavar='"0.4 m"', help="Estimate from rows at equal distances, not times."),
    ] = None,
    state: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Start where the last drive ended; keep where this one ends."),
    ] = None,
    out: Annotated[
        str | None,
        typer.Option(
            metavar="DIR",
            help="Folder for the results; several logs get DIR/<stem> each.",
            show_default="similitude-out/<stem>",
        ),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print one line of JSON a log instead of the page.")
    ] = False,
) -> None:
    """Tell from driving logs how stiff the tyres are, and how sure that is."""
    reading = {"mapping": read_mapping(renamed or ()), "fixes": tuple(fixes or ())}
    check_estimator(estimator)
    if vehicle is None:
        raise no_vehicle(logs)
    if not vehicle.is_file():
        raise no_such_vehicle(vehicle, logs)
    if out is not None and Path(out).is_file():
        raise out_is_a_file(out)
    how = {"estimator": estimator, "spacing": None if spacing is None else read_spacing(spacing)}
    check_state(state, how)
    raise typer.Exit(_identify(logs, vehicle, how, reading, state=state, out=out, as_json=as_json))


app.command()(inspect)
app.command()(analyze)
app.command()(population)
app.command()(simulate)
app.command()(compare)
app.command()(export)
app.command()(estimate)
app.command()(paper)
app.command()(bench)


@app.command()
def vehicle(
    new: Annotated[bool, typer.Option("--new", help="Print a commented vehicle file.")] = False,
) -> None:
    """Start a vehicle file: `similitude vehicle --new > car.toml`."""
    if not new:
        raise UsageError(
            "`similitude vehicle` was given nothing to do",
            usually="a new vehicle file is wanted: --new prints one, with a comment on each line.",
            paste="similitude vehicle --new > car.toml",
            read='docs/vehicle.md, "The vehicle file"',
        )
    from similitude.vehicle_file import NEW_VEHICLE

    typer.echo(NEW_VEHICLE.rstrip("\n"))


def _print_version(wanted: bool) -> None:
    if not wanted:
        return
    from importlib.metadata import PackageNotFoundError, version

    try:
        typer.echo(f"similitude {version('similitude')}")
    except PackageNotFoundError:
        typer.echo("similitude, run from its source without being installed")
    raise typer.Exit(RAN)


@app.callback()
def _options(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and leave."
        ),
    ] = False,
) -> None:
    """Take the options that stand before a command."""


def _identify(
    logs: Sequence[Path], vehicle: Path, how: dict, reading: dict, *,
    state: Path | None, out: str | None, as_json: bool,
) -> int:  # fmt: skip
    """Identify each log by itself; one that fails does not stop the others."""
    from rich.console import Console

    from similitude.report.folders import directories
    from similitude.report.progress import ProgressBar
    from similitude.vehicle_file import read_vehicle

    car = read_vehicle(vehicle)
    page = Console(highlight=False)
    worst = RAN
    with ProgressBar(3 * len(logs), console=Console(stderr=True)) as bar, _uncollected():
        for log, directory in zip(logs, directories(logs, out), strict=True):
            if log != logs[0]:
                gc.collect()
            try:
                record, run = _identify_one(log, car, how, reading, directory, bar, state)
            except SimilitudeError as error:
                with bar.aside():
                    complain(error)
                worst = max(worst, exit_code(error))
                continue
            with bar.aside():
                _show(record, run, page, as_json=as_json)
    return worst


@contextlib.contextmanager
def _uncollected() -> Iterator[None]:
    """Leave cycles alone: while libraries load and draw, to look for them takes long and finds nothing."""
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()  # what is there now stays to the end of the process
        gc.enable()


def _identify_one(log, car, how, reading, directory, bar, state: Path | None) -> tuple[dict, object]:
    """Read, estimate and write one log, then the state it ends in; its summary and its run."""
    from similitude.identification import identify as identify_log
    from similitude.log import read_log
    from similitude.saved_state import read_state, write_state

    steps_before = bar.done
    try:
        bar.begin(f"{log.name}: reading")
        read = read_log(log, vehicle=car, **reading)
        bar.begin(f"{log.name}: estimating")
        drawing = Thread(target=import_module, args=("similitude.report.files",))
        drawing.start()  # the libraries that draw load while the loops in C run
        if state is not None and state.exists():
            how = {**how, "state": read_state(state)}
        run = identify_log(read, car, **how)
        bar.begin(f"{log.name}: drawing")
        from similitude.report.files import write_report
        from similitude.report.summary import summary

        record = summary(run, write_report(run, directory))
        if state is not None:
            write_state(run.memory, state)
        return record, run
    finally:
        bar.finish_to(steps_before + 3)


def _show(record: dict, run, page: Console, *, as_json: bool) -> None:
    from similitude.report.summary import json_line
    from similitude.report.terminal import print_run

    if as_json:
        typer.echo(json_line(record))
    else:
        print_run(run, page, files=record["files"])


if __name__ == "__main__":
    main()
