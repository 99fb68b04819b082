"""CSV logs: comma, semicolon, tab or bar; decimal point or comma; UTF-8, UTF-16 or Latin-1.

Invariant: every row of the file becomes one row of the table, with two exceptions that are said
in a warning: blank lines, and a last row that was cut off while it was written.

A data row is counted from 1 for the first row below the header, in every message.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from pathlib import Path

from similitude.errors import LogError, shown
from similitude.finding import Finding, refusal
from similitude.readers.clock_text import clock_seconds, days_of, looks_like_clock
from similitude.readers.csv_cells import date_order, text_in_cell, two_decimal_signs
from similitude.readers.csv_header import meant_header
from similitude.readers.csv_text import NUMBER, CsvText, take_apart
from similitude.readers.table import READ, Loaded, Table, noted

_NULLS = frozenset(" nan NaN NAN NA N/A n/a #N/A null NULL None none - -- ?".split(" "))


def open_csv(path: Path, *, findings: tuple[Finding, ...] = (), as_meant: bool = False) -> Table:
    """Open a CSV file.

    Parameters
    ----------
    path : Path                   a text file with one header line
    findings : tuple of Finding   what is already known about the file
    as_meant : bool               open a table below facts or a second header, too, and say so among its
                                  findings as one that is certain

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
            fault="cannot_open",
        ) from None
    text = take_apart(path, raw)
    fault, text = meant_header(text)
    if fault is not None:
        if not as_meant:
            raise fault
        findings = (*findings, refusal(fault))
    first = text.first_cells()

    def is_clock(position: int) -> bool:
        return position < len(first) and looks_like_clock(first[position])

    def load(positions: Sequence[int], *, blanked: Collection[str] = ()) -> Loaded:
        return _load(text, positions, [is_clock(one) for one in positions], blanked)

    return Table(text.headers, load, is_clock, findings)


def _load(text: CsvText, positions: Sequence[int], clocks: list[bool], blanked: Collection[str]) -> Loaded:
    if not text.body.strip():
        raise LogError(
            f"{text.path.name} has a header but no rows",
            usually="the recording was stopped before it began.",
            paste="0.00,0.0012,0.031,21.4",
            read=READ,
            fault="empty_file",
        )
    for decimal_sign in (".",) if text.separator == "," else (".", ","):
        if any(clocks):
            break
        try:
            return _load_fast(text, positions, decimal_sign)
        except _Unreadable:
            pass
    return _load_cell_by_cell(text, positions, clocks, blanked)


class _Unreadable(Exception):
    """Some cell is not a number with this decimal sign."""


def _load_fast(text: CsvText, positions: Sequence[int], decimal_sign: str) -> Loaded:
    import numpy as np
    import pyarrow as pa

    names = [str(position) for position in positions]
    table, odd_rows = _parse(text, names, pa.float64(), decimal_sign)
    findings = _judge_rows(text, table.num_rows, odd_rows)
    columns = tuple(np.ascontiguousarray(table.column(name).to_numpy(), dtype=np.float64) for name in names)
    return Loaded(columns, findings)


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


def _judge_rows(text: CsvText, rows: int, odd_rows: list) -> tuple[Finding, ...]:
    if not odd_rows:
        return ()
    number, width = odd_rows[0]
    wanted = len(text.headers)
    if len(odd_rows) == 1 and number == rows + 1 and width < wanted:
        return (_cut_off(f"the last row has {width} of {wanted} cells and was dropped"),)
    decimal_comma = text.separator == "," and len(odd_rows) > rows and width >= 2 * wanted - 1
    raise LogError(
        f"data row {number} of {text.path.name} has {width} cells, the header {wanted}"
        + (f"; {len(odd_rows)} rows are so" if len(odd_rows) > 1 else ""),
        usually="numbers are written with a decimal comma, which also parts the columns."
        if decimal_comma
        else "the file was damaged, or two recordings were joined.",
        paste=";".join(text.headers) if decimal_comma else text.separator.join(text.headers),
        read=READ,
        fault="decimal_comma" if decimal_comma else "odd_row",
    )


def _cut_off(what: str) -> Finding:
    return noted("cut_off", what, "the file is cut off: the recording was interrupted.", "tail -n 2 LOG.csv")


def _left_out(count: int) -> Finding:
    said = noted(
        "text_left_out",
        f"{count} cells that hold text were left empty",
        "the logger wrote words for missing values.",
        "--fix blank_text",
    )
    return replace(said, value=float(count))


def _load_cell_by_cell(
    text: CsvText, positions: Sequence[int], clocks: list[bool], blanked: Collection[str]
) -> Loaded:
    """Read what the fast way does not: dates, padded words for "missing", a number cut off at the end."""
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
            fault="odd_row",
        ) from None
    findings = _judge_rows(text, table.num_rows, odd_rows)
    rows = [
        [_plain((cell or b"").decode("utf-8", "replace")) for cell in table.column(name).to_pylist()]
        for name in names
    ]
    wrong = _wrong_cells(rows, clocks)
    if wrong and min(wrong)[0] == table.num_rows > 1 and text.body[-1:] not in b"\r\n":
        rows, wrong = [cells[:-1] for cells in rows], set()
        findings += (_cut_off("the last row was cut off in the middle of a number and was dropped"),)
    again = {(row, place) for row, place in wrong if rows[place][row - 1] == text.headers[positions[place]]}
    texts = wrong - again
    refused = (set() if "header_again" in blanked else again) | (
        set() if "text_in_cell" in blanked else texts
    )
    if refused:
        raise text_in_cell(text, rows, positions, refused)
    if texts:
        findings += (_left_out(len(texts)),)
    for row, place in wrong:
        rows[place][row - 1] = ""
    for cells, clock in zip(rows, clocks, strict=True):
        if clock and len(days_of(cells)) > 1:
            raise date_order(text, days_of(cells))
    plain = [cells for cells, clock in zip(rows, clocks, strict=True) if not clock]
    if len({sign for cells in plain for cell in cells for sign in ".," if sign in cell}) > 1:
        raise two_decimal_signs(text, rows, positions)
    columns = [
        clock_seconds(cells)
        if clock
        else np.array([np.nan if cell in _NULLS else float(cell.replace(",", ".")) for cell in cells])
        for cells, clock in zip(rows, clocks, strict=True)
    ]
    return Loaded(tuple(columns), findings)


def _plain(cell: str) -> str:
    """The cell without blanks around it, and with the minus sign of typesetters as a plain one."""
    return cell.strip().replace("\N{MINUS SIGN}", "-")


def _wrong_cells(rows: list[list[str]], clocks: list[bool]) -> set[tuple[int, int]]:
    """Return the cells that are no number and no date, as (data row, place among the columns)."""
    return {
        (row, place)
        for place, (cells, clock) in enumerate(zip(rows, clocks, strict=True))
        for row, cell in enumerate(cells, start=1)
        if cell not in _NULLS and not (looks_like_clock(cell) if clock else NUMBER.fullmatch(cell))
    }
