"""The cells of the benchmark: manoeuvre × plant, and one fault at a time.

Invariant: a cell is a scenario in full; two cells differ in nothing but what their names say.
Every drive lasts 80 s at 100 Hz, and at 50 s the tyres lose half their stiffness and half their peak, unless
the fault says something else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

CHANGE_AT, DURATION = 50.0, 80.0  # s
SEEDS, FOREIGN_SEEDS = 20, 5
QUICK_SEEDS = 3

# Peaks of lateral acceleration from 1 to 3 m/s^2 before the change.
MANOEUVRES: Mapping[str, dict[str, Any]] = {
    "slalom": {
        "driver": {"kind": "slalom", "amplitude": "15 mrad", "frequency": "0.5 Hz", "begin": "2 s"},
        "speed": {"kind": "constant", "value": "80 km/h"},
    },
    "sweep": {
        "driver": {"kind": "sweep", "amplitude": "10 mrad", "slowest": "0.2 Hz", "fastest": "3 Hz",
                   "duration": "20 s", "begin": "2 s"},
        "speed": {"kind": "constant", "value": "80 km/h"},
    },
    "double_lane_change": {
        "driver": {"kind": "double_lane_change", "amplitude": "18 mrad", "period": "2 s", "pause": "1 s",
                   "every": "8 s", "begin": "2 s"},
        "speed": {"kind": "constant", "value": "80 km/h"},
    },
    "turns": {
        "driver": {"kind": "turns", "amplitude": "15 mrad", "rise": "0.3 s", "hold": "3 s", "rest": "2 s",
                   "begin": "2 s"},
        "speed": {"kind": "constant", "value": "70 km/h"},
    },
    "highway": {
        "driver": {"kind": "highway", "rms": "4 mrad"},
        "speed": {"kind": "constant", "value": "100 km/h"},
    },
    "straight": {
        "driver": {"kind": "highway", "rms": "0.3 mrad"},
        "speed": {"kind": "constant", "value": "110 km/h"},
    },
    "square_closed_loop": {
        "driver": {"kind": "lqr", "weights": [0.03, 5, 0.02, 0.1, 0.001], "effort": 4000,
                   "design_speed": "70 km/h", "limit": "3 deg", "feedback": "sensors", "schedule": "none",
                   "path": {"square": "0.3 m", "period": "10 s"}},
        "speed": {"kind": "constant", "value": "70 km/h"},
    },
}  # fmt: skip
PLANTS: Mapping[str, dict[str, Any]] = {
    "linear": {"kind": "linear"},
    "saturating": {"kind": "saturating", "tyre": "cubic"},
    "two_track": {"kind": "two_track", "tyre": "cubic", "height": "0.55 m", "track": "1.55 m",
                  "front_roll_share": 0.55, "roll_time": "0.15 s", "load_sensitivity": 0.2},
    "multi_body": {"kind": "commonroad", "model": "mb"},
    "drift": {"kind": "commonroad", "model": "std"},
}  # fmt: skip
TABLE_PLANTS = ("linear", "saturating", "multi_body", "drift")
FAULT_PLANTS = ("linear", "two_track")
FAULT_MANOEUVRES = ("slalom", "highway")
SENSORS = {
    "steer": {"quantum": "0.1 mrad"},
    "r": {"noise": "0.15 deg/s", "bias": "0.1 deg/s", "quantum": "0.02 deg/s"},
    "U": {"noise": "0.05 m/s", "quantum": "0.01 m/s"},
    "ay": {"noise": "0.1 m/s^2", "bias": "0.1 m/s^2", "quantum": "0.02 m/s^2"},
    "ay_behind": "1.23 m",  # the vehicle file says 1.20 m, ± 0.05 m
}
CHANGED = {"begin": f"{CHANGE_AT:g} s", "friction": 0.5, "stiffness": 0.5}
LEANING = [{"at": f"{10 * i} s", "angle": f"{3 * (-1) ** i} deg"} for i in range(9)]

# Keys with dots go into the scenario, the others are read by `drawing`.
FAULTS: Mapping[str, dict[str, Any]] = {
    "bias": {"sensors.r.bias": "1 deg/s", "sensors.steer.bias": "3 mrad"},
    "quantised_steer": {"sensors.steer.quantum": "1 mrad"},
    "quantised_gyro": {"sensors.r.quantum": "0.5 deg/s"},
    "lag": {"sensors.r.delay": "40 ms"},
    "missing_samples": {"sensors.r.lost": 0.1, "sensors.r.lost_for": "0.2 s", "sensors.steer.lost": 0.03},
    "bank": {"road.bank": LEANING},
    "wrong_prior": {"K": 2.0, "eta": 1.3},
    "wrong_ratio": {"sensors.steer.scale": 1.08},
    "speed_change": {"speed": {"kind": "sinusoid", "mean": "80 km/h", "amplitude": "25 km/h",
                               "period": "20 s"}},
    "braking_in_turn": {"speed": {"kind": "ramp", "first": "100 km/h", "last": "50 km/h", "begin": "35 s",
                                  "duration": "4 s"}},
    "friction_step": {"road.surface": [{**CHANGED, "friction": 0.3, "stiffness": 0.3}]},
    "peak_only_step": {"road.surface": [{"begin": CHANGED["begin"], "friction": 0.5}]},
    "split_mu": {"road.surface": [{**CHANGED, "friction": 0.3, "stiffness": 0.3, "side": "left"}]},
    "kerbs": {"road.kerbs": {"every": "10 s", "force": "2 kN", "duration": "60 ms"}},
    "gusts": {"road.gusts": {"force": "400 N", "correlation": "1 s", "ahead": "0.2 m"}},
}  # fmt: skip
NOT_ON_LINEAR = ("peak_only_step", "split_mu")  # it has neither a peak nor sides

QUICK = (
    ("slalom", "linear", "none"),
    ("highway", "linear", "none"),
    ("straight", "linear", "none"),
    ("slalom", "saturating", "none"),
    ("highway", "two_track", "bias"),
    ("highway", "two_track", "gusts"),
)


@dataclass(frozen=True)
class Cell:
    """One cell: a scenario and the seeds it is driven with.

    Parameters
    ----------
    manoeuvre, plant, fault : str   `fault` is "none" in the table of manoeuvres and plants
    seeds : int                     drives
    """

    manoeuvre: str
    plant: str
    fault: str
    seeds: int

    @property
    def name(self) -> str:
        """The cell in three words."""
        return f"{self.manoeuvre}, {self.plant}" + ("" if self.fault == "none" else f", {self.fault}")

    @property
    def is_foreign(self) -> bool:
        """Whether its plant is one that nobody here wrote."""
        return PLANTS[self.plant]["kind"] == "commonroad"

    @property
    def changes(self) -> dict[str, Any]:
        """What a scenario file says, as `read_scenario` takes it, without the car."""
        step = "2 ms" if self.is_foreign else "10 ms"
        said: dict[str, Any] = {
            "run": {"duration": f"{DURATION:g} s", "step": step, "log_rate": "100 Hz"},
            "plant": dict(PLANTS[self.plant]),
            "sensors": {name: dict(x) if isinstance(x, dict) else x for name, x in SENSORS.items()},
            "actuator": {"lag": "15 ms"},
            "road": {"friction": 1.0, "surface": [dict(CHANGED)]},
            **MANOEUVRES[self.manoeuvre],
        }
        fault = FAULTS.get(self.fault, {})
        return said | {key: x for key, x in fault.items() if "." in key or key == "speed"}

    @property
    def car(self) -> dict[str, float]:
        """Factors on the drawn car's K and eta [-]."""
        return {name: FAULTS.get(self.fault, {}).get(name, 1.0) for name in ("K", "eta")}


def cells(*, quick: bool, foreign: bool, part: str = "all") -> list[Cell]:
    """Return the cells of a run, the longest to simulate first.

    Parameters
    ----------
    quick : bool     a few cells and seeds, for a look
    foreign : bool   whether commonroad-vehicle-models is installed
    part : str       "table" (manoeuvres and plants), "faults", or "all"
    """
    if quick:
        return [Cell(*one, QUICK_SEEDS) for one in QUICK]
    table = [(m, p, "none") for p in reversed(TABLE_PLANTS) for m in MANOEUVRES]
    found = [Cell(*one, SEEDS) for one in table]
    found = [Cell(c.manoeuvre, c.plant, "none", FOREIGN_SEEDS) if c.is_foreign else c for c in found]
    faults = [Cell(m, p, f, SEEDS) for f in FAULTS for m in FAULT_MANOEUVRES for p in FAULT_PLANTS]
    found += [c for c in faults if not (c.plant == "linear" and c.fault in NOT_ON_LINEAR)]
    wanted = [c for c in found if part == "all" or (part == "faults") == (c.fault != "none")]
    return sorted((c for c in wanted if foreign or not c.is_foreign), key=lambda c: c.plant != "multi_body")
