"""Compares the car's filter built by `reduce` with the one that `identify` runs, on the same simulated cars.

The cars are drawn from the prior of passenger cars; the plant is the exact response of the linear bicycle.
`reduce` chooses the roles of its unknowns and the numbers are those that any model gets; `identify` runs its
own filter, whose tyres saturate far beyond what these cars do. Run as
``python scripts/reduced_car.py [CARS]``.
"""

from __future__ import annotations

import sys
import types
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import similitude
from similitude.any_model.fewest_unknowns import FewestUnknowns
from similitude.any_model.filter_numbers import Doubts, filter_numbers
from similitude.any_model.knowledge import Knowledge
from similitude.any_model.trial import Trial
from similitude.estimators.population_filter import population_filter
from similitude.filter_config import MEASURED_STEER_SD, filter_config
from similitude.output_sensitivity import sampled_response
from similitude.populations.shipped import shipped_population
from similitude.program.c import print_c
from similitude.program.library import Library, assemble, shipped
from similitude.program.python import print_python
from similitude.systems.bicycle import bicycle_reduction

CARS, STEP, SECONDS = 40, 0.01, 60.0  # s
L, U, M = 2.7, 25.0, 1500.0  # m, m/s, kg
NOISE = np.deg2rad(0.15)  # rad/s
REDUCTION = bicycle_reduction()
PRIOR = shipped_population("passenger_cars").prior.of(("K", "pi1", "eta", "rho"))


@dataclass(frozen=True)
class Score:
    """rms of ln K over the last 20 s, share of rows there whose 95 % interval holds the truth."""

    rms: float
    covered: float


def steer_of(rms: float, seed: int) -> NDArray:
    """White noise between 0.15 and 1 Hz, rounded to a steering wheel's 0.1 degrees over 15 [rad]."""
    from scipy.signal import butter, lfilter

    rng = np.random.default_rng(seed)
    n = int(SECONDS / STEP)
    raw = lfilter(*butter(2, (0.15, 1.0), "bandpass", fs=1 / STEP), rng.standard_normal(n + 1000))[1000:]
    unit = np.deg2rad(0.1) / 15
    return np.round(rms * raw / raw.std() / unit) * unit


def reduced_filter(steer: NDArray) -> tuple[Library, NDArray]:
    """The filter of what `reduce` chose along the steer, with the numbers any model gets."""
    scales = {"m": M, "L": L, "U": U}
    reduced = similitude.reduce(REDUCTION, PRIOR, steer, STEP, noise=NOISE, scales=scales)
    program = population_filter(reduced.reduction, warming=True)
    layout = types.ModuleType(program.name)
    exec(compile(print_python(program), program.name, "exec"), layout.__dict__)
    library = assemble(layout, print_c(program))
    names = tuple(one.name for one in reduced.reduction.unknowns)
    own = PRIOR.of(names)
    response = sampled_response(REDUCTION, scales, steer, STEP)
    r = response(dict(zip(PRIOR.names, PRIOR.mean, strict=True)))
    known = Knowledge((), np.empty(0), np.empty(0), np.empty((0, 0)), {})
    fewest = FewestUnknowns(
        reduced.reduction,
        own,
        {"L": L, "v_unit": U, "r_unit": U / L},
        {"U": U},
        np.empty((len(names), 0)),
        known,
        ("m", "L", "U"),
        (),
    )
    trial = Trial(steer, STEP, np.column_stack([0.5 * r, r]), r, np.zeros((1, len(names))), 0.3)
    doubts = Doubts(NOISE, input_error=MEASURED_STEER_SD, input_offset=1e-4)
    return library, filter_numbers(library, fewest, own, trial, doubts)[0]


def identify_filter() -> tuple[Library, NDArray]:
    """The filter that `identify` runs, with its own numbers."""
    library = shipped("saturating_bicycle_population")
    config = filter_config(library, PRIOR, L=L, noise_std=NOISE, input_scale_sd=MEASURED_STEER_SD)
    return library, config


def compare(rms: float, cars: int = CARS) -> dict[str, Score]:
    """Both filters over the same cars.

    Parameters
    ----------
    rms : of the steer angle [rad].    cars : how many.
    """
    rng = np.random.default_rng(20)
    root = np.linalg.cholesky(PRIOR.covariance)
    drawn = [PRIOR.values(PRIOR.coordinates(PRIOR.mean) + root @ rng.standard_normal(4)) for _ in range(cars)]
    filters = {"identify": identify_filter(), "reduce": reduced_filter(steer_of(rms, 999))}
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in filters}
    for k, values in enumerate(drawn):
        steer, truth = steer_of(rms, k), dict(zip(PRIOR.names, values, strict=True))
        t = STEP * np.arange(len(steer))
        own = {name: truth[name] for name in ("K", "pi1", "eta", "rho")}
        scale = 1 + MEASURED_STEER_SD * rng.standard_normal()
        r, _ = similitude.bicycle_response(t, scale * steer, U, L=L, **own)
        measured = r + NOISE * rng.standard_normal(len(r))
        rows = np.column_stack([np.full(len(r), STEP), steer, np.full(len(r), U), measured])
        for name, (library, config) in filters.items():
            outputs, _ = library.run(config, library.start(config), rows)
            last = outputs[-2000:]
            away = np.log(last[:, library.index("output", "estimate")] / truth["K"])
            sd = np.sqrt(last[:, library.index("output", "variance")])
            found[name].append((np.mean(away**2), np.mean(np.abs(away) <= 1.96 * sd)))
    return {
        name: Score(float(np.sqrt(np.mean([e for e, _ in all_]))), float(np.mean([c for _, c in all_])))
        for name, all_ in found.items()
    }


def main() -> None:
    """Print one line a drive."""
    cars = int(sys.argv[1]) if len(sys.argv) > 1 else CARS
    for rms in (0.003, 0.010):
        scores = compare(rms, cars)
        print(
            f"{cars} cars, steer {1000 * rms:g} mrad rms: "
            + "; ".join(
                f"{n}: rms of ln K {s.rms:.4f}, covered {100 * s.covered:.1f} %" for n, s in scores.items()
            )
        )


if __name__ == "__main__":
    main()
