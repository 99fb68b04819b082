"""Where the instructions of a step are: counted in the code, by part (`python scripts/embedded_parts.py`).

An exported folder is built for the Cortex-M4F as `make embedded` builds it, with line numbers. An instruction
counts for its line of C, and a line for the part that begins at or before it. Both ways of every guard are in
the code, so the sum is more than any one sample takes.

Invariant: the parts cover every line of the step, so their counts add up to it.
"""

from __future__ import annotations

import re
import sys
import tempfile
from pathlib import Path

from similitude.embedded.folder import export
from similitude.embedded.machine import run
from similitude.embedded.targets import TARGETS, flags_of

CAR = Path(__file__).parents[1] / "data" / "bmw_m8.toml"
# A part's name, and what the first line of it holds.
FILTER = (
    ("covariance forward in time", "_propagate("),
    ("correction of the fast", "_correct("),
    ("learning of the slow", "_learn("),
    ("gates", "_advance("),
    ("scales", "least_scale ="),
    ("starting anew", "if (anew > 0)"),
    ("dynamics and sensitivities", "ratio_v_star ="),
    ("drift and pull", "move = R(0.0)"),
    ("prediction, noise, validity", "response ="),
    ("innovation, surprise, jump", "if (usable > 0) { /* measurement */"),
    ("when to learn, limits", "if (state->excited > R(0.0))"),
    ("slow sizes by turns", "if (state->turn <= R(0.0))"),
    ("the first unknown, outputs", "half_move ="),
)
PAPER = (
    ("gates", "_advance("),
    ("filters", "input_bend ="),
    ("regressor and prediction", "phi ="),
    ("learning", "if ((BEYOND(y_now"),
    ("end of the filters, no time", "state->input_2 = state->input_2"),
    ("report: K, interval, outputs", "_report("),
)
COUNTED = {"small_population": FILTER, "paper": PAPER}


def lines_of(source: Path) -> dict[int, int]:
    """Line of a C file -> instructions that belong to it, on the Cortex-M4F."""
    target = TARGETS["cortex-m4f"]
    made = source.with_suffix(".o")
    run([target.compiler, *flags_of(target), "-g", "-c", source.name, "-o", made.name], source.parent)
    tool = target.compiler.removesuffix("gcc") + "objdump"
    counts: dict[int, int] = {}
    at = 0
    for text in run([tool, "-dl", "--no-show-raw-insn", made.name], source.parent).splitlines():
        if place := re.match(r".*\.c:(\d+)", text):
            at = int(place[1])
        elif re.match(r"\s+[0-9a-f]+:\t", text) and ".word" not in text:
            counts[at] = counts.get(at, 0) + 1
    return counts


def parts_of(source: Path, marks: tuple[tuple[str, str], ...]) -> dict[str, int]:
    """Instructions of each part of a step."""
    counts, found, now = lines_of(source), dict.fromkeys((name for name, _ in marks), 0), ""
    waiting = list(marks)
    for number, text in enumerate(source.read_text().splitlines(), 1):
        if "unsigned long" in text and "_checksum(" in text:
            break  # saving stands after the step
        for name, mark in waiting[:1] if now else waiting:
            if mark in text and ("=" in mark or not text.rstrip().endswith(";")):  # a call begins nothing
                now = name
                waiting = waiting[1:]
                break
        if now:
            found[now] += counts.get(number, 0)
    return found


def main() -> int:
    """Print a table an estimator."""
    for estimator in sys.argv[1:] or COUNTED:
        with tempfile.TemporaryDirectory(prefix="similitude-") as place:
            folder = Path(place, estimator)
            export("bicycle", estimator=estimator, real="float", target="host", out=folder, vehicle=CAR)
            found = parts_of(folder / f"bicycle_{estimator}.c", COUNTED[estimator])
        for name, count in found.items():
            print(f"{estimator:18} {name:32} {count:5}")
        print(f"{estimator:18} {'all':32} {sum(found.values()):5}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
