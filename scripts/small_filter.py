"""Prints what the small population filter loses against the full one (`python scripts/small_filter.py`).

The fleet of tests/montecarlo, 60 cars, once with the stiffness halved after a minute and once with an offset
of the steer (10 mrad), its scale 3 % off, gusts and a gyro's bias; both filters over the same logs.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from tests.montecarlo.experiment import NOISE, drawn_prior, fleet, log_of_car
from tests.montecarlo.test_batch import nuisance_fleet

from similitude.filter_run import LINEAR, population_setup
from similitude.program.library import shipped

NAMES = (LINEAR, "bicycle_small_population")
CARS, STEP, SETTLED, LAST = 60, 60.0, 10.0, 20.0  # cars, s of the halving, s not judged, s of each window
LAG = 0.030  # s: of the second fleet's steer, told to both filters


def judged(cars, i: int, name: str, lag: float) -> tuple[float, float, float, float]:
    """One car: rms of ln K before and after the halving, share covered, mean sd of ln K."""
    setup = population_setup(
        log_of_car(cars, i), drawn_prior(), L=cars.L[i], noise_std=NOISE, input_scale_sd=0.02, lag=lag
    )
    done = replace(setup, library=shipped(name)).run()
    error = np.log(done.output("estimate") / cars.K[i])
    sd, t = np.sqrt(done.output("variance")), cars.t
    before, after = (t >= STEP - LAST) & (t < STEP), t > t[-1] - LAST
    seen = t > SETTLED
    rms = [float(np.sqrt(np.mean(error[w] ** 2))) for w in (before, after)]
    return (*rms, float(np.mean((np.abs(error) < 1.96 * sd)[seen])), float(np.mean(sd[seen])))


def main() -> None:
    """Score both filters on both fleets at 3 and 10 mrad of steer."""
    print(f"{'fleet':9} {'filter':25} {'steer':>7} {'40-60 s':>8} {'100-120 s':>9} {'covered':>8} {'sd':>6}")
    for steer_rms in (3e-3, 10e-3):
        halved = fleet(2, cars=CARS, steer_rms=steer_rms)
        rough = nuisance_fleet(32, cars=CARS, steer_rms=steer_rms)
        steer = f"{1000 * steer_rms:2g} mrad"
        for title, cars, lag in (("halved", halved, 0.0), ("nuisance", rough, LAG)):
            for name in NAMES:
                rows = np.array([judged(cars, i, name, lag) for i in range(CARS)])
                before, after = np.median(rows[:, :2], axis=0)
                covered, sd = np.mean(rows[:, 2:], axis=0)
                print(
                    f"{title:9} {name:25} {steer} {100 * before:6.1f} % {100 * after:7.1f} % "
                    f"{100 * covered:6.1f} % {100 * sd:4.1f} %"
                )


if __name__ == "__main__":
    main()
