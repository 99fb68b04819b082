"""The five systems of the gallery: what is known beforehand, the planned drive, sensor and sample time."""

from functools import lru_cache

import numpy as np

from similitude.any_model.estimator import Estimator, make_estimator
from similitude.systems.shipped import shipped_system


def sines(samples: int, step: float, low: float, high: float, size: float) -> np.ndarray:
    """Six sines between two frequencies [Hz], (samples,)."""
    t = step * np.arange(samples)
    phases = np.random.default_rng(0).uniform(0, 2 * np.pi, 6)
    paces = np.geomspace(low, high, 6)
    return size * np.sum(np.sin(2 * np.pi * np.outer(paces, t) + phases[:, None]), axis=0) / 3


CASES = {
    "overhead_crane": {
        "prior": {"m": "0.2 kg +- 50 %", "b": "0.1 N s/m +- 50 %"},
        "drive": sines(1500, 0.02, 0.1, 1.5, 0.5),
        "step": "20 ms",
        "noise": "2 mm",
    },
    "dc_motor": {
        "prior": {"J": "0.01 kg m^2 +- 50 %", "b": "0.1 N m s/rad +- 30 %"},
        "input": "u",
        "drive": sines(2000, 0.01, 0.05, 3, 5),
        "step": "10 ms",
        "noise": "0.002 rad/s",
    },
    "aircraft_short_period": {
        "prior": {
            "Iy": "3000 slug ft^2 +- 20 %",
            "CLa": "4.44 1/rad +- 20 %",
            "CLde": "0.355 1/rad +- 20 %",
            "Cma": "-0.683 1/rad +- 20 %",
            "Cmq": "-9.96 1/rad +- 20 %",
            "Cmad": "-4.36 1/rad +- 20 %",
            "Cmde": "-0.923 1/rad +- 20 %",
        },
        "drive": sines(3000, 0.02, 0.1, 2, 0.02),
        "step": "20 ms",
        "noise": "0.1 deg/s",
    },
    "quarter_car": {
        "prior": {
            "ms": "290 kg +- 10 %",
            "ks": "16812 N/m +- 20 %",
            "mu": "59 kg +- 10 %",
            "cs": "1000 N s/m +- 30 %",
            "kt": "190000 N/m +- 15 %",
        },
        "drive": sines(3000, 0.005, 0.3, 15, 0.01),
        "step": "5 ms",
        "noise": "0.05 m/s^2",
    },
    "rlc_circuit": {
        "prior": {"R": "280 ohm +- 30 %"},
        "drive": sines(2000, 2e-5, 100, 3000, 10),
        "step": "20 us",
        "noise": "0.1 V",
    },
}


@lru_cache
def made(name: str) -> Estimator:
    """The estimator of a system of the gallery."""
    return make_estimator(shipped_system(name), **CASES[name])
