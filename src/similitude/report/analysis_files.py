"""The files of an analysis in one folder: the page and the record, each complete or not there.

Invariant: a file is written under another name beside its place and moved there.
"""

from __future__ import annotations

import contextlib
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from similitude.errors import UsageError
from similitude.report.analysis_html import analysis_html
from similitude.report.analysis_json import analysis_line

if TYPE_CHECKING:
    from similitude.analysis.analysis import Analysis

FILE_NAMES = {"html": "analysis.html", "json": "analysis.json"}


def write_analysis(found: Analysis, directory: str | os.PathLike[str]) -> dict[str, str]:
    """Write the page and the record of an analysis.

    Parameters
    ----------
    found : Analysis
    directory : created with its parents where it is not there; other files in it are left alone.

    Returns
    -------
    dict of str to str    "html" and "json" to their paths.

    Raises
    ------
    UsageError    the folder or a file in it cannot be written.
    """
    folder = Path(directory)
    texts = {"html": analysis_html(found), "json": analysis_line(found) + "\n"}
    made = [path for path in (folder, *folder.parents) if not path.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".similitude-", dir=folder) as building:
            for kind, text in texts.items():
                (Path(building) / FILE_NAMES[kind]).write_text(text, encoding="utf-8", newline="\n")
            for name in FILE_NAMES.values():
                os.replace(Path(building) / name, folder / name)
    except OSError as fault:
        for path in made:
            with contextlib.suppress(OSError):  # never made, or not empty
                path.rmdir()
        raise UsageError(
            f"--out '{directory}' cannot be written: {fault.strerror or fault}",
            usually="the folder belongs to somebody else, or is the name of a file.",
            paste="--out similitude-out",
            read='docs/analyze.md, "The command"',
        ) from fault
    return {kind: str(folder / name) for kind, name in FILE_NAMES.items()}
