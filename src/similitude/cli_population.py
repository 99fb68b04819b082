"""The command `similitude population`: what a table of similar systems says, and what they keep to.

Invariant: exit code 0 when the table could be read; 3 when it could not.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from similitude.cli_usage import read_mapping
from similitude.errors import UsageError

READ = 'docs/populations.md, "The command"'
PAGE, RECORD = "population.html", "population.json"


def population(
    tables: Annotated[
        list[Path], typer.Argument(metavar="TABLE...", help="Tables of systems, CSV or Parquet.")
    ],
    system: Annotated[
        str, typer.Option(metavar="NAME|FILE.py", help="bicycle, or a file that holds a Model.")
    ] = "bicycle",
    base: Annotated[
        str | None, typer.Option(metavar="m,L,U", help="Repeating variables; the system's own if left out.")
    ] = None,
    renamed: Annotated[
        list[str] | None,
        typer.Option("--map", metavar="a*b=ab", help="Product of parameters = column; repeatable."),
    ] = None,
    at: Annotated[
        list[str] | None,
        typer.Option("--at", metavar='"U=25 m/s"', help="Value of a signal at which groups are stated."),
    ] = None,
    out: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder for the page and the JSON.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON instead of the page.")] = False,
) -> None:
    """Show the distributions, relations and prior of a table of similar systems."""
    from similitude.populations.population import read_population
    from similitude.populations.portrait import portrait_record, portray
    from similitude.report.summary import json_line
    from similitude.systems.named import named_system

    named = named_system(system, base=[n.strip() for n in base.split(",")] if base else None)
    columns = {**named.columns, **read_mapping(renamed or ())}
    stated = read_signals(at or (), named.groups)
    portrait = portray(read_population(list(tables), named.groups, columns=columns, at=stated))
    record = portrait_record(portrait)
    if out is not None:
        _write(portrait, record, out)
    if as_json:
        typer.echo(json_line(record))
        return
    from rich.console import Console

    from similitude.report.population_page import print_population

    print_population(portrait, Console(highlight=False))
    if out is not None:
        typer.echo(f"page: {out / PAGE}")


def read_signals(pairs, groups) -> dict[str, float]:
    """Turn `U=25 m/s` into {"U": 25.0}.

    Parameters
    ----------
    pairs : sequence of str    what each `--at` was given.
    groups : Groups            whose signals they are.

    Raises
    ------
    UsageError, UnitError      no `=`, no such signal, or no such unit.
    """
    from similitude.units import parse_quantity

    stated = {}
    for pair in pairs:
        name, equals, text = (part.strip() for part in pair.partition("="))
        if not equals or name not in groups.model.signals:
            raise UsageError(
                f"--at '{pair}' states no signal of {groups.model.name!r} "
                f"(signals: {', '.join(groups.model.signals) or 'none'})",
                usually="the sign = is missing, or a parameter that is no signal was meant.",
                paste='--at "U=25 m/s"',
                read=READ,
            )
        stated[name], _ = parse_quantity(text, expect=groups.model.quantity(name).dimension)
    return stated


def _write(portrait, record: dict, out: Path) -> None:
    """Write the page and the JSON, each beside its place first."""
    import json

    from similitude.report.population_page import population_html

    texts = {PAGE: population_html(portrait), RECORD: json.dumps(record, indent=1, allow_nan=False) + "\n"}
    try:
        out.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            part = out / f".{name}.part"
            part.write_text(text, encoding="utf-8")
            os.replace(part, out / name)
    except OSError as fault:
        raise UsageError(
            f"--out '{out}' cannot be written: {fault.strerror or fault}",
            usually="the name is that of a file, or the folder belongs to somebody else.",
            paste="--out population-out",
            read=READ,
        ) from fault
