"""`similitude identify` as a user waits for it: from the start of the process to its written report.

Measured against a process that only imports the three libraries any such report needs. The C is
cached beforehand; byte code and matplotlib's font list are, too, by the uncounted first round.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from bench.drives import CAR, road_drive

IMPORTS = "import numpy, pyarrow.parquet, matplotlib.pyplot"
VEHICLE = f'name = "bench"\nL = "{CAR["L"]} m"\npopulation = "passenger_cars"\n'
WRITTEN = ("estimate.parquet", "plot.png", "summary.json")


@contextmanager
def processes(samples: int) -> Iterator[dict[str, Callable[[], None]]]:
    """The two processes to time, on a simulated log of so many rows at 100 Hz.

    Yields
    ------
    actions : ``imports`` and ``identify``, each running one process to its end.

    Raises
    ------
    RuntimeError    a process failed or wrote no report.
    """
    with tempfile.TemporaryDirectory(prefix="similitude-bench-") as name:
        folder = Path(name)
        road_drive(samples).write_csv(folder / "drive.csv")
        (folder / "car.toml").write_text(VEHICLE, encoding="utf-8")
        environment = {**os.environ, "SIMILITUDE_CACHE": str(folder / "cache")}
        identify = [sys.executable, "-m", "similitude.cli", "identify", "drive.csv"]
        identify += ["--vehicle", "car.toml", "--out", "out"]

        def run(command: list[str]) -> None:
            done = subprocess.run(
                command, cwd=folder, env=environment, capture_output=True, text=True, check=False
            )
            if done.returncode:
                raise RuntimeError(f"{' '.join(command)} failed:\n{done.stderr}")

        def run_identify() -> None:
            run(identify)
            missing = [file for file in WRITTEN if not (folder / "out" / file).is_file()]
            if missing:
                raise RuntimeError(f"identify wrote no {', '.join(missing)}")

        yield {"imports": lambda: run([sys.executable, "-c", IMPORTS]), "identify": run_identify}
