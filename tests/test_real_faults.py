"""Real logs with one thing damaged: each fault is named, and its repair gives a log again."""

from pathlib import Path

import numpy as np
import pytest

from similitude.log import read_log
from similitude.log_survey import survey
from similitude.vehicle_file import read_vehicle

from . import damaged_drives as bad

DATA = Path(__file__).parents[1] / "data"
LOGS = {
    "rav4_straight": "rav4",
    "bmw_m8_double_lane_change": "bmw_m8",
    "f1tenth_ds1": "f1tenth",
    "f1tenth_ds4": "f1tenth",
}
DEG = 180 / np.pi
# fault: (damage, names one of which must be found, is it certain)
FAULTS = {
    "yaw rate stuck": (bad.stuck("r"), {"stuck"}, False),
    "hole interpolated": (bad.interpolated, {"interpolated"}, False),
    "spikes": (bad.spiked("r"), {"spikes"}, False),
    "saturated": (bad.clipped("r"), {"clipped"}, False),
    "counter": (bad.wrapped(2**32 * 1e-6), {"time_wraps"}, True),
    "joined": (bad.restarted, {"time_restarts"}, True),
    "clock": (bad.clock_set, {"time_restarts", "clock_step", "time_wraps"}, True),
    "shuffled": (bad.shuffled, {"time_unsorted"}, True),
    "repeated": (bad.repeated, {"time_repeats"}, True),
    "sign": (bad.scaled("delta", -1), {"steer_sign"}, True),
    "yaw rate in deg/s": (
        bad.scaled("r", DEG),
        {"steer_against_yaw", "impossible_unit", "ay_against_yaw"},
        True,
    ),
    "yaw rate in rad/s": (bad.scaled("r", 1 / DEG), {"steer_against_yaw", "ay_against_yaw"}, True),
    "steering wheel": (bad.scaled("delta", 16.0), {"steer_against_yaw", "impossible_unit"}, True),
}


def real(name, vehicle):
    """A real log from its first metre on, as a drive to damage."""
    log = read_log(DATA / f"{name}.csv")
    columns = {
        key: getattr(log, key) for key in ("t", "delta", "r", "U", "ay") if getattr(log, key) is not None
    }
    moving = np.flatnonzero(log.U > 1.0)
    columns = {key: column[moving[0] : moving[-1]] for key, column in columns.items()}
    vehicle = read_vehicle(DATA / f"{vehicle}.toml")
    return bad.Drive(columns, vehicle.L.value, float(np.median(log.U)), float(log.delta.std()))


@pytest.mark.parametrize("name", LOGS)
@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_of_a_real_log_is_named(tmp_path, name, fault):
    damage, names, certain = FAULTS[fault]
    drive = real(name, LOGS[name])
    for seed in range(3):
        columns = damage(drive, np.random.default_rng(seed))
        seen = bad.look(bad.Drive(columns, drive.L, drive.speed, drive.rms), tmp_path)

        found = [one for one in seen.findings if one.fault in names]
        assert found, [one.fault for one in seen.findings]
        assert bool(seen.certain) is certain


REPAIRABLE = ["yaw rate stuck", "hole interpolated", "spikes", "saturated", "counter", "joined", "shuffled",
              "repeated", "sign"]  # fmt: skip


@pytest.mark.parametrize("fault", REPAIRABLE)
def test_the_repair_that_is_proposed_works(tmp_path, fault):
    damage, names, _ = FAULTS[fault]
    drive = real("rav4_straight", "rav4")
    columns = damage(drive, np.random.default_rng(0))
    seen = bad.look(bad.Drive(columns, drive.L, 0.0, 0.0), tmp_path)
    (found,) = [one for one in seen.findings if one.fault in names]

    mended = survey(seen.path, fixes=[found.fix])

    assert mended.fixes
    assert not mended.certain
    assert not {one.fault for one in mended.findings} & names
