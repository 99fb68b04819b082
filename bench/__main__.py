"""Entry of `make bench`: takes the measurements, prints them, exits 1 where a bound is missed."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from rich.console import Console

from bench.measurements import QUICK, Counts, measure
from bench.page import record, show

RESULTS = Path(__file__).with_name("results.json")


def main(arguments: list[str] | None = None) -> int:
    """Run every measurement; 0 when every bound holds, 1 when one is missed."""
    parser = argparse.ArgumentParser(prog="python -m bench", description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one line of JSON, no tables")
    parser.add_argument("--write", action="store_true", help=f"write {RESULTS.name} beside this file")
    parser.add_argument("--quick", action="store_true", help="few samples, C and Python loops only")
    asked = parser.parse_args(arguments)
    rows, bounds = measure(QUICK if asked.quick else Counts())
    found = record(rows, bounds)
    if asked.json:
        print(json.dumps(found))
    else:
        show(rows, bounds, Console(highlight=False))
    if asked.write:
        RESULTS.write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    return 0 if all(bound.holds for bound in bounds) else 1


if __name__ == "__main__":
    sys.exit(main())
