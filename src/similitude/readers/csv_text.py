"""A CSV file taken apart: encoding, header line, separator, and the bytes of the rows.

Invariant: no number is read here.
"""

from __future__ import annotations

import csv
import re
import shlex
from dataclasses import dataclass
from pathlib import Path

from similitude.errors import LogError, shown
from similitude.readers.table import READ

_SEPARATORS = ",;\t|"
NUMBER = re.compile(
    r"\s*[-+]?(?:(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?|nan|inf|infinity)\s*", re.IGNORECASE
)
LONGEST_HEADER = 1_000_000  # characters; ten thousand columns with long names
FEWEST_WIDE = 8  # characters; fewer do not tell an encoding
WIDE_SHARE = 0.9  # of the high bytes are zero in a text of Latin letters and digits
LINE_END = re.compile(rb"\r\n|\n|\r")


@dataclass(frozen=True)
class CsvText:
    """The file taken apart: header cells, separator, and the bytes of the rows."""

    path: Path
    headers: tuple[str, ...]
    separator: str
    body: bytes
    whole: bytes = b""

    def first_cells(self) -> tuple[str, ...]:
        """Cells of the first row, without blanks around them."""
        line = LINE_END.split(self.body.lstrip(b"\r\n"), maxsplit=1)[0]
        return _cells(line.decode("utf-8", errors="replace"), self.separator)


@dataclass(frozen=True)
class Line:
    """A line of the file, counted from 1, taken apart at the separator it has most of."""

    number: int
    cells: list[str]
    separator: str


def lines_of(text: CsvText, most: int) -> list[Line]:
    """The first lines that are neither empty nor comments."""
    lines = []
    for number, line in enumerate(LINE_END.split(text.whole[:LONGEST_HEADER])[:most], start=1):
        plain = line.decode("utf-8", errors="replace").strip(" ")
        if not plain.strip() or plain.startswith(("#", "sep=")):
            continue
        # A comma may be a decimal one; the others stand in no number.
        separator = max(_SEPARATORS[1:], key=plain.count)
        separator = separator if separator in plain else ","
        lines.append(Line(number, list(_cells(plain, separator)), separator))
    return lines


def wide_text(start: bytes) -> str | None:
    """The name of the two-byte encoding in which a text begins, or None: by its mark, or its zeros."""
    if start.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    even, odd = start[: 2 * (len(start) // 2) : 2], start[1::2]
    if len(odd) < FEWEST_WIDE:
        return None
    for name, zeros, letters in (("utf-16-le", odd, even), ("utf-16-be", even, odd)):
        if zeros.count(0) > WIDE_SHARE * len(zeros) and letters.count(0) == 0:
            return name
    return None


def _utf8(raw: bytes) -> bytes:
    wide = wide_text(raw[:4096])
    if wide is not None:
        return raw.decode(wide, errors="replace").encode()
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
    first = LINE_END.split(body.lstrip(b"\r\n"), maxsplit=1)[0].strip(b" ")
    if separator not in line:
        _refuse_other_separator(path, line, first.decode("utf-8", errors="replace"))
    headers = _cells(line, separator)
    if any(headers) and all(NUMBER.fullmatch(cell) for cell in headers if cell):
        raise LogError(
            f"{path.name} begins with numbers, {shown(line)}, not with a header",
            usually="the names and units of the columns are kept elsewhere.",
            paste="t [s],delta [rad],r [rad/s],U [m/s]",
            read=READ,
            fault="no_header",
        )
    if first.endswith(separator.encode()) and first.count(separator.encode()) == len(headers):
        headers = (*headers, "")  # every row closes with a separator, the header does not
    return CsvText(path, headers, separator, body, raw)


def _refuse_other_separator(path: Path, line: str, first: str) -> None:
    """Refuse a table whose columns are parted by blanks or another sign, with the command that changes it."""
    if len(re.findall(r"\[[^]]*\]", line)) > 1:
        sign = (re.findall(r"\]\s*([^\s\w\[\]])", line) or [" "])[0]
    elif len(first.split()) > 1 and all(NUMBER.fullmatch(cell) for cell in first.split()):
        sign = " "
    else:
        return
    change = r"s/^ +//; s/\] +/],/g; 2,$s/[[:space:]]+/,/g" if sign == " " else f"s/[{sign}]/,/g"
    if sign == " " and "]" not in line:
        change = "s/^ +//; s/[[:space:]]+/,/g"
    raise LogError(
        f"the header of {path.name} has no comma, semicolon or tab: {shown(line)}",
        usually=f"columns are parted by {'blanks' if sign == ' ' else shown(sign)}; this writes commas.",
        paste=f"sed -E {shlex.quote(change)} {shlex.quote(str(path))} > table.csv",
        read=READ,
        fault="no_header",
    )


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
