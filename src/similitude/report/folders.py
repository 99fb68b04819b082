"""Where the files of each log go: one folder a log, each a different one.

Invariant: no two logs share a folder, also where a file system ignores the case of names.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

DEFAULT_DIRECTORY = "similitude-out"


def directories(logs: Sequence[str | os.PathLike[str]], out: str | None) -> list[Path]:
    """Choose the folder of each log, each a different one.

    Parameters
    ----------
    logs : sequence of paths
        In the order given on the command line.
    out : str or None
        The folder the user named. One log is written straight into it, several into
        `out`/stem; without it the folder is `similitude-out`/stem.

    Returns
    -------
    list of Path
        As long as `logs`; two logs of one stem become `stem` and `stem-2` (case is ignored, for
        file systems that ignore it).
    """
    if out is not None and len(logs) == 1:
        return [Path(out)]
    base = Path(out if out is not None else DEFAULT_DIRECTORY)
    stems = [Path(log).stem or "log" for log in logs]
    reserved = {stem.casefold() for stem in stems}
    taken: set[str] = set()
    chosen = []
    for stem in stems:
        name, count = stem, 1
        # `drive-2` is also avoided when a later log is really called that.
        while name.casefold() in taken or (count > 1 and name.casefold() in reserved):
            count += 1
            name = f"{stem}-{count}"
        taken.add(name.casefold())
        chosen.append(base / name)
    return chosen
