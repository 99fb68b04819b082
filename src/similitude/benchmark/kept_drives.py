"""Drives that take long to simulate are simulated once and kept in the user's cache.

Invariant: a kept drive is that of the same scenario, seed, simulator and foreign package, or it is not used.
"""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
import zipfile
from collections.abc import Callable, Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import similitude.simulation
from similitude.program.compile import cache_directories

PACKAGE = "commonroad-vehicle-models"


def kept(
    what: Mapping[str, Any], make: Callable[[], dict[str, NDArray[np.float64]]]
) -> dict[str, NDArray[np.float64]]:
    """Return arrays that were kept under a description, or make and keep them.

    Parameters
    ----------
    what : mapping    all that the arrays depend on, beside the code of the simulator
    make : function   that makes them
    """
    path = cache_directories()[-1] / "drives" / f"{_mark(what)}.npz"
    try:
        with np.load(path) as held:
            return {name: held[name] for name in held.files}
    except (OSError, ValueError, EOFError, KeyError, zipfile.BadZipFile):
        pass
    made = make()
    _write(path, made)
    return made


def foreign_version() -> str | None:
    """Return the version of the package with the foreign plants, None where it is not installed."""
    try:
        return version(PACKAGE)
    except PackageNotFoundError:
        return None


def _mark(what: Mapping[str, Any]) -> str:
    """A name that changes with the description, the simulator's source and the foreign package."""
    digest = hashlib.sha256(json.dumps(what, sort_keys=True).encode())
    folder = Path(similitude.simulation.__path__[0])
    for path in sorted(folder.glob("*.py")):
        digest.update(path.read_bytes())
    digest.update(str(foreign_version()).encode())
    return digest.hexdigest()[:24]


def _write(path: Path, made: dict[str, NDArray[np.float64]]) -> None:
    """Write under a temporary name and move into place; a cache that cannot be written is none."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=path.parent, suffix=".part")
        with os.fdopen(handle, "wb") as file:
            np.savez_compressed(file, **made)
        os.replace(name, path)
    except OSError:
        return
