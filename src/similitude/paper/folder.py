"""The files of a reproduction in one folder: page, pictures, claims.

Invariant: nothing is written before all of it has been composed; each file appears whole.
"""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
from pathlib import Path

from similitude.errors import UsageError
from similitude.paper.companion import companion
from similitude.paper.reproduction import Reproduction

REPORT, CLAIMS = "paper.html", "claims.json"
READ = 'docs/paper.md, "The command"'


def write(done: Reproduction, directory: str | os.PathLike[str]) -> dict[str, str]:
    """Write page, claims and pictures into a folder.

    Parameters
    ----------
    directory : path   created where it is not there; older files of ours in it are replaced.

    Returns
    -------
    dict of str to str   kind or picture's name to path

    Raises
    ------
    UsageError   the folder or a file in it cannot be written
    """
    directory = Path(directory)
    contents: dict[str, bytes] = dict(done.pictures)
    contents[CLAIMS] = (json.dumps(done.records, ensure_ascii=False, indent=1) + "\n").encode()
    contents[REPORT] = companion(done).encode()
    made = [path for path in (directory, *directory.parents) if not path.exists()]
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".similitude-", dir=directory) as building:
            for name, data in contents.items():
                (Path(building) / name).write_bytes(data)
            for name in contents:
                os.replace(Path(building) / name, directory / name)
    except OSError as fault:
        for path in made:
            with contextlib.suppress(OSError):
                path.rmdir()
        raise UsageError(
            f"the report cannot be written to '{directory}': {fault.strerror or fault}",
            usually="the folder belongs to somebody else, is the name of a file, or the disk is full.",
            paste="similitude paper --out paper-out",
            read=READ,
        ) from fault
    return {name: str(directory / name) for name in contents}
