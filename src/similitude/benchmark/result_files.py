"""The result of a run as files: benchmark.json with every number, benchmark.html for people."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from similitude.benchmark.page import page_of
from similitude.benchmark.running import Result
from similitude.errors import UsageError

JSON, PAGE = "benchmark.json", "benchmark.html"
READ = 'docs/benchmark.md, "The result"'


def write_result(result: Result, folder: Path) -> dict[str, str]:
    """Write both files; return their paths by kind.

    Raises
    ------
    UsageError   the folder cannot be written
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / JSON).write_text(as_json(result.record), encoding="utf-8")
        (folder / PAGE).write_text(page_of(result), encoding="utf-8")
    except OSError as error:
        raise UsageError(
            f"--out '{folder}' cannot be written: {error}",
            usually="a file has that name, or the folder belongs to somebody else.",
            paste="similitude bench --quick --out similitude-out/bench",
            read=READ,
        ) from None
    return {"numbers": str(folder / JSON), "page": str(folder / PAGE)}


def as_json(record: dict[str, Any]) -> str:
    """Return a record as JSON, a row of the table a line; what never happened is the text "never"."""
    head = {key: value for key, value in record.items() if key != "rows"}
    rows = ",\n".join(json.dumps(plain(row), ensure_ascii=False) for row in record["rows"])
    text = json.dumps(plain(head), ensure_ascii=False, indent=1)
    return text.removesuffix("\n}") + ',\n "rows": [\n' + rows + "\n]}\n"


def read_result(path: Path) -> Result:
    """Read a result file that `write_result` wrote."""
    return Result(_back(json.loads(path.read_text(encoding="utf-8"))))


def plain(value: Any) -> Any:
    """Return a value as JSON has it: four digits, inf as "never", NaN as null."""
    if isinstance(value, dict):
        return {key: plain(x) for key, x in value.items()}
    if isinstance(value, list | tuple):
        return [plain(x) for x in value]
    if isinstance(value, float):
        if math.isnan(value):
            return None
        return "never" if math.isinf(value) else float(f"{value:.4g}")
    return value


def _back(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _back(x) for key, x in value.items()}
    if isinstance(value, list):
        return [_back(x) for x in value]
    return math.inf if value == "never" else value
