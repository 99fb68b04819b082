"""Prints what the small population filters lose against the full ones (`python scripts/small_filter.py`).

The fleet of tests/montecarlo, 60 cars, once with the stiffness halved after a minute and once with an offset
of the steer (10 mrad), its scale 3 % off, gusts and a gyro's bias; both filters over the same logs. Then 24
cars on the roads of scripts/accelerometer.py, with and without lateral acceleration.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from tests.banked_drive import BEHIND, banked_drive, with_place
from tests.banked_fleet import SETTLED as LATE
from tests.banked_fleet import drawn_car
from tests.montecarlo.experiment import NOISE, drawn_prior, fleet, log_of_car
from tests.montecarlo.test_batch import nuisance_fleet

from similitude.accelerometer import Accelerometer
from similitude.filter_run import LINEAR, POPULATION, WITH_ACCELEROMETER, population_setup
from similitude.program.library import shipped
from similitude.vehicle_prior import vehicle_prior

NAMES = (LINEAR, "bicycle_small_population")
FELT = (POPULATION, NAMES[1], WITH_ACCELEROMETER, "bicycle_with_accelerometer_small_population")
ROADS = {  # sd of bank and gusts [m/s^2], and whether the steer is read 3 % large and 10 mrad off
    "level": (0.0, 0.0, False),
    "banked": (0.3, 0.0, False),
    "gusts": (0.3, 0.1, False),
    "askew": (0.3, 0.1, True),
}
METER_CAR = with_place()
METER, OFF, BANKED = Accelerometer(BEHIND, 0.05, 0.1), 0.03, 24  # m: sd of its place; cars a road
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


def felt(name: str, drives: list) -> tuple[float, float, float]:
    """A road's cars: rms of ln K at the end, share covered after a while, median sd at the end."""
    known = {"L": METER_CAR.L.value, "noise_std": NOISE, "input_scale_sd": 0.02}
    rows = []
    for log, car in drives:
        setup = population_setup(log, vehicle_prior(METER_CAR), **known)
        done = replace(setup, library=shipped(name), accelerometer=METER).run()
        error, sd = np.log(done.output("estimate") / car["K"]), np.sqrt(done.output("variance"))
        covered = (np.abs(error) < 1.96 * sd)[log.t > log.t[0] + LATE]
        rows.append((error[-1] ** 2, np.mean(covered), sd[-1]))
    squares, covered, sd = np.array(rows).T
    return float(np.sqrt(squares.mean())), float(covered.mean()), float(np.median(sd))


def drives_on(bank: float, gust: float, askew: bool, rms: float) -> list:
    """Logs of a minute with lateral acceleration, and the cars behind them."""
    found = []
    for seed in range(BANKED):
        car, place = drawn_car(seed), BEHIND + OFF * np.random.default_rng(seed + 500).standard_normal()
        log, _ = banked_drive(rms=rms, bank=bank, gust=gust, seed=seed, place=place, **car)
        found.append((replace(log, delta=1.03 * log.delta + 0.010) if askew else log, car))
    return found


def banked() -> None:
    """Score the filters without and with an accelerometer on every road."""
    print(f"\n{'road':9} {'filter':45} {'steer':>7} {'rms':>6} {'covered':>9} {'sd':>6}")
    for road, kind in ROADS.items():
        for rms in (3e-3, 8e-3):
            drives = drives_on(*kind, rms)
            for name in FELT:
                error, covered, sd = (100 * x for x in felt(name, drives))
                steer = f"{1000 * rms:2g} mrad"
                print(f"{road:9} {name:45} {steer} {error:4.1f} % {covered:7.1f} % {sd:4.1f} %")


def main() -> None:
    """Score both filters on both fleets at 3 and 10 mrad of steer, then those with an accelerometer."""
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
    banked()


if __name__ == "__main__":
    main()
