"""All files of one run in one folder: complete, or not there at all.

Invariant: everything is built in a hidden temporary folder inside the destination (so that the move
never crosses a file system) and moved with `os.replace`; `summary.json` is moved last and an older
one is removed first, so a folder that holds `summary.json` holds all files of that one run.
"""

from __future__ import annotations

import contextlib
import os
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING

from similitude.errors import UsageError
from similitude.report.folders import DEFAULT_DIRECTORY
from similitude.report.html_report import html_report
from similitude.report.plot import save_plot
from similitude.report.summary import json_page, summary
from similitude.report.table import write_estimate

if TYPE_CHECKING:
    from similitude.run import Run

FILE_NAMES = {  # in the order they are moved
    "estimate": "estimate.parquet",
    "plot": "plot.png",
    "report": "report.html",
    "summary": "summary.json",
}


def write_report(run: Run, directory: str | os.PathLike[str]) -> dict[str, str]:
    """Write estimate, picture, page and summary of a run into a folder.

    Parameters
    ----------
    run : Run
        A finished identification.
    directory : path
        Created with its parents when it is not there; older files of ours in it are replaced,
        other files are left alone.

    Returns
    -------
    dict of str to str
        Kind ("estimate", "plot", "report", "summary") to path, as the summary lists them.

    Raises
    ------
    UsageError
        The folder or a file in it cannot be written; what was there before is complete, or gone.
    """
    directory = Path(directory)
    files = {kind: str(directory / name) for kind, name in FILE_NAMES.items()}
    made: list[Path] = []
    try:
        _make_directories(directory, made)
        with tempfile.TemporaryDirectory(prefix=".similitude-", dir=directory) as building:
            _build(run, Path(building), files)
            _move(Path(building), directory)
    except OSError as fault:
        _remove_empty(made)
        raise _cannot_write(directory, fault) from fault
    except BaseException:  # a bug or Ctrl-C leaves no empty folders behind either
        _remove_empty(made)
        raise
    return files


def _build(run: Run, building: Path, files: dict[str, str]) -> None:
    with ThreadPoolExecutor(1) as beside:  # compressing the table leaves the interpreter to the picture
        table = beside.submit(write_estimate, run, building / FILE_NAMES["estimate"])
        save_plot(run, building / FILE_NAMES["plot"])
        record = summary(run, files)
        for kind, text in (("report", html_report(run, record)), ("summary", json_page(record))):
            (building / FILE_NAMES[kind]).write_text(text, encoding="utf-8", newline="\n")
        table.result()


def _move(building: Path, directory: Path) -> None:
    (directory / FILE_NAMES["summary"]).unlink(missing_ok=True)
    for name in FILE_NAMES.values():
        os.replace(building / name, directory / name)


def _make_directories(directory: Path, made: list[Path]) -> None:
    """Make a folder and its parents; note those that are new in `made`, innermost first."""
    made.extend(path for path in (directory, *directory.parents) if not path.exists())
    directory.mkdir(parents=True, exist_ok=True)


def _remove_empty(made: list[Path]) -> None:
    for path in made:
        with contextlib.suppress(OSError):  # never made, or somebody else put something there
            path.rmdir()


def _cannot_write(directory: Path, fault: OSError) -> UsageError:
    reason = fault.strerror or str(fault)
    return UsageError(
        f"the results cannot be written to '{directory}': {reason}",
        usually="the folder belongs to somebody else, is the name of a file, or the disk is full.",
        paste=f"similitude identify ... --out {Path.home() / DEFAULT_DIRECTORY}",
        read='docs/identify.md, "Files"',
    )
