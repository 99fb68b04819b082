"""The command `similitude paper`: the paper's figures, equations and claims beside ours, as one page.

Invariant: exit code 0 when the report was written, whatever holds; 2 when the folder cannot be
written. Nothing heavy is imported until the work begins.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from similitude.errors import UsageError

DEFAULT = "similitude-out/paper"


def paper(
    out: Annotated[
        Path, typer.Option(metavar="DIR", help="Folder for the page, the pictures and the claims.")
    ] = Path(DEFAULT),
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the claims as one line of JSON instead of the table.")
    ] = False,
) -> None:
    """Reproduce the paper this package follows, line by line: figures, equations, claims."""
    if out.exists() and not out.is_dir():
        raise UsageError(
            f"--out '{out}' is a file, and the report is a folder",
            usually="the name of the page was given; it is called paper.html inside the folder.",
            paste=f"similitude paper --out {DEFAULT}",
            read='docs/paper.md, "The command"',
        )
    from rich.console import Console

    from similitude.paper.folder import write
    from similitude.paper.pictures import PICTURES
    from similitude.paper.reproduction import SUBJECTS, reproduce
    from similitude.report.progress import ProgressBar

    steps = len(SUBJECTS) + len(PICTURES) + 2
    with ProgressBar(steps, console=Console(stderr=True)) as bar:
        done = reproduce(bar.begin)
        files = write(done, out)
    if as_json:
        import json

        typer.echo(json.dumps(done.records, ensure_ascii=False))
    else:
        _print(done, files)


def _print(done, files: dict[str, str]) -> None:
    """The claims as a table a line each, and where the page is."""
    from rich import box
    from rich.console import Console
    from rich.table import Table

    from similitude.paper.companion import shown
    from similitude.paper.folder import REPORT

    table = Table(title="The paper's claims", title_justify="left", box=box.SIMPLE_HEAD)
    for heading in ("claim", "printed", "ours", "verdict"):
        table.add_column(heading, overflow="fold", no_wrap=heading in ("claim", "verdict"))
    for claim in done.claims:
        table.add_row(claim.id, shown(claim.printed), shown(claim.ours), claim.verdict)
    console = Console(highlight=False)
    console.print(table)
    count = ", ".join(f"{n} {word}" for word, n in done.count().items())
    console.print(f"{len(done.claims)} claims: {count}", soft_wrap=True)
    console.print(f"page: {files[REPORT]}", soft_wrap=True)
