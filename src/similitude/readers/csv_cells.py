"""What a cell means that holds no number, and the line to paste; cells of a CSV file.

Invariant: a repair is offered only where it costs few cells; a column that is text as a whole is
written anew by its owner.
"""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Collection, Sequence

from similitude.errors import LogError, shown
from similitude.readers.csv_text import NUMBER, CsvText
from similitude.readers.table import READ

FEWEST_WHOLE = 10  # cells; fewer are no column
MOST_BLANKED = 0.2  # of a column's cells; with more, a repair that leaves them empty leaves nothing
_THOUSANDS = re.compile(r"[-+]?\d{1,3}(?:([., \u00a0\u2009'])\d{3})(?:\1\d{3})*(?:[.,]\d+)?")
_WITH_UNIT = re.compile(NUMBER.pattern + r"([^\d\s.,+-]\D*)", re.IGNORECASE)


def text_in_cell(
    text: CsvText, rows: list[list[str]], positions: Sequence[int], wrong: Collection[tuple[int, int]]
) -> LogError:
    """Say what text among the numbers means.

    Parameters
    ----------
    text : CsvText                    the file
    rows : list of list of str        cells of each column asked for
    positions : sequence of int       where these columns stand
    wrong : collection of (int, int)  data row and place among the columns of each such cell

    Returns
    -------
    LogError   `header_again`, or `text_in_cell`
    """
    row, place = min(wrong)
    header, cell = text.headers[positions[place]], rows[place][row - 1]
    what = f"column {shown(header)} of {text.path.name}, data row {row}: {shown(cell)} is no number"
    if cell == header:
        return LogError(
            f"{what}: the header stands there again",
            usually="two recordings were joined end to end; this keeps the longer one.",
            paste="--fix keep_longest_part",
            read=READ,
            fault="header_again",
        )
    own = sum(one == place for _, one in wrong)
    what += f"; {len(wrong)} cells are text" if len(wrong) > 1 else ""
    usually, paste = (
        _of_a_column(text, rows[place], header, cell)
        if _THOUSANDS.fullmatch(cell) or own > max(FEWEST_WHOLE, MOST_BLANKED * len(rows[place]))
        else (
            "the logger or a spreadsheet wrote a word for a missing value; this leaves the cell empty.",
            "--fix blank_text",
        )
    )
    return LogError(what, usually=usually, paste=paste, read=READ, fault="text_in_cell")


def _of_a_column(text: CsvText, cells: list[str], header: str, cell: str) -> tuple[str, str]:
    """What a column is whose numbers are written as text, and the line that writes it anew."""
    file = shlex.quote(str(text.path))
    grouped = _THOUSANDS.fullmatch(cell)
    if grouped:
        sign = grouped.group(1)
        plain = f'c.replace("{sign}", "")' + ('.replace(",", ".")' if sign == "." else "")
        return f"thousands are parted by {shown(sign)}; this writes the numbers without.", _python(
            text, plain
        )
    unit = _WITH_UNIT.fullmatch(cell)
    if unit and sum(one.endswith(unit.group(1)) for one in cells) > 0.5 * len(cells):
        return (
            f"the unit {shown(unit.group(1))} stands in every cell; it belongs into the header.",
            f"sed {shlex.quote(f'2,$s| *{re.escape(unit.group(1))}||g')} {file} > table.csv",
        )
    return (
        "the numbers are written in another way (hexadecimal, words, a clock), or it is another signal.",
        f'--map "{_quantity_place(header)}=COLUMN"',
    )


def _quantity_place(header: str) -> str:
    return header.split("[")[0].strip() or "r"


def _python(text: CsvText, plain: str) -> str:
    """The command that writes every cell below the header as the expression ``plain`` of ``c``."""
    code = (
        f"import csv, sys; rows = csv.reader(open({json.dumps(str(text.path))}), "
        f"delimiter={json.dumps(text.separator)}); "
        "out = csv.writer(sys.stdout); out.writerow(next(rows)); "
        f"out.writerows([{plain} for c in row] for row in rows)"
    )
    return f"python3 -c {shlex.quote(code)} > table.csv"


def date_order(text: CsvText, days: Sequence[str]) -> LogError:
    """Say that dates changed on the way, in an order of day and month that nobody can tell."""
    return LogError(
        f"the time of {text.path.name} holds {len(days)} dates, {shown(days[0])} and {shown(days[-1])}, "
        "and which number is the day is not certain",
        usually="the drive went past midnight; ISO 8601 writes a date in the same way everywhere.",
        paste="2026-10-25T23:59:59.990",
        read=READ,
        fault="date_order",
    )


def two_decimal_signs(text: CsvText, rows: list[list[str]], positions: Sequence[int]) -> LogError:
    """Say that points and commas are mixed, with a place of each."""
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
        paste=f"sed 's/,/./g' {shlex.quote(str(text.path))} > points.csv",
        read=READ,
        fault="decimal_comma",
    )
