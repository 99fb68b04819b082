"""The command `similitude analyze`: a model's units, invariances, groups, scalings and what outputs tell.

Invariant: exit code 0 when there is a page; 2 for a name that means nothing; 3 for a file or a model that
cannot be used.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from similitude.errors import UsageError

READ = 'docs/analyze.md, "The command"'


def analyze(
    system: Annotated[
        str, typer.Argument(metavar="SYSTEM|FILE.py", help="A shipped system, or a file that makes a Model.")
    ],
    base: Annotated[
        str | None,
        typer.Option(metavar="m,L,U", help="Repeating variables; else the system's own, or advised."),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print one line of JSON instead of the page.")
    ] = False,
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Write the page as HTML, and the JSON, into a folder.")
    ] = None,
) -> None:
    """Look a model over: units, invariances, Pi groups, rewritten equations, scalings, what outputs tell."""
    names = None if base is None else _names(base)
    from similitude.analysis.analysis import analyze_model
    from similitude.systems.system_file import find_model

    found = find_model(system)
    chosen, origin = (names, "as asked") if names is not None else (found.base, "the system's own")
    analysis = analyze_model(found.model, base=chosen, base_origin=origin, meanings=found.meanings or {})
    files = {}
    if out is not None:
        from similitude.report.analysis_files import write_analysis

        files = write_analysis(analysis, out)
    _show(analysis, files, as_json=as_json)


def _show(analysis, files: dict[str, str], *, as_json: bool) -> None:
    if as_json:
        from similitude.report.analysis_json import analysis_line

        typer.echo(analysis_line(analysis))
        return
    from rich.console import Console

    from similitude.report.analysis_terminal import print_analysis

    console = Console(highlight=False)
    print_analysis(analysis, console)
    for path in files.values():
        console.print(path, style="dim", soft_wrap=True)


def _names(text: str) -> list[str]:
    """The names of ``m,L,U``.

    Raises
    ------
    UsageError    an empty name, or one twice.
    """
    names = [name.strip() for name in text.split(",")]
    if not all(names) or len(set(names)) < len(names):
        raise UsageError(
            f"--base '{text}' is no list of different names",
            usually="a comma too many, or a name typed twice.",
            paste="--base m,L,U",
            read=READ,
        )
    return names
