"""The main job on the bundled logs: `make demo` runs this and says where the pictures are.

Besides the logs as they were recorded there is one made here: the straight RAV4 drive with two small
sines added to the steer, and to the yaw rate what a linear bicycle answers to them. The car's
own noise and wandering stay in. It shows what a little steering tells.
"""

import csv
import json
import math
import pathlib
import shlex
import shutil
import subprocess
import sys

import numpy as np
from rich import box
from rich.console import Console
from rich.table import Table

ROOT = pathlib.Path(__file__).resolve().parents[1]
DATA = ROOT / "data"
OUT = ROOT / "demo-out"

SINES = (0.5, 1.5)  # Hz; one alone leaves K and the ratio of the axles open
AMPLITUDE = 3e-3  # rad at the road wheel, some 3 degrees at the steering wheel
# The bicycle that answers the sines. K is 25 % below the population's average, so that finding it
# means having learnt it; the rest is the average car.
PLANT = {"L": 2.65, "K": 110.0, "pi1": 0.4431, "eta": 1.42, "rho": 1.017}

EXPECTED = {"rav4_straight": "not_excited", "rav4_with_sines": "identified"}
REMARKS = {
    "rav4_straight": "hardly steered: nothing to learn, and it says so",
    "rav4_with_sines": f"two sines added, as K = {PLANT['K']:.0f} answers; the RAV4's own motion stays",
    "f1tenth_ds1 … 5": "steer is a late command, 0.63 to 1.0 of it arrives; K trades with it",
    "bmw_m8_double_lane_change": "its steer scale is a guess, and K carries that doubt",
}


def main() -> int:
    """Identify every bundled log, print one table; 1 when an expected verdict did not come."""
    console = Console()
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir()
    sine = write_log_with_sines(DATA / "rav4_straight.csv", OUT / "rav4_with_sines.csv")
    jobs = (
        ("rav4.toml", [DATA / "rav4_straight.csv", sine]),
        ("f1tenth.toml", sorted(DATA.glob("f1tenth_ds*.csv"))),
        ("bmw_m8.toml", [DATA / "bmw_m8_double_lane_change.csv"]),
    )
    answers: dict[str, dict] = {}
    for vehicle, logs in jobs:
        for log in logs:
            answers[log.stem] = identify(log, DATA / vehicle, console)
    console.print(summary_table(answers))
    for name, answer in answers.items():
        console.print(f"[bold]{name}[/bold]: {answer['reason']}", highlight=False)
    console.print("\nWhat to know about these logs:")
    for name, remark in REMARKS.items():
        console.print(f"  [bold]{name}[/bold]: {remark}", highlight=False)
    console.print(f"\nPictures: {relative(OUT)}/<log>/plot.png", highlight=False)
    wrong = [n for n, verdict in EXPECTED.items() if answers[n]["verdict"] != verdict]
    for name in wrong:
        console.print(f"[red]{name}: expected {EXPECTED[name]}[/red], see its plot.png")
    return 1 if wrong else 0


def write_log_with_sines(source: pathlib.Path, target: pathlib.Path) -> pathlib.Path:
    """Copy a log, two sines added to its steer and a linear bicycle's answer to its yaw rate."""
    from similitude.simulate import bicycle_response

    with open(source, newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    table = np.array(rows, dtype=float)
    columns = {name.split(" [")[0]: i for i, name in enumerate(header)}
    t, speed = table[:, columns["t"]], table[:, columns["U"]]
    delta = AMPLITUDE * sum(np.sin(2 * math.pi * frequency * t) for frequency in SINES)
    r, _ = bicycle_response(t, delta, speed, **PLANT)
    table[:, columns["delta"]] += delta
    table[:, columns["r"]] += r
    with open(target, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([[f"{cell:.9g}" for cell in row] for row in table])
    return target


def identify(log: pathlib.Path, vehicle: pathlib.Path, console: Console) -> dict:
    """Run the command on one log as a user would and read its JSON line."""
    similitude = pathlib.Path(sys.executable).with_name("similitude")
    words = ["identify", relative(log), "--vehicle", relative(vehicle)]
    words += ["--out", relative(OUT / log.stem), "--json"]
    console.print(f"[dim]$ similitude {shlex.join(words)}[/dim]", highlight=False, soft_wrap=True)
    done = subprocess.run([str(similitude), *words], cwd=ROOT, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise SystemExit(f"that ended with status {done.returncode}")
    return json.loads(done.stdout)


def summary_table(answers: dict[str, dict]) -> Table:
    """One row a log: verdict, K with its interval, and the steer lag; 80 columns hold it."""
    table = Table(title="similitude on the bundled logs", title_justify="left", box=box.SIMPLE_HEAD)
    for heading in ("log", "verdict"):
        table.add_column(heading, overflow="fold")
    for heading in ("K m²/s²", "95 %", "lag ms"):
        table.add_column(heading, justify="right", no_wrap=True)
    for name, answer in answers.items():
        k = answer["K"]
        interval = f"{k['lo']:.3g}…{k['hi']:.3g}"
        table.add_row(name, answer["verdict"], f"{k['value']:.3g}", interval, lag(answer))
    table.caption = "* lag scanned from the log"
    table.caption_justify = "left"
    return table


def lag(answer: dict) -> str:
    """The steer lag that was used, in ms, with a star when it was scanned from the log."""
    found = answer.get("lag") or {}
    if found.get("value") is None:
        return "–"
    scanned = "*" if found.get("from") == "scanned" else ""
    return f"{1e3 * found['value']:.0f}{scanned}"


def relative(path: pathlib.Path) -> str:
    return str(path.relative_to(ROOT))


if __name__ == "__main__":
    sys.exit(main())
