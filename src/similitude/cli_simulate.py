"""The command `similitude simulate`: a drive whose truth is known, from a scenario file.

Invariant: exit code 0 when the drive was written; 2 when the command must be written otherwise; 3
when the scenario cannot be driven. Nothing heavy is imported until a drive is asked for.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from similitude.errors import UsageError

READ = 'docs/simulate.md, "The command"'


def simulate(
    scenario: Annotated[
        str | None, typer.Argument(metavar="SCENARIO", help="Name of a shipped scenario, or a TOML file.")
    ] = None,
    listed: Annotated[bool, typer.Option("--list", help="Print the shipped scenarios.")] = False,
    show: Annotated[bool, typer.Option("--show", help="Print the scenario file instead.")] = False,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.csv|.parquet",
            help="The log; its vehicle file and its truth go beside it.",
            show_default="<scenario>.csv",
        ),
    ] = None,
    truth: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.csv|.parquet", help="Where the truth goes.", show_default="<out>_truth.<end>"
        ),
    ] = None,
    seed: Annotated[int, typer.Option(metavar="N", min=0, help="Which drive; the same N, the same.")] = 0,
    changes: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="KEY=VALUE", help='Change a value: --set "driver.rms=1 mrad".'),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print one line of JSON instead of the page.")
    ] = False,
) -> None:
    """Drive a scenario: write the log a car would have written, and the truth it does not know."""
    if listed:
        _list()
        return
    if scenario is None:
        raise UsageError(
            "`similitude simulate` was given no scenario",
            usually="a shipped one is wanted; --list prints them.",
            paste="similitude simulate slalom",
            read=READ,
        )
    if show:
        _show_file(scenario)
        return
    _simulate(scenario, _read_changes(changes or ()), out, truth, seed, as_json=as_json)


def _read_changes(pairs) -> dict[str, str]:
    changes: dict[str, str] = {}
    for pair in pairs:
        name, equals, value = (part.strip() for part in pair.partition("="))
        if not (name and equals and value):
            raise UsageError(
                f"--set '{pair}' does not change a value",
                usually="the sign = is missing, or a side is empty.",
                paste='--set "sensors.r.noise=0.1 deg/s"',
                read=READ,
            )
        changes[name] = value
    return changes


def _list() -> None:
    import tomllib

    from similitude.simulation.scenario import shipped

    for name, path in shipped().items():
        title = tomllib.loads(path.read_text(encoding="utf-8")).get("title", "")
        typer.echo(f"{name:<20} {title}")


def _show_file(scenario: str) -> None:
    from similitude.simulation.scenario import find_scenario

    typer.echo(find_scenario(scenario).read_text(encoding="utf-8").rstrip("\n"))


def _simulate(scenario, changes, out, truth, seed, *, as_json: bool) -> None:
    from similitude.simulation.recording import run_scenario
    from similitude.simulation.recording_files import file_names, write_recording
    from similitude.simulation.scenario import read_scenario

    read = read_scenario(scenario, changes=changes)
    out = Path(f"{read.name}.csv") if out is None else out
    file_names(out, truth)  # before the work, not after it
    recording = run_scenario(read, [seed])[0]
    files = write_recording(recording, out, truth=truth)
    if as_json:
        import json

        typer.echo(json.dumps(_record(recording, files), ensure_ascii=False))
    else:
        _print(read, recording, files)


def _record(recording, files: dict[str, str]) -> dict:
    import numpy as np

    truth = recording.truth
    return {
        "schema": 1,
        "scenario": recording.scenario,
        "seed": recording.seed,
        "samples": len(truth["t [s]"]),
        "duration_s": float(truth["t [s]"][-1]),
        "ay_rms": float(np.sqrt(np.mean(np.square(truth["ay [m/s^2]"])))),
        "ay_max": float(np.max(np.abs(truth["ay [m/s^2]"]))),
        "K": {"first": float(truth["K [m^2/s^2]"][0]), "last": float(truth["K [m^2/s^2]"][-1]),
              "least": float(truth["K [m^2/s^2]"].min()), "unit": "m^2/s^2"},
        "warnings": list(recording.warnings),
        "files": files,
    }  # fmt: skip


def _print(scenario, recording, files: dict[str, str]) -> None:
    import shlex

    record = _record(recording, files)
    K = record["K"]
    typer.echo(f"{scenario.title or scenario.name} (seed {recording.seed})")
    typer.echo(
        f"  {record['samples']} rows in {record['duration_s']:.6g} s; lateral acceleration "
        f"{record['ay_rms']:.2f} m/s^2 rms, {record['ay_max']:.1f} at most"
    )
    typer.echo(f"  K = {K['first']:.1f} m^2/s^2 at first, {K['least']:.1f} at least, {K['last']:.1f} at last")
    for kind, path in files.items():
        typer.echo(f"  {kind:<8} {path}")
    for warning in recording.warnings:
        typer.echo(f"  note: {warning}")
    log, vehicle = shlex.quote(files["log"]), shlex.quote(files["vehicle"])
    folder = shlex.quote(f"similitude-out/{Path(files['log']).stem}")
    typer.echo(f"next: similitude identify {log} --vehicle {vehicle}")
    typer.echo(f"then: similitude compare {folder} {shlex.quote(files['truth'])}")
