"""A drive as files: the log, the truth beside it, and the vehicle file; all of them, or none.

Invariant: everything is written under temporary names beside its place and moved when complete.
"""

from __future__ import annotations

import math
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.errors import UsageError
from similitude.simulation.recording import Recording

SUFFIXES = (".csv", ".parquet")
_DIGITS = 9  # significant digits of a CSV cell: steps of a sensor survive


def file_names(out: str | Path, truth: str | Path | None = None) -> dict[str, Path]:
    """Return where log, truth and vehicle file of a drive go.

    Parameters
    ----------
    out : path     the log, ``drive.csv`` or ``drive.parquet``
    truth : path   of the truth; beside the log as ``drive_truth`` when left out

    Raises
    ------
    UsageError     a name ends otherwise, or two files would be one
    """
    log = Path(out)
    names = {
        "log": log,
        "truth": log.with_name(f"{log.stem}_truth{log.suffix}") if truth is None else Path(truth),
        "vehicle": log.with_suffix(".toml"),
    }
    for option, path in (("--out", names["log"]), ("--truth", names["truth"])):
        if path.suffix.lower() not in SUFFIXES:
            raise UsageError(
                f"{option} '{path}' ends neither in .csv nor in .parquet",
                usually="the end of the name was forgotten; it says which format is meant.",
                paste=f"{option} {path.with_suffix('.csv')}",
                read='docs/simulate.md, "What is written"',
            )
    if names["log"] == names["truth"]:
        raise UsageError(
            f"--truth '{names['truth']}' is the log itself",
            usually="the same name was given twice.",
            paste=f"--truth {log.with_name(f'{log.stem}_truth{log.suffix}')}",
            read='docs/simulate.md, "What is written"',
        )
    return names


def write_recording(
    recording: Recording, out: str | Path, *, truth: str | Path | None = None
) -> dict[str, str]:
    """Write a drive.

    Parameters
    ----------
    recording : Recording
    out, truth : path     as for `file_names`

    Returns
    -------
    dict of str to str    "log", "truth" and "vehicle" to paths

    Raises
    ------
    UsageError   a name ends otherwise, or a file cannot be written
    """
    names = file_names(out, truth)
    parts: dict[Path, str] = {}
    try:
        for kind, path in names.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            handle, part = tempfile.mkstemp(prefix=".similitude-", dir=path.parent)
            parts[path] = part
            os.close(handle)
            if kind == "vehicle":
                Path(part).write_text(recording.vehicle_file, encoding="utf-8", newline="\n")
            else:
                write_table(getattr(recording, kind), part, suffix=path.suffix.lower())
        for path, part in parts.items():
            os.chmod(part, 0o644)
            os.replace(part, path)
    except OSError as fault:
        for part in parts.values():
            Path(part).unlink(missing_ok=True)
        raise UsageError(
            f"the drive cannot be written to '{out}': {fault.strerror or fault}",
            usually="the folder belongs to somebody else, or the disk is full.",
            paste="--out drive.csv",
            read='docs/simulate.md, "What is written"',
        ) from fault
    return {kind: str(path) for kind, path in names.items()}


def write_table(columns: Mapping[str, NDArray[np.float64]], path: str | Path, *, suffix: str) -> None:
    """Write columns as CSV or Parquet; NaN becomes an empty cell.

    Parameters
    ----------
    columns : mapping of header to (n,)
    path : path
    suffix : str   ".csv" or ".parquet"
    """
    if suffix == ".parquet":
        import pyarrow
        import pyarrow.parquet

        arrays = {name: pyarrow.array(x, from_pandas=True) for name, x in columns.items()}
        pyarrow.parquet.write_table(pyarrow.table(arrays), path, compression="snappy")
        return
    rows = zip(*(_cells(x) for x in columns.values()), strict=True)
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(",".join(columns) + "\n")
        file.writelines(",".join(row) + "\n" for row in rows)


def _cells(values: NDArray[np.float64]) -> list[str]:
    return ["" if math.isnan(x) else f"{x:.{_DIGITS}g}" for x in values.tolist()]
