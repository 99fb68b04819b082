"""The fixed-point profile of an estimator: its numbers, its ranges, and the step lowered to integers.

Invariant: the formats follow from the numbers; another number may mean other formats, so they are not
changed in the firmware but exported again.
"""

from __future__ import annotations

import difflib
import math
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.configuration import Numbers, find_numbers, reference_car
from similitude.embedded.system import Source, find_reduction, find_source
from similitude.errors import UsageError
from similitude.estimators.band import band_regression
from similitude.estimators.filter_fields import Layout
from similitude.estimators.fixed_ranges import (
    DERIVED,
    Names,
    as_stated,
    band_derived,
    band_ranges,
    paper_derived,
    paper_ranges,
    scalar_ranges,
)
from similitude.estimators.ladder_design import LIMIT_SD, ROOM, SLOW_PI3
from similitude.estimators.paper_design import PAPER_GROUPS, bessel_biquads
from similitude.estimators.paper_sums import paper_sums
from similitude.estimators.scalar_population import scalar_population_filter
from similitude.program.c import print_c
from similitude.program.fixed.bounds import Ranges
from similitude.program.fixed.c import print_fixed_c
from similitude.program.fixed.lower import FixedProgram, lower
from similitude.program.fixed.python import print_fixed_python
from similitude.program.ir import Program
from similitude.program.python import print_python
from similitude.vehicle_file import read_vehicle
from similitude.vehicle_prior import vehicle_prior

FIXED = ("paper", "band", "scalar_population")
READ = 'docs/embedded.md, "Fixed point"'


@dataclass(frozen=True, eq=False)
class Profile:
    """An estimator in fixed point beside the same step in reals.

    ``source`` C and twin in integers, ``numbers`` what binds them to their configuration; ``plain`` the
    step in reals and ``config`` its flat configuration (n,), both of the same numbers.
    """

    fixed: FixedProgram
    source: Source
    numbers: Numbers
    plain: Source
    config: NDArray[np.float64]


def fixed_profile(
    system: str, estimator: str | None, *, vehicle: Path | None = None, sample_time: float | None = None
) -> Profile:
    """Lower an estimator to fixed point.

    Parameters
    ----------
    system, estimator, vehicle, sample_time : as `similitude.embedded.folder.export` takes them.

    Raises
    ------
    UsageError    the estimator has no fixed-point profile, or its numbers cannot be found.
    ProgramError  a variable has no bound.
    """
    if estimator not in FIXED:
        near = difflib.get_close_matches(str(estimator), FIXED, n=1, cutoff=0.3)
        raise UsageError(
            f"--estimator '{estimator}' has no fixed-point profile; there are {', '.join(FIXED)}",
            usually="a filter with a covariance was meant: its variances span more than an integer does.",
            paste=f"--estimator {near[0] if near else FIXED[0]} --real fixed",
            read=READ,
        )
    reduction = find_reduction(system)
    program = _program(estimator, reduction)
    plain = Source(program.name, estimator, print_c(program), print_python(program), system)
    names = Names(reduction.unknowns[0].name, Layout(reduction).signals[0].name)
    if system.endswith(".py"):
        told, numbers = _users(plain, vehicle, sample_time)
    else:
        told, numbers = _cars(estimator, find_source(system, estimator), vehicle, sample_time)
    named = DERIVE[estimator](program, told, names)
    if "forgetting" in named:
        k = round(-math.log2(1 - named["forgetting"]))
        kept = (named["forgetting"], "-", f"1 - 2^-{k}, nearest to the {told['forgetting']:.9g} stated")
        numbers = replace(numbers, assumed={**numbers.assumed, "forgetting": kept})
    return made_profile(program, plain, named, RANGES[estimator](program, named, names), numbers)


def made_profile(
    program: Program, plain: Source, named: Mapping[str, float], ranges: Ranges, numbers: Numbers
) -> Profile:
    """The profile of a program at given numbers, by name of each real."""
    fixed = lower(program, named, ranges)
    config = np.array([named[s.name] for f in program.config for s in f.symbols])
    told = repr([(f.name, f.format) for f in fixed.state]) + repr(sorted(named.items()))
    crc = zlib.crc32(told.encode())
    source = replace(plain, c=print_fixed_c(fixed), twin=print_fixed_python(fixed))
    return Profile(fixed, source, replace(numbers, values=np.array([crc - 2**31])), plain, config)


def _program(estimator: str, reduction: Any) -> Program:
    """The step that is lowered: of the ladder the one that reals have, of the paper the one in sums."""
    made = MAKE[estimator](reduction)
    return made if made.name.endswith("_fixed") else replace(made, name=f"{made.name}_fixed")


MAKE = {"paper": paper_sums, "band": band_regression, "scalar_population": scalar_population_filter}
DERIVE = {"paper": paper_derived, "band": band_derived, "scalar_population": as_stated}
RANGES = {"paper": paper_ranges, "band": band_ranges, "scalar_population": scalar_ranges}
OPEN = {"paper": DERIVED, "band": (), "scalar_population": ()}  # numbers that follow from the others


def _users(
    plain: Source, vehicle: Path | None, sample_time: float | None
) -> tuple[dict[str, float], Numbers]:
    """Numbers that a user's file states, those that follow from them still open."""
    stated = find_source(plain.system, plain.estimator).stated or {}
    filled = {**dict.fromkeys(OPEN[plain.estimator], 0.0), **stated}
    numbers = find_numbers(replace(plain, stated=filled), vehicle=vehicle, sample_time=sample_time)
    return dict(zip(plain.library().names("config"), numbers.values.tolist(), strict=True)), numbers


def _cars(
    estimator: str, source: Source, vehicle: Path | None, sample_time: float | None
) -> tuple[dict[str, float], Numbers]:
    """Numbers of the float profile with gates as narrow as a car allows, and what the population says of K.

    The tyres show below a pi3 of ten, and hold one and a half g.
    """
    numbers = find_numbers(source, vehicle=vehicle, sample_time=sample_time)
    named = dict(zip(source.library().names("config"), numbers.values.tolist(), strict=True))
    car = read_vehicle(vehicle) if vehicle is not None else reference_car()
    prior = vehicle_prior(car)
    K, width = float(prior.mean[0]), LIMIT_SD * math.hypot(prior.std[0], ROOM)
    low, high = K * math.exp(-width), K * math.exp(width)
    least = max(named["U_least"], math.sqrt(K / SLOW_PI3))
    named |= {"U_least": least, "output_limit": min(named["output_limit"], LATERAL / least)}
    assumed = {
        "K_low": (low, "m^2/s^2", "least of the population"),
        "K_high": (high, "m^2/s^2", "greatest of the population"),
        "U_least": (named["U_least"], "m/s", "pi3 of ten at the population's K"),
        "output_limit": (named["output_limit"], "rad/s", "1.5 g at that speed"),
    }
    if estimator == "paper":
        named = named_for_sums(named, L=car.L.value)
        named |= {"K_start": K, "K_low": low, "K_limit": K_ROOM * high}
    return named, replace(numbers, assumed={**numbers.assumed, **assumed})


def named_for_sums(named: Mapping[str, float], *, L: float) -> dict[str, float]:
    """What the paper's regression in sums takes of that in reals, by name; limits of K stay to be stated.

    Parameters
    ----------
    named : configuration of the regression in reals. L : wheelbase [m].
    """
    alone = ("theta_", "normal_", "poles_", "input_ratio", "K_per_theta")
    taken = {n: x for n, x in named.items() if not n.startswith(alone)}
    step, room = taken["sample_time"], taken.pop("dt_room")
    taken |= {"dt_low": step - room, "dt_high": step + room, "L": L, **PAPER_GROUPS}
    taken["settle_samples"] -= 1.0
    for k, row in enumerate(bessel_biquads(step).tolist(), start=1):
        taken |= {f"biquad_{k}_{i}": x for i, x in enumerate(row)}
    return taken


K_ROOM = 8.0  # times the greatest K of the population: what a biased regression may read
LATERAL = 1.5 * 9.80665  # m/s^2: no car on tyres corners harder
