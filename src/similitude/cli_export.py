"""The command `similitude export`: an estimator as a folder of C for a microcontroller, and its proof.

Invariant: exit code 0 when the folder was written, or its self-test passed; 3 when a word differs.
"""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import Annotated

import typer

from similitude.errors import UnitError, UsageError

READ = 'docs/embedded.md, "The command"'
LINE = "similitude export bicycle --estimator population --real float --target cortex-m4f --out firmware"


def export(
    system: Annotated[
        str | None,
        typer.Argument(
            metavar="SYSTEM|FILE.py",
            help="bicycle, saturating_bicycle, bicycle_with_accelerometer, or a file of yours.",
        ),
    ] = None,
    estimator: Annotated[
        str | None,
        typer.Option(
            metavar="population|small_population|paper|band|output_error|robust|monitor",
            help="What to export; left out, the one a FILE.py holds.",
        ),
    ] = None,
    real: Annotated[
        str | None, typer.Option(metavar="float|double|fixed", help="Type of every number.")
    ] = None,
    target: Annotated[
        str | None,
        typer.Option(metavar="cortex-m4f|cortex-m3|cortex-m0|rv32|avr|host", help="Where it will run."),
    ] = None,
    out: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder to write.")] = None,
    vehicle: Annotated[
        Path | None,
        typer.Option(metavar="FILE.toml", help="Vehicle file; without it, a reference car's numbers."),
    ] = None,
    sample_time: Annotated[
        str | None,
        typer.Option(metavar='"10 ms"', help="Time between samples.", show_default="10 ms"),
    ] = None,
    verify: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Rerun the self-test of an exported folder on this machine."),
    ] = None,
) -> None:
    """Write an estimator as C for a microcontroller, with self-test and measured cost."""
    if verify is not None:
        _verify(verify, system)
        return
    named = {"SYSTEM": system, "--estimator": estimator, "--real": real, "--target": target, "--out": out}
    if system is not None and system.endswith(".py"):
        del named["--estimator"]  # the file may hold one
    absent = [name for name, value in named.items() if value is None]
    if absent:
        raise UsageError(
            f"`similitude export` was not told {', '.join(absent)}",
            usually="these have no default: they depend on the part and on what is to be estimated.",
            paste=LINE,
            read=READ,
        )
    if vehicle is not None and not vehicle.is_file():
        raise UsageError(
            f"--vehicle '{vehicle}': there is no such file (looked in {Path.cwd()})",
            usually="the path is that of another folder, or the file has yet to be written.",
            paste=f"similitude vehicle --new > {shlex.quote(str(vehicle))}",
            read='docs/vehicle.md, "The vehicle file"',
        )
    step = None if sample_time is None else _seconds(sample_time)
    from similitude.embedded.folder import export as write_export

    _tell(
        write_export(
            system, estimator=estimator, real=real, target=target, out=out, vehicle=vehicle, sample_time=step
        )
    )


def _seconds(text: str) -> float:
    from similitude.units import TIME, parse_quantity

    try:
        value, _ = parse_quantity(text, expect=TIME)
    except UnitError as error:
        raise _no_time(text, f": {error.what}") from None
    if not 0 < value < 60:
        raise _no_time(text, "")
    return value


def _no_time(text: str, why: str) -> UsageError:
    return UsageError(
        f"--sample-time '{text}' is no time between two samples{why}",
        usually="the unit is missing, or the rate was given in its place.",
        paste='--sample-time "10 ms"',
        read=READ,
    )


def _tell(done) -> None:
    typer.echo(f"{done.folder}: {done.name}, {len(done.files)} files; start with README.md")
    for name, (value, unit, origin) in done.numbers.assumed.items():
        typer.echo(f"  {name} = {value:.6g} {unit}  ({origin})")
    if done.advice:
        typer.echo(f"  {done.advice}")
    cost = done.cost
    if cost is not None:
        typer.echo(
            f"  {cost.target}, {cost.level}: {cost.mean:g} {cost.unit} a sample, {cost.most} at most; flash "
            f"{cost.flash} B, RAM {cost.state} B, stack {cost.stack} B; {cost.differing} words differ"
        )
    elif done.missing:
        typer.echo(
            f"  cost not measured: {', '.join(done.missing)} missing here; README.md says what to install"
        )


def _verify(folder: Path, system: str | None) -> None:
    if system is not None:
        raise UsageError(
            f"--verify '{folder}' was given together with '{system}'",
            usually="the folder alone is meant: it knows what it was made from.",
            paste=f"similitude export --verify {shlex.quote(str(folder))}",
            read='docs/embedded.md, "Verify"',
        )
    from similitude.embedded.verify import verify_folder

    done = verify_folder(folder)
    typer.echo(
        f"{folder}: {done.name} in {done.real}, {done.samples} samples, 0 of {done.words} words differ "
        f"({', '.join(done.levels)}; {done.compiler})"
    )
