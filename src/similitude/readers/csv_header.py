"""Is the first line the header? Lines before it, and units in a line of their own.

Invariant: nothing is skipped or joined silently; the line to paste writes the table that is meant.
"""

from __future__ import annotations

import shlex

from similitude.errors import LogError, shown
from similitude.readers.clock_text import looks_like_clock
from similitude.readers.csv_text import LINE_END, NUMBER, CsvText, Line, lines_of
from similitude.readers.table import READ

MOSTLY = 0.5  # of the cells of a row are numbers, or more; a column of notes may stand among them
FARTHEST = 200  # lines; preambles are shorter


def meant_header(text: CsvText) -> tuple[LogError | None, CsvText]:
    """The table that is meant where it begins further down, or its units stand in a second line.

    Returns
    -------
    LogError or None   `late_header` or `second_header`, with the command that writes a table with one header
    CsvText            what that command writes; the text itself where nothing is wrong
    """
    if _is_numbers(list(text.first_cells())):
        return None, text
    lines = lines_of(text, FARTHEST)
    cells = [one.cells for one in lines]
    at = next((k for k in range(1, len(lines)) if all(_is_numbers(one) for one in cells[k : k + 2])
               and len({len(one) for one in cells[k : k + 2]}) == 1), None)  # fmt: skip
    if at is None or not _is_words(cells[at - 1], len(cells[at])):
        return None, text
    two = at >= 2 and _is_words(cells[at - 2], len(cells[at])) and all(cells[at - 2])
    if two:
        headers = _joined(lines[at - 2], lines[at - 1])
        return _second_header(text, headers, lines[at - 1]), _below(text, lines[at - 1], headers)
    if at > 1:
        return _late_header(text, lines[at - 1]), _below(text, lines[at - 1], lines[at - 1].cells)
    return None, text


def _below(text: CsvText, line: Line, headers: list[str]) -> CsvText:
    """The table whose rows stand below a line."""
    rest = LINE_END.split(text.whole, maxsplit=line.number)
    body = rest[-1] if len(rest) > line.number else b""
    return CsvText(text.path, tuple(headers), line.separator, body, text.whole)


def _is_numbers(cells: list[str]) -> bool:
    full = [cell for cell in cells if cell]
    numbers = sum(bool(NUMBER.fullmatch(cell)) or looks_like_clock(cell) for cell in full)
    return len(cells) >= 2 and numbers > MOSTLY * len(full)


def _is_words(cells: list[str], width: int) -> bool:
    return len(cells) == width and any(cells) and not any(NUMBER.fullmatch(cell) for cell in cells if cell)


def _late_header(text: CsvText, header: Line) -> LogError:
    line = shown(header.separator.join(header.cells))
    return LogError(
        f"the header of {text.path.name} stands in line {header.number}: {line}",
        usually="the logger wrote facts about the recording above it; this leaves them out.",
        paste=f"tail -n +{header.number} {shlex.quote(str(text.path))} > table.csv",
        read=READ,
        fault="late_header",
    )


def _joined(names: Line, units: Line) -> list[str]:
    return [
        name if "]" in name or not unit else f"{name} [{unit.strip('[]()').strip()}]"
        for name, unit in zip(names.cells, units.cells, strict=True)
    ]


def _second_header(text: CsvText, headers: list[str], units: Line) -> LogError:
    joined = units.separator.join(headers)
    file = shlex.quote(str(text.path))
    line = shown(units.separator.join(units.cells))
    return LogError(
        f"line {units.number} of {text.path.name} is a second header: {line}",
        usually="the units stand in a line of their own; this writes them into the first, in brackets.",
        paste=f"(echo {shlex.quote(joined)}; tail -n +{units.number + 1} {file}) > table.csv",
        read=READ,
        fault="second_header",
    )
