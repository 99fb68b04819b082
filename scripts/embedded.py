"""make embedded: every estimator on every emulated target, bit for bit against the host, within its budget.

Streams the self-test's samples (faults among them), a real log and a simulated one through each target;
compares every status, output and the last state with the committed C on this machine; compares
instructions or cycles, flash, RAM and stack with scripts/embedded_budgets.json (fails 5 % above it).

    python scripts/embedded.py [--write-budgets] [--only ESTIMATOR] [--target NAME]

A target whose tools are missing is skipped with a line that says what to install.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import os
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from similitude.change_alarm import monitored
from similitude.embedded.costs import Cost, measure, missing_tools
from similitude.embedded.drive import self_test_rows
from similitude.embedded.fixed_profile import FIXED, Profile, fixed_profile
from similitude.embedded.fixed_texts import integer_rows, self_test_drive
from similitude.embedded.folder import export, export_profile
from similitude.embedded.system import SHIPPED, find_source
from similitude.embedded.targets import TARGETS
from similitude.embedded.vectors import Vectors
from similitude.embedded.verify import verify_folder
from similitude.filter_run import population_setup
from similitude.log import read_log
from similitude.program.compile import load_library
from similitude.program.library import shipped
from similitude.simulate import bicycle_response
from similitude.vehicle_file import read_vehicle
from similitude.vehicle_prior import vehicle_prior

ROOT = Path(__file__).parents[1]
BUDGETS = Path(__file__).with_name("embedded_budgets.json")
LOG, CAR = ROOT / "data" / "bmw_m8_double_lane_change.csv", ROOT / "data" / "bmw_m8.toml"
ROOM = 1.05  # over a budget
SIMULATED = 1000  # rows
KEPT = ("most", "flash", "state", "stack")  # figures with a budget
COLUMNS = "{:30} {:11} {:>9} {:>8} {:>8} {:>7} {:>6} {:>6} {:>6} {:>6}  {}"


def logs() -> tuple[np.ndarray, float]:
    """Rows of a real drive and of a simulated one, one after the other; and the time between rows [s]."""
    car = read_vehicle(CAR)
    log = read_log(LOG, vehicle=car)
    known = {"L": car.L.value, "noise_std": 0.002, "input_scale_sd": 0.02}
    real = population_setup(log, vehicle_prior(car), **known).samples()
    step = float(np.median(real[:, 0]))
    t = np.arange(SIMULATED) * step
    rng = np.random.default_rng(1)
    steer = 0.03 * np.sin(2 * np.pi * 0.4 * t) + 0.01 * np.sin(2 * np.pi * 1.1 * t)
    speed = 20 + 5 * np.sin(2 * np.pi * t / 20)
    r, _ = bicycle_response(t, steer, speed, L=car.L.value, K=146.0, pi1=0.45, eta=1.4, rho=1.0)
    made = np.column_stack(
        [np.full(SIMULATED, step), steer, speed, r + 0.002 * rng.standard_normal(SIMULATED)]
    )
    return np.vstack([real, made]), step


def rows_of(system: str, estimator: str, rows: np.ndarray) -> np.ndarray:
    """The same rows as an estimator takes them: the monitor's hold what the filter handed out."""
    if system == "bicycle_with_accelerometer":
        return np.column_stack([rows, rows[:, 2] * rows[:, 3]])  # U r
    if estimator != "monitor":
        return rows
    car = read_vehicle(CAR)
    setup = population_setup(
        read_log(LOG, vehicle=car), vehicle_prior(car), L=car.L.value, noise_std=0.002, input_scale_sd=0.02
    )
    return monitored(shipped("bicycle_monitor"), setup.run())


def on_host(
    name: str, source: str, config: np.ndarray, rows: np.ndarray, outputs: int, states: int
) -> Vectors:
    """The committed C in single precision on this machine."""
    c = load_library(source, name=name, real="float")
    with np.errstate(over="ignore"):
        config, rows = (np.ascontiguousarray(x, np.float32) for x in (config, rows))
    state, out = np.zeros(states, np.float32), np.zeros((len(rows), outputs), np.float32)
    status = np.zeros(len(rows), np.int32)
    at = [ctypes.c_void_p(x.ctypes.data) for x in (config, state, rows, out, status)]
    getattr(c, f"{name}_init")(at[0], at[1])
    getattr(c, f"{name}_batch")(at[0], at[1], ctypes.c_long(len(rows)), *at[2:])
    return Vectors(rows.view(np.uint32), status, out.view(np.uint32), state.view(np.uint32))


def main() -> int:
    """Measure, print the table, compare with the budgets; the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write-budgets", action="store_true", help="keep what is measured as the budgets")
    parser.add_argument("--only", help="one estimator, such as bicycle_paper")
    parser.add_argument("--target", help="one target")
    asked = parser.parse_args()
    targets = _present(asked.target)
    budgets = json.loads(BUDGETS.read_text()) if BUDGETS.exists() else {}
    rows, step = logs()
    faults: list[str] = []
    print(
        COLUMNS.format(
            "estimator",
            "target",
            "mean",
            "most",
            "flash",
            "arith.",
            "RAM",
            "stack",
            "words",
            "differ",
            "",
        )
    )
    kept = {"write": asked.write_budgets}
    for system, estimators in SHIPPED.items():
        for estimator in estimators:
            name = f"{system}_{estimator}"
            if asked.only in (None, name) and targets:
                faults += _one(system, estimator, rows, step, targets, budgets, **kept)
    for estimator in FIXED:
        if asked.only in (None, f"bicycle_{estimator}_fixed") and targets:
            faults += _one_fixed(estimator, rows, step, targets, budgets, **kept)
    if asked.write_budgets:
        BUDGETS.write_text(json.dumps(budgets, indent=1, sort_keys=True) + "\n")
    for fault in faults:
        print(f"FAILED {fault}")
    print(
        "failed" if faults else "all bits equal, all budgets kept",
        f"in {time.process_time():.0f} s of this process",
    )
    return 1 if faults else 0


def _present(wanted: str | None) -> list:
    """Targets whose tools are here; a line for each that is skipped."""
    found = []
    for target in TARGETS.values():
        if target.name == "host" or wanted not in (None, target.name):
            continue
        lacking = missing_tools(target)
        if lacking:
            print(f"skipped {target.name}: {', '.join(lacking)} missing; apt-get install {target.packages}")
        else:
            found.append(target)
    return found


def _one(
    system: str, estimator: str, rows, step: float, targets: list, budgets: dict, *, write: bool
) -> list[str]:
    """One estimator on every target; what failed."""
    source, faults = find_source(system, estimator), []
    library = source.library()
    with tempfile.TemporaryDirectory(prefix="similitude-") as place:
        folder = Path(place, source.name)
        done = export(
            system,
            estimator=estimator,
            real="float",
            target="host",
            out=folder,
            vehicle=CAR,
            sample_time=step,
        )
        verified = verify_folder(folder)
        outputs, states = len(library.layout.OUTPUT), len(library.names("state"))
        faulty = self_test_rows(source, library, done.numbers.values, step)
        driven = np.vstack([faulty, rows_of(system, estimator, rows)])
        wanted = on_host(source.name, source.c, done.numbers.values, driven, outputs, states)
        faults += _measured(folder, source, "float", targets, wanted, budgets, write=write)
        faults += [] if verified.words else [f"{source.name}: an empty self-test"]
    return faults


def _one_fixed(estimator: str, rows, step: float, targets: list, budgets: dict, *, write: bool) -> list[str]:
    """One estimator in fixed point on every target; what failed."""
    profile = fixed_profile("bicycle", estimator, vehicle=CAR, sample_time=step)
    driven = integer_rows(profile, np.vstack([self_test_drive(profile), rows]))
    wanted = words_on_host(profile, driven)
    with tempfile.TemporaryDirectory(prefix="similitude-") as place:
        folder = Path(place, profile.source.name)
        export_profile(profile, target="host", out=folder)
        faults = [] if verify_folder(folder).words else [f"{profile.source.name}: an empty self-test"]
        return faults + _measured(folder, profile.source, "fixed", targets, wanted, budgets, write=write)


def words_on_host(profile: Profile, rows: np.ndarray) -> Vectors:
    """The generated C in whole numbers on this machine; rows (n, sample fields) of int32."""
    name, layout = profile.source.name, profile.source.library().layout
    c = load_library(profile.source.c, name=name)
    sizes = (1, len(layout.STATE), (len(rows), len(layout.OUTPUT)), len(rows))
    config, state, out, status = (np.zeros(size, np.int32) for size in sizes)
    at = [ctypes.c_void_p(x.ctypes.data) for x in (config, state, rows, out, status)]
    getattr(c, f"{name}_init")(at[0], at[1])
    getattr(c, f"{name}_batch")(at[0], at[1], ctypes.c_long(len(rows)), *at[2:])
    return Vectors(rows.view(np.uint32), status, out.view(np.uint32), state.view(np.uint32))


def _measured(
    folder: Path, source, real: str, targets: list, wanted: Vectors, budgets: dict, *, write: bool
) -> list[str]:
    """A folder on every target: a row each; what failed."""
    faults: list[str] = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:  # of emulators, which are processes of their own
        costs = list(pool.map(lambda target: _cost(folder, source, real, target, wanted), targets))
    for target, cost in zip(targets, costs, strict=True):
        if cost is None:
            print(f"{source.name:30} {target.name:11} does not fit the part")
        else:
            faults += _judge(source.name, cost, wanted.words, budgets, write=write)
    return faults


def _cost(folder: Path, source, real: str, target, wanted: Vectors) -> Cost | None:
    """A folder on one target; None where it does not fit the part."""
    scratch = folder.parent / target.name
    scratch.mkdir()
    try:
        return measure(folder, source, real, target, wanted, scratch)[0]
    except Exception as fault:
        if "will not fit" not in str(fault):
            raise
        return None


def _judge(name: str, cost: Cost, words: int, budgets: dict, *, write: bool) -> list[str]:
    """Print a row; what is wrong with it."""
    over = f"report {cost.report}" if cost.report else ""
    faults = [f"{name} on {cost.target}: {cost.differing} words differ"] if cost.differing else []
    key = f"{name}/{cost.target}"
    if write:
        budgets[key] = {figure: getattr(cost, figure) for figure in KEPT}
    for figure, budget in budgets.get(key, {}).items():
        if getattr(cost, figure) > ROOM * budget:
            over += f" {figure} over {budget}"
            faults.append(f"{key}: {figure} is {getattr(cost, figure)}, budget {budget}")
    if key not in budgets:
        faults.append(f"{key} has no budget: python scripts/embedded.py --write-budgets")
    figures = (
        f"{cost.mean:.0f}",
        cost.most,
        cost.flash,
        cost.arithmetic,
        cost.state,
        cost.stack,
        words,
        cost.differing,
    )
    print(COLUMNS.format(name, cost.target, *figures, over), flush=True)
    return faults


if __name__ == "__main__":
    sys.exit(main())
