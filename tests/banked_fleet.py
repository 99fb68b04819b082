"""A fleet on banked, gusty roads: what an accelerometer aboard adds to the estimate of K."""

from dataclasses import dataclass

import numpy as np

from similitude.identification import identify

from .banked_drive import BEHIND, banked_drive, with_place
from .simulated_drive import vehicle

MEAN = {"K": 145.68, "pi1": 0.4431, "eta": 1.42, "rho": 1.017}  # the population of passenger cars
SPREAD = {"K": 0.2, "eta": 0.13, "rho": 0.09}  # sd of the logarithms over the fleet
PI1_SD = 0.03
SETTLED = 20.0  # s


@dataclass(frozen=True)
class Score:
    """rms of ln K over the cars at the end, median sd it claims there, share of time covered after 20 s."""

    rms: float
    claimed: float
    covered: float


def drawn_car(seed):
    """Parameters of one car of the fleet."""
    rng = np.random.default_rng(seed + 100)
    car = {name: MEAN[name] * np.exp(sd * rng.standard_normal()) for name, sd in SPREAD.items()}
    return {**car, "pi1": MEAN["pi1"] + PI1_SD * rng.standard_normal()}


def banked_scores(*, cars, rms, bank, gust, seconds=60.0, off=0.03):
    """Scores without and with the accelerometer, on the same drives.

    bank, gust : sd [m/s^2].  off : sd of the accelerometer's place about where the file puts it [m].
    """
    rows = {"without": [], "with": []}
    for seed in range(cars):
        car = drawn_car(seed)
        place = BEHIND + off * np.random.default_rng(seed + 500).standard_normal()
        log, _ = banked_drive(seconds=seconds, rms=rms, bank=bank, gust=gust, seed=seed, place=place, **car)
        for name, known in (("without", vehicle()), ("with", with_place())):
            run = identify(log, known)
            late = run.trace.t > run.trace.t[0] + SETTLED
            inside = np.abs(np.log(run.trace.K[late] / car["K"])) < 1.96 * run.trace.ln_K_std[late]
            rows[name].append((np.log(run.K.value / car["K"]), run.trace.ln_K_std[-1], inside.mean()))
    found = {name: np.array(values).T for name, values in rows.items()}
    return {
        name: Score(float(np.sqrt(np.mean(x[0] ** 2))), float(np.median(x[1])), float(x[2].mean()))
        for name, x in found.items()
    }
