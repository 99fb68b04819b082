"""Prints what becomes of damaged logs: refused, named, harmless or wrong (`make damage`).

Simulated and real logs, each fault at random places and of random size, read and identified like a user's
file. The table of docs/logs.md; a quarter of an hour on two cores.
"""

from __future__ import annotations

import sys
import tempfile
import zlib
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from rich.console import Console
from rich.table import Table
from tests import damaged_drives as bad
from tests.damaged_drives import Drive

from similitude import read_scenario, run_scenario
from similitude.errors import SimilitudeError
from similitude.finding import Finding
from similitude.identification import identify
from similitude.log import Log, read_log
from similitude.run import Run
from similitude.units import parse_uncertain
from similitude.vehicle_file import Vehicle, read_vehicle

PLACES = 3  # of each fault on each log
DATA = Path(__file__).parents[1] / "data"
DEG = 180 / np.pi
NUMBER = ("identified", "weak")  # verdicts by which a reader takes K for the car's
WORDS = ("refused", "named", "doubted", "no number", "harmless", "wrong")
SECONDS = 40.0  # of each log
SHORT = {"run.duration": f"{SECONDS:g} s", "run.log_rate": "50 Hz"}
SIMULATED = {
    "slalom": ("slalom", {}),
    "sweep": ("sweep", {}),
    "highway": ("highway", {}),
    "town": ("highway", {"speed.mean": "50 km/h", "driver.rms": "12 mrad"}),
    "linear car": ("highway", {"plant": {"kind": "linear"}}),
    "gentle turns": ("turns", {"driver.amplitude": "10 mrad"}),
}
REAL = {
    "RAV4": ("rav4_straight", "rav4"),
    "BMW": ("bmw_m8_double_lane_change", "bmw_m8"),
    "F1/10, 1": ("f1tenth_ds1", "f1tenth"),
    "F1/10, 4": ("f1tenth_ds4", "f1tenth"),
}
GAIN = {"steer_against_yaw", "impossible_unit", "ay_against_yaw", "steer_scale", "speed_unit"}
JOINED = {"time_restarts", "clock_step", "drives_joined", "time_wraps", "gap"}
LATE = {"late_steer", "late_yaw", "early_yaw", "clocks_apart"}

# fault: (how to damage, names one of which a message must carry, unit the header claims instead)
FAULTS: dict[str, tuple[Callable, set[str], dict[str, str]]] = {
    "nothing": (bad.nothing, set(), {}),
    "yaw rate in deg/s": (bad.scaled("r", DEG), GAIN, {}),
    "yaw rate in rad/s": (bad.scaled("r", 1), GAIN, {"r": "deg/s"}),
    "steer in deg": (bad.scaled("delta", DEG), GAIN, {}),
    "steer in rad": (bad.scaled("delta", 1), GAIN, {"delta": "deg"}),
    "steering wheel as road wheel": (bad.scaled("delta", 15.3), GAIN | {"steer_cut"}, {}),
    "road wheel divided again": (bad.scaled("delta", 1 / 15.3), GAIN, {}),
    "speed in km/h": (bad.scaled("U", 3.6), GAIN, {}),
    "speed in m/s": (bad.scaled("U", 1), GAIN, {"U": "km/h"}),
    "speed in mph as km/h": (bad.scaled("U", 2.236936), GAIN, {"U": "km/h"}),
    "speed in knots as km/h": (bad.scaled("U", 1.943844), GAIN, {"U": "km/h"}),
    "speed of mph divided by 3.6": (bad.scaled("U", 1 / 1.609344), GAIN, {}),
    "speed in mph as m/s": (bad.scaled("U", 2.236936), GAIN, {}),
    "speed of one wheel": (bad.one_wheel, {"speed_of_one_wheel"}, {}),
    "speed negative": (bad.scaled("U", -1), {"reverse"} | GAIN, {}),
    "speed zero for a while": (bad.zeroed("U"), {"standstill", "drives_joined", "speed_unit"}, {}),
    "sign of the steer": (bad.scaled("delta", -1), {"steer_sign"}, {}),
    "sign of the yaw rate": (bad.scaled("r", -1), {"steer_sign", "ay_sign"}, {}),
    "time in ms": (bad.scaled("t", 1e3), {"time_unit"}, {}),
    "time in s as ms": (bad.scaled("t", 1), {"time_unit", "too_short"}, {"t": "ms"}),
    "time since 1970": (bad.since_1970, {"time_since_epoch"}, {}),
    "counter of 16 bits": (bad.wrapped(2**16 * 1e-3), {"time_wraps"}, {}),
    "counter of 32 bits": (bad.wrapped(2**32 * 1e-6), {"time_wraps"}, {}),
    "time in min": (bad.scaled("t", 1 / 60), {"time_unit", "too_short"}, {}),
    "time in h": (bad.scaled("t", 1 / 3600), {"time_unit", "too_short"}, {}),
    "clock set": (bad.clock_set, JOINED, {}),
    "clock set by a little": (bad.clock_nudged, JOINED | {"short_gaps", "time_unsorted"}, {}),
    "rows shuffled": (bad.shuffled, {"time_unsorted"}, {}),
    "rows repeated": (bad.repeated, {"time_repeats"}, {}),
    "recordings joined": (bad.restarted, JOINED, {}),
    "drives joined": (bad.joined, JOINED, {}),
    "steer stuck": (bad.stuck("delta"), {"stuck"}, {}),
    "yaw rate stuck": (bad.stuck("r"), {"stuck"}, {}),
    "speed stuck": (bad.stuck("U"), {"stuck"}, {}),
    "steer stuck for long": (bad.stuck("delta", 5, 15), {"stuck"}, {}),
    "steer clipped": (bad.clipped("delta"), {"clipped", "steer_cut"}, {}),
    "yaw rate clipped": (bad.clipped("r"), {"clipped"}, {}),
    "yaw rate overflows": (bad.overflowing("r"), {"overflow", "spikes"}, {}),
    "yaw rate with a dead band": (bad.dead_banded("r"), {"dead_band"}, {}),
    "dead band subtracted": (bad.dead_subtracted("r"), {"dead_band", "dead_band_subtracted"}, {}),
    "spikes of the steer": (bad.spiked("delta"), {"spikes"}, {}),
    "spikes of the yaw rate": (bad.spiked("r"), {"spikes"}, {}),
    "spikes of the speed": (bad.spiked("U"), {"spikes"}, {}),
    "hole interpolated": (bad.interpolated, {"interpolated"}, {}),
    "yaw rate 0.1 to 0.5 s late": (bad.late("r", 0.1, 0.5), LATE, {}),
    "steer 0.1 to 0.5 s late": (bad.late("delta", 0.1, 0.5), LATE, {}),
    "cells lost": (bad.lost, {"cells_missing"}, {}),
    "steer at half the rate": (bad.slower("delta"), {"column_slower"}, {}),
    "yaw rate at half the rate": (bad.slower("r"), {"column_slower"}, {}),
    "wheelbase in mm as m": (bad.nothing, {"L"}, {}),
    "stiffness of one tyre": (bad.nothing, {"Caf"}, {}),
}  # fmt: skip


def bases() -> dict[str, tuple[Drive, Vehicle, float | None]]:
    """Log, vehicle and true K [m^2/s^2] of every undamaged drive; None where nobody knows it."""
    found = {}
    for name, (scenario, changes) in SIMULATED.items():
        (drive,) = run_scenario(read_scenario(scenario, changes=SHORT | changes), seeds=[1])
        columns = {header.split(" [")[0]: np.array(values) for header, values in drive.log.items()}
        L = float(read_scenario(scenario).vehicle.stated["L"].value)
        vehicle = Vehicle("car", L=parse_uncertain(f"{L} m"), m=parse_uncertain("1500 kg"))
        found[name] = (Drive(columns, L, 0.0, 0.0), vehicle, float(drive.truth["K [m^2/s^2]"][-1]))
    for name, (stem, car) in REAL.items():
        log, vehicle = read_log(DATA / f"{stem}.csv"), read_vehicle(DATA / f"{car}.toml")
        moving = np.flatnonzero(log.U > 1.0)
        columns = {key: getattr(log, key) for key in bad.NAMES if getattr(log, key) is not None}
        end = min(moving[-1], moving[0] + int(SECONDS * log.rate))
        columns = {key: column[moving[0] : end] for key, column in columns.items()}
        found[name] = (Drive(columns, vehicle.L.value, 0.0, 0.0), vehicle, None)
    return found


def altered(fault: str, vehicle: Vehicle, K: float) -> Vehicle:
    """The vehicle file with its own fault, where that is what is damaged."""
    if fault == "wheelbase in mm as m":
        return replace(vehicle, L=parse_uncertain(f"{1000 * vehicle.L.value} m"))
    if fault == "stiffness of one tyre" and vehicle.m is not None:
        per_tyre = K * vehicle.m.value / vehicle.L.value / 2
        return replace(vehicle, Caf=parse_uncertain(f"{per_tyre} N/rad"))
    return vehicle


def outcome(
    path: Path, vehicle: Vehicle, names: set[str], before: set[str], K: float
) -> tuple[str, tuple[str, ...]]:
    """What a user is told of a file: a word of `WORDS`, and the faults or warnings met."""
    try:
        log = read_log(path, vehicle=vehicle)
        new = [one.fault for one in log.findings if one.fault in names and _where(one) not in before]
        if new:
            return "named", tuple(new)
        run = identify(log, vehicle)
    except SimilitudeError as error:
        return "refused", (error.fault,)
    said = tuple(kind for kind in map(_kind, run.warnings) if kind and kind not in before)
    if any(one in names for one in said):
        return "named", said
    if run.verdict not in NUMBER:
        return "no number", (run.verdict, *said)
    if run.K.lo <= K <= run.K.hi:
        return "harmless", said
    return ("doubted" if said else "wrong"), (f"{run.K.value:.0f} ({run.K.lo:.0f}-{run.K.hi:.0f})", *said)


def _where(finding: Finding) -> str:
    """Fault and column: the command of a steer may be cut off before its yaw rate is."""
    return f"{finding.fault} of {finding.column}"


# What a warning says about the fault, for warnings that carry no name.
TOLD = {
    "late_steer": ("acts", "ms after its column"),
    "clocks_apart": ("comes about", "two clocks"),
    "steer_scale": ("turns the car", "as much as its"),
    "steer_cut": ("is held at",),
    "speed_unit": ("the whole log would be", "times as likely"),
    "cross_check": ("two estimators disagree",),
    "Caf": ("the estimate of Caf is",),
    "halves": ("half of the log reads K",),
}


def _kind(warning: str) -> str:
    for kind, parts in TOLD.items():
        if all(part in warning for part in parts):
            return kind
    return "" if warning.startswith("K and steer scale trade") else warning[:30]


def swept(faults: Sequence[str], places: int, show: Callable[[str], None]) -> dict[str, Counter]:
    """Outcomes of every fault over all logs; ``show`` is given a line for each that is wrong."""
    counts: dict[str, Counter] = {fault: Counter() for fault in faults}
    with tempfile.TemporaryDirectory() as folder:
        for name, (drive, vehicle, truth) in bases().items():
            known = {with_ay: undamaged(drive, vehicle, Path(folder), with_ay) for with_ay in (True, False)}
            for fault in faults:
                damage, names, units = FAULTS[fault]
                for place in range(places):
                    with_ay = place % 2 == 0
                    before, run = known[with_ay]
                    if truth is None and run.verdict not in NUMBER and fault == "stiffness of one tyre":
                        continue
                    K = truth or run.K.value
                    rng = np.random.default_rng([place, zlib.crc32(f"{name} {fault}".encode())])
                    damaged = replace(drive, columns=damage(drive, rng))
                    path = bad.write(damaged, Path(folder), with_ay=with_ay, units={**bad.UNITS, **units})
                    word, what = outcome(path, altered(fault, vehicle, K), names, before, K)
                    counts[fault][word] += 1
                    if word in ("wrong", "doubted"):
                        show(f"{word:8} {fault} · {name}, place {place}: K {K:.0f}; {'; '.join(what)}")
    return counts


def undamaged(drive: Drive, vehicle: Vehicle, folder: Path, with_ay: bool) -> tuple[set[str], Run]:
    """What the sound log is told anyway, and its run."""
    log: Log = read_log(bad.write(drive, folder, with_ay=with_ay), vehicle=vehicle)
    run = identify(log, vehicle)
    found: tuple[Finding, ...] = log.findings
    return {_where(one) for one in found} | {_kind(one) for one in run.warnings}, run


def main() -> None:
    """Sweep the faults named on the command line, or all, and print the table."""
    faults = sys.argv[1:] or list(FAULTS)
    console = Console(width=110)
    counts = swept(faults, PLACES, lambda line: console.print(line, highlight=False, soft_wrap=True))
    table = Table(title=f"{len(SIMULATED)} simulated and {len(REAL)} real logs, {PLACES} places each")
    for title in ("fault", *WORDS):
        table.add_column(title, justify="left" if title == "fault" else "right")
    for fault, found in counts.items():
        table.add_row(fault, *(str(found[word] or "") for word in WORDS))
    console.print(table)


if __name__ == "__main__":
    main()
