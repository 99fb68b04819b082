"""The cells of a table that are words: sources, names of makes and models.

Invariant: as many words a column as the file has rows of cells; what is missing is an empty text.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path


def read_words(path: Path, headers: Sequence[str]) -> dict[str, tuple[str, ...]]:
    """Read columns as text.

    Parameters
    ----------
    path : Path         a CSV or Parquet file that `similitude.readers.open_table` opens.
    headers : columns, as written in the file.

    Returns
    -------
    dict                header -> words, one a row.
    """
    if not headers:
        return {}
    with open(path, "rb") as file:
        is_parquet = file.read(4) == b"PAR1"
    if is_parquet:
        import pyarrow.parquet

        table = pyarrow.parquet.read_table(path, columns=list(headers))
        return {h: tuple("" if w is None else str(w) for w in table.column(h).to_pylist()) for h in headers}
    from similitude.readers.csv_text import take_apart

    text = take_apart(path, path.read_bytes())
    lines = text.body.decode("utf-8", errors="replace").splitlines()
    rows = [row for row in csv.reader(lines, delimiter=text.separator, skipinitialspace=True) if row]
    places = {h: text.headers.index(h) for h in headers}
    return {h: tuple(row[i].strip() if i < len(row) else "" for row in rows) for h, i in places.items()}
