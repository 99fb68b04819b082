"""CSV logs: comma, semicolon, tab or bar; decimal point or comma; UTF-8, UTF-16 or Latin-1.

Invariant: every row of the file becomes one row of the table, with two exceptions that are said
in a warning: blank lines, and a last row that was cut off while it was written.

A data row is counted from 1 for the first row below the header, in every message.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from similitude.errors import LogError, shown
from similitude.readers.csv_text import NUMBER, CsvText, take_apart
from similitude.readers.table import READ, Loaded, Table

_NULLS = frozenset(" nan NaN NAN NA N/A n/a #N/A null NULL None none - -- ?".split(" "))


def open_csv(path: Path, *, warnings: tuple[str, ...] = ()) -> Table:
    """Open a CSV file.

    Parameters
    ----------
    path : Path              a text file with one header line
    warnings : tuple of str  what is already known about the file

    Returns
    -------
    Table

    Raises
    ------
    LogError   no header, no rows, rows of another width than the header, text in a cell
    """
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise LogError(
            f"log {shown(path, longest=200)} cannot be read: {error.strerror or error}",
            usually="the disk or the network went away.",
            paste=f"similitude identify {path.name}",
            read=READ,
        ) from None
    text = take_apart(path, raw)
    return Table(text.headers, lambda positions: _load(text, positions), warnings)


def _load(text: CsvText, positions: Sequence[int]) -> Loaded:
    if not text.body.strip():
        raise LogError(
            f"{text.path.name} has a header but no rows",
            usually="the recording was stopped before it began.",
            paste="0.00,0.0012,0.031,21.4",
            read=READ,
        )
    for decimal_sign in (".",) if text.separator == "," else (".", ","):
        try:
            return _load_fast(text, positions, decimal_sign)
        except _Unreadable:
            pass
    return _load_cell_by_cell(text, positions)


class _Unreadable(Exception):
    """Some cell is not a number with this decimal sign."""


def _load_fast(text: CsvText, positions: Sequence[int], decimal_sign: str) -> Loaded:
    import numpy as np
    import pyarrow as pa

    names = [str(position) for position in positions]
    table, odd_rows = _parse(text, names, pa.float64(), decimal_sign)
    warnings = _judge_rows(text, table.num_rows, odd_rows)
    columns = tuple(np.ascontiguousarray(table.column(name).to_numpy(), dtype=np.float64) for name in names)
    return Loaded(columns, warnings)


def _parse(text: CsvText, names: list[str], kind, decimal_sign: str):
    import pyarrow as pa
    import pyarrow.csv as arrow_csv

    odd_rows = []

    def note(row) -> str:
        odd_rows.append((row.number, row.actual_columns))
        return "skip"

    try:
        table = arrow_csv.read_csv(
            pa.BufferReader(text.body),
            read_options=arrow_csv.ReadOptions(
                # Threads would lose the numbers of odd rows; one block keeps long rows whole.
                use_threads=False,
                block_size=min(len(text.body) + 64, 2**30),
                column_names=[str(position) for position in range(len(text.headers))],
            ),
            parse_options=arrow_csv.ParseOptions(delimiter=text.separator, invalid_row_handler=note),
            convert_options=arrow_csv.ConvertOptions(
                include_columns=names,
                column_types=dict.fromkeys(names, kind),
                null_values=(*_NULLS, *(f" {word}" for word in _NULLS)),
                decimal_point=decimal_sign,
                check_utf8=False,
            ),
        )
    except (pa.ArrowException, ValueError) as error:
        raise _Unreadable(str(error)) from None
    return table, odd_rows


def _judge_rows(text: CsvText, rows: int, odd_rows: list) -> tuple[str, ...]:
    if not odd_rows:
        return ()
    number, width = odd_rows[0]
    wanted = len(text.headers)
    if len(odd_rows) == 1 and number == rows + 1 and width < wanted:
        return (f"the last row has {width} of {wanted} cells and was dropped: the file is cut off",)
    decimal_comma = text.separator == "," and len(odd_rows) > rows and width >= 2 * wanted - 1
    raise LogError(
        f"data row {number} of {text.path.name} has {width} cells, the header {wanted}"
        + (f"; {len(odd_rows)} rows are so" if len(odd_rows) > 1 else ""),
        usually="numbers are written with a decimal comma, which also parts the columns."
        if decimal_comma
        else "the file was damaged, or two recordings were joined.",
        paste=";".join(text.headers) if decimal_comma else text.separator.join(text.headers),
        read=READ,
    )


def _load_cell_by_cell(text: CsvText, positions: Sequence[int]) -> Loaded:
    """Read what the fast way does not: padded words for "missing", a number cut off at the end."""
    import numpy as np
    import pyarrow as pa

    names = [str(position) for position in positions]
    try:
        table, odd_rows = _parse(text, names, pa.binary(), ".")
    except _Unreadable as error:
        raise LogError(
            f"{text.path.name} cannot be taken apart into rows: {error}"[:300],
            usually="a quotation mark is not closed, or the file was damaged.",
            paste=text.separator.join(text.headers),
            read=READ,
        ) from None
    warnings = _judge_rows(text, table.num_rows, odd_rows)
    rows = [
        [(cell or b"").decode("utf-8", "replace").strip() for cell in table.column(name).to_pylist()]
        for name in names
    ]
    wrong = _first_wrong(rows)
    if wrong is not None and wrong[0] == table.num_rows > 1 and text.body[-1:] not in b"\r\n":
        rows = [cells[:-1] for cells in rows]
        warnings += ("the last row was cut off in the middle of a number and was dropped",)
        wrong = None
    if wrong is not None:
        raise _text_in_cell(text, rows, positions, *wrong)
    signs = {sign for cells in rows for cell in cells for sign in ".," if sign in cell}
    if len(signs) > 1:
        raise _two_decimal_signs(text, rows, positions)
    columns = [
        np.array([np.nan if cell in _NULLS else float(cell.replace(",", ".")) for cell in cells])
        for cells in rows
    ]
    return Loaded(tuple(columns), warnings)


def _first_wrong(rows: list[list[str]]) -> tuple[int, int] | None:
    """Return the first cell that is no number, as (data row, place among the columns)."""
    found = [
        (row, place)
        for place, cells in enumerate(rows)
        for row, cell in enumerate(cells, start=1)
        if cell not in _NULLS and not NUMBER.fullmatch(cell)
    ]
    return min(found, default=None)


def _text_in_cell(
    text: CsvText, rows: list[list[str]], positions: Sequence[int], row: int, place: int
) -> LogError:
    header, cell = text.headers[positions[place]], rows[place][row - 1]
    second_header = row == 1 and not any(NUMBER.fullmatch(cells[0]) for cells in rows)
    return LogError(
        f"column {shown(header)} of {text.path.name}, data row {row}: {shown(cell)} is no number",
        usually="the units stand in a second header line; write them in the first, in brackets."
        if second_header
        else "the logger wrote a word for a missing value; leave the cell empty.",
        paste=f"{header} [{cell}]" if second_header else "nan",
        read=READ,
    )


def _two_decimal_signs(text: CsvText, rows: list[list[str]], positions: Sequence[int]) -> LogError:
    first = {
        sign: min(
            (row, text.headers[position], cell)
            for position, cells in zip(positions, rows, strict=True)
            for row, cell in enumerate(cells, start=1)
            if sign in cell
        )
        for sign in ".,"
    }
    places = [f"{shown(cell)} in column {shown(name)}, data row {row}"
              for row, name, cell in first.values()]  # fmt: skip
    return LogError(
        f"{text.path.name} mixes decimal points and decimal commas: {' and '.join(places)}",
        usually="two recordings were joined, or thousands are parted by a sign.",
        paste=f"sed 's/,/./g' {text.path.name} > points.csv",
        read=READ,
    )
