"""Readers of logs: one file a format, chosen by what the file contains, not by its name.

Invariant: whatever the bytes, opening and loading end in a `Table` or a `LogError`.
"""

from __future__ import annotations

from pathlib import Path

from similitude.errors import LogError, shown
from similitude.finding import Finding
from similitude.readers.csv_text import wide_text
from similitude.readers.table import READ, Loaded, Table, noted

__all__ = ["Loaded", "Table", "open_table"]

_PARQUET_NAMES = {".parquet", ".pq"}

# What people hand over instead of a log, by its first bytes: (bytes, what it is, a way out).
_FOREIGN = (
    (b"PK\x03\x04", "a ZIP archive or Excel workbook", "unzip LOG, or save the sheet as CSV"),
    (b"\x1f\x8b", "compressed with gzip", "gunzip LOG"),
    (b"BZh", "compressed with bzip2", "bunzip2 LOG"),
    (b"(\xb5/\xfd", "compressed with zstd", "unzstd LOG"),
    (b"\xfd7zXZ", "compressed with xz", "unxz LOG"),
    (b"\x89HDF", "an HDF5 or MATLAB 7.3 file", "export its signals as CSV"),
    (b"MATLAB", "a MATLAB file", "export its signals as CSV"),
    (b"MDF ", "an MDF measurement", "export its signals as CSV"),
    (b"UnFinMF ", "an unfinished MDF measurement", "export its signals as CSV"),
    (b"TDSm", "a TDMS measurement", "export its signals as CSV"),
    (b"\x89MCAP", "an MCAP recording", "export its signals as CSV"),
    (b"#ROSBAG", "a ROS bag", "export its signals as CSV"),
    (b"SQLite format", "an SQLite database or ROS 2 bag", "export its signals as CSV"),
    (b"%PDF", "a PDF document", "export its signals as CSV"),
    (b"\x89PNG", "a picture", "export its signals as CSV"),
    (b"\xff\xd8\xff", "a picture", "export its signals as CSV"),
    (b"\x7fELF", "a program", "export its signals as CSV"),
)


def open_table(path: str | Path, *, as_meant: bool = False) -> Table:
    """Open a CSV or Parquet file.

    Parameters
    ----------
    path : str or Path   the file; its content decides the reader, so a wrong extension is
                         only warned about
    as_meant : bool      open a CSV below facts or a second header, too; its findings then hold
                         the fault as a certain one

    Returns
    -------
    Table

    Raises
    ------
    LogError
        The file cannot be opened, is empty, is cut off, or is no log at all.
    """
    path = Path(path)
    start = _first_bytes(path)
    named_parquet = path.suffix.lower() in _PARQUET_NAMES
    if start.startswith(b"PAR1"):
        from similitude.readers.parquet import open_parquet

        return open_parquet(path, findings=() if named_parquet else _named_otherwise(path, "text", "Parquet"))
    _refuse_foreign(path, start, named_parquet)
    from similitude.readers.csv import open_csv

    said = _named_otherwise(path, "Parquet", "text") if named_parquet else ()
    return open_csv(path, findings=said, as_meant=as_meant)


def _named_otherwise(path: Path, named: str, being: str) -> tuple[Finding, ...]:
    suffix = ".parquet" if being == "Parquet" else ".csv"
    said = noted(
        "other_name",
        f"{path.name} is named like {named}, but is {being}",
        "it was renamed by hand.",
        f"mv {path.name} {path.stem}{suffix}",
    )
    return (said,)


def _first_bytes(path: Path) -> bytes:
    if path.exists() and not path.is_file() and not path.is_dir():
        raise LogError(
            f"log {shown(path, longest=200)} cannot be opened: it is a pipe or a device, not a file",
            usually="a stream was handed over; a log is read more than once, so it must lie in a file.",
            paste=f"cat {path.name} > drive.csv",
            read=READ,
            fault="cannot_open",
        )
    try:
        with open(path, "rb") as file:
            return file.read(4096)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise LogError(
            f"log {shown(path, longest=200)} cannot be opened: {reason}",
            usually="the path is relative to another folder, or names a folder.",
            paste="similitude identify drive.csv",
            read=READ,
            fault="cannot_open",
        ) from None


def _refuse_foreign(path: Path, start: bytes, named_parquet: bool) -> None:
    if not start.strip(b"\x00 \t\r\n\xef\xbb\xbf"):
        raise LogError(
            f"{path.name} is empty",
            usually="the recording was stopped before it began, or the disk was full.",
            paste="t [s],delta [rad],r [rad/s],U [m/s]",
            read=READ,
            fault="empty_file",
        )
    for magic, kind, way_out in _FOREIGN:
        if start.startswith(magic):
            raise LogError(
                f"{path.name} is {kind}, not a CSV or Parquet log",
                usually="the log was packed or left in the format of the recorder.",
                paste=way_out.replace("LOG", path.name),
                read=READ,
                fault="foreign_format",
            )
    if b"\x00" in start and wide_text(start) is None:  # UTF-16 text holds zero bytes
        what = "is damaged at its start" if named_parquet else "is no text: it holds zero bytes"
        raise LogError(
            f"{path.name} {what}, so it is neither a CSV nor a Parquet log",
            usually="it is another kind of file, or its beginning was lost.",
            paste="t [s],delta [rad],r [rad/s],U [m/s]",
            read=READ,
            fault="foreign_format",
        )
