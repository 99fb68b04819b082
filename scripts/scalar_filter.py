"""Prints what the filter of one unknown loses against the population filter, in reals and in whole numbers.

The fleets of tests/montecarlo: one whose stiffness is halved after a minute, one with an offset of the steer
(10 mrad), its scale 3 % off, gusts and a gyro's bias; all filters over the same logs.

    python scripts/scalar_filter.py [CARS]
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from tests.montecarlo.experiment import NOISE, drawn_prior, fleet, log_of_car
from tests.montecarlo.test_batch import nuisance_fleet

from similitude.estimators.scalar_design import scalar_config
from similitude.filter_run import LINEAR, population_setup
from similitude.program.library import shipped

CARS, STEP, SETTLED, LAST = 60, 60.0, 10.0, 20.0  # cars, s of the halving, s not judged, s of each window
LAG = 0.030  # s: of the second fleet's steer, told to the population filter


def population(cars, i: int, lag: float) -> tuple[np.ndarray, np.ndarray]:
    """K and the sd of its logarithm at each sample."""
    done = _setup(cars, i, lag).run()
    return done.output("estimate"), np.sqrt(done.output("variance"))


def _setup(cars, i: int, lag: float):
    setup = population_setup(
        log_of_car(cars, i), drawn_prior(), L=cars.L[i], noise_std=NOISE, input_scale_sd=0.02, lag=lag
    )
    return replace(setup, library=shipped(LINEAR))


def scalar(cars, i: int, lag: float) -> tuple[np.ndarray, np.ndarray]:
    """The same of the filter of one unknown, in double."""
    library = shipped("bicycle_scalar_population")
    rows = _setup(cars, i, lag).samples()
    step = float(np.median(rows[:, 0]))
    config = scalar_config(library, drawn_prior(), sample_time=step, L=cars.L[i], noise_std=NOISE)
    outputs, _ = library.run(config, library.start(config), rows)
    return outputs[:, 0], np.sqrt(outputs[:, 1])


def judged(cars, i: int, filtered, lag: float) -> tuple[float, float, float, float]:
    """One car: rms of ln K before and after the halving, share covered, mean sd of ln K."""
    K, sd = filtered(cars, i, lag)
    error, t = np.log(K / cars.K[i]), cars.t
    before, after = (t >= STEP - LAST) & (t < STEP), t > t[-1] - LAST
    seen = t > SETTLED
    rms = [float(np.sqrt(np.mean(error[w] ** 2))) for w in (before, after)]
    return (*rms, float(np.mean((np.abs(error) < 1.96 * sd)[seen])), float(np.mean(sd[seen])))


FILTERS = {"population": population, "scalar": scalar}


def main() -> None:
    """Score the filters on both fleets at 3 and 10 mrad of steer."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else CARS
    print(f"{'fleet':9} {'filter':12} {'steer':>7} {'40-60 s':>8} {'100-120 s':>9} {'covered':>8} {'sd':>6}")
    for steer_rms in (3e-3, 10e-3):
        halved = fleet(2, cars=count, steer_rms=steer_rms)
        rough = nuisance_fleet(32, cars=count, steer_rms=steer_rms)
        steer = f"{1000 * steer_rms:2g} mrad"
        for title, cars, lag in (("halved", halved, 0.0), ("nuisance", rough, LAG)):
            for name, filtered in FILTERS.items():
                rows = np.array([judged(cars, i, filtered, lag) for i in range(count)])
                before, after = np.median(rows[:, :2], axis=0)
                covered, sd = np.mean(rows[:, 2:], axis=0)
                print(
                    f"{title:9} {name:12} {steer} {100 * before:6.1f} % {100 * after:7.1f} % "
                    f"{100 * covered:6.1f} % {100 * sd:4.1f} %",
                    flush=True,
                )


if __name__ == "__main__":
    main()
