"""Parquet logs: column names carry the unit, ``r [deg/s]``, exactly as in CSV.

Invariant: whatever pyarrow finds wrong with the bytes ends in a `LogError`.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

from similitude.errors import LogError, shown
from similitude.finding import Finding
from similitude.readers.table import READ, Loaded, Table

MOST_CELLS = 400_000_000  # 3 GB as float64: 28 h of four columns at 1 kHz


def open_parquet(path: Path, *, findings: tuple[Finding, ...] = ()) -> Table:
    """Open a Parquet file.

    Parameters
    ----------
    path : Path                   a file that begins as Parquet
    findings : tuple of Finding   what is already known about the file

    Returns
    -------
    Table

    Raises
    ------
    LogError   the file is cut off, damaged, or claims more cells than memory should hold
    """
    import pyarrow.parquet

    if path.read_bytes()[-4:] != b"PAR1":
        raise LogError(
            f"{path.name} is cut off: a Parquet file ends with its index, and this one does not",
            usually="the recording or the copy was interrupted; without the index nothing can be read.",
            paste=f"cp --force SOURCE/{path.name} .",
            read=READ,
            fault="cut_off",
        )
    try:
        file = pyarrow.parquet.ParquetFile(path)
        headers = tuple(str(name) for name in file.schema_arrow.names)
    except Exception as error:  # damaged bytes raise a dozen kinds of exception in pyarrow
        raise _damaged(path, error) from None
    rows, columns = file.metadata.num_rows, file.metadata.num_columns
    if rows * columns > MOST_CELLS:
        raise LogError(
            f"{path.name} holds {rows} rows of {columns} columns; {MOST_CELLS} cells are the most",
            usually="a whole fleet or month lies in one file; a log is one drive.",
            paste='table[["t [s]", "delta [rad]", "r [rad/s]", "U [m/s]"]].iloc[:3600000]',
            read=READ,
            fault="too_large",
        )

    def load(positions: Sequence[int], *, blanked: Collection[str] = ()) -> Loaded:
        return _load(path, file, positions, "text_in_cell" in blanked)

    def is_clock(position: int) -> bool:
        return _is_date(file.schema_arrow.types[position])

    return Table(headers, load, is_clock, findings)


def _load(path: Path, file, positions: Sequence[int], text_blanked: bool) -> Loaded:
    import numpy as np

    schema = file.schema_arrow
    if not text_blanked:
        for position in positions:
            _refuse_type(path, schema.names[position], schema.types[position])
    try:
        # By position, because two columns may share a name.
        table = file.read()
        chosen = [_numbers(table.column(position)) for position in positions]
        columns = tuple(np.ascontiguousarray(column, dtype=np.float64) for column in chosen)
    except Exception as error:  # as above: bytes may be damaged anywhere
        raise _damaged(path, error) from None
    return Loaded(columns)


def _numbers(column):
    import numpy as np
    import pyarrow as pa

    if _is_date(column.type):
        # Whole nanoseconds first: a float holds 1e-7 s at the seconds of our time, not better.
        whole = column.cast(pa.timestamp("ns"), safe=False).cast(pa.int64())
        return whole.cast(pa.float64(), safe=False).to_numpy() * 1e-9
    if _is_number(column.type):
        return column.cast(pa.float64(), safe=False).to_numpy()
    return np.full(len(column), np.nan)


def _is_number(kind) -> bool:
    import pyarrow.types as types

    return types.is_floating(kind) or types.is_integer(kind) or types.is_decimal(kind) or types.is_null(kind)


def _is_date(kind) -> bool:
    import pyarrow.types as types

    return types.is_timestamp(kind)


def _refuse_type(path: Path, name: str, kind) -> None:
    import pyarrow.types as types

    if _is_number(kind) or _is_date(kind):
        return
    clock = types.is_temporal(kind)
    raise LogError(
        f"column {shown(name)} of {path.name} holds {kind}, not numbers",
        usually="a clock time without a date was stored; seconds as plain numbers are needed."
        if clock
        else "the column was stored as text.",
        paste='table["t [s]"] = (table["time"] - table["time"].iloc[0]).dt.total_seconds()'
        if clock
        else f'table["{name}"] = table["{name}"].astype(float)',
        read=READ,
        fault="text_in_cell",
    )


def _damaged(path: Path, error: Exception) -> LogError:
    reason = " ".join(str(error).split())[:160] or type(error).__name__
    return LogError(
        f"{path.name} is a damaged Parquet file: {reason}",
        usually="the recording or the copy was interrupted.",
        paste=f"cp --force SOURCE/{path.name} .",
        read=READ,
        fault="damaged_file",
    )
