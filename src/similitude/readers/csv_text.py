"""A CSV file taken apart: encoding, header line, separator, and the bytes of the rows.

Invariant: no number is read here.
"""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass
from pathlib import Path

from similitude.errors import LogError, shown
from similitude.readers.table import READ

_SEPARATORS = ",;\t|"
NUMBER = re.compile(
    r"\s*[-+]?(?:(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?|nan|inf|infinity)\s*", re.IGNORECASE
)
LONGEST_HEADER = 1_000_000  # characters; ten thousand columns with long names
LINE_END = re.compile(rb"\r\n|\n|\r")


@dataclass(frozen=True)
class CsvText:
    """The file taken apart: header cells, separator, and the bytes of the rows."""

    path: Path
    headers: tuple[str, ...]
    separator: str
    body: bytes

    def first_cells(self) -> tuple[str, ...]:
        """Cells of the first row, without blanks around them."""
        line = LINE_END.split(self.body.lstrip(b"\r\n"), maxsplit=1)[0]
        return _cells(line.decode("utf-8", errors="replace"), self.separator)


def _utf8(raw: bytes) -> bytes:
    if raw.startswith((b"\xff\xfe", b"\xfe\xff")):
        return raw.decode("utf-16", errors="replace").encode()
    raw = raw.removeprefix(b"\xef\xbb\xbf")
    try:
        raw.decode("utf-8")
    except UnicodeDecodeError:
        return raw.decode("latin-1").encode()  # "°" of older loggers; never fails
    return raw


def take_apart(path: Path, raw: bytes) -> CsvText:
    """Find header, separator and rows in the bytes of a file; LogError when there are none."""
    raw = _utf8(raw)
    line, body = _header_line(raw)
    if len(line) > LONGEST_HEADER:
        raise LogError(
            f"the first line of {path.name} has {len(line)} characters; {LONGEST_HEADER} are the most",
            usually="the file has no line ends, or rows and columns were exchanged.",
            paste="t [s],delta [rad],r [rad/s],U [m/s]",
            read=READ,
            fault="no_header",
        )
    separator = max(_SEPARATORS, key=line.count)
    if separator not in line and len(re.findall(r"\[[^]]*\]", line)) > 1:
        raise LogError(
            f"the header of {path.name} has no comma, semicolon or tab: {shown(line)}",
            usually="columns are parted by blanks.",
            paste=re.sub(r"\]\s+", "],", line.strip())[:200],
            read=READ,
            fault="no_header",
        )
    headers = _cells(line, separator)
    if any(headers) and all(NUMBER.fullmatch(cell) for cell in headers if cell):
        raise LogError(
            f"{path.name} begins with numbers, {shown(line)}, not with a header",
            usually="the names and units of the columns are kept elsewhere.",
            paste="t [s],delta [rad],r [rad/s],U [m/s]",
            read=READ,
            fault="no_header",
        )
    first = LINE_END.split(body.lstrip(b"\r\n"), maxsplit=1)[0].strip(b" ")
    if first.endswith(separator.encode()) and first.count(separator.encode()) == len(headers):
        headers = (*headers, "")  # every row closes with a separator, the header does not
    return CsvText(path, headers, separator, body)


def _header_line(raw: bytes) -> tuple[str, bytes]:
    rest = raw
    while rest := rest.lstrip(b"\r\n"):
        line, *more = LINE_END.split(rest, maxsplit=1)
        rest = more[0] if more else b""
        text = line.decode("utf-8", errors="replace").strip(" ")
        if text.startswith("#") and text.count("]") > 1:  # a header behind a comment sign
            return text.lstrip("# "), rest
        if text.strip() and not text.startswith(("#", "sep=")):
            return text, rest
    return "", b""


def _cells(line: str, separator: str) -> tuple[str, ...]:
    try:
        cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True))
    except (csv.Error, StopIteration):
        cells = line.split(separator)
    return tuple(cell.strip() for cell in cells)
