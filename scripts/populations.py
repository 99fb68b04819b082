"""Measures what docs/populations.md claims of populations and relations (`make populations`).

Planted slope: tables of 150 cars whose pi4 = 1.0977 pi3 holds with 3 % scatter and not at all for a tenth.
Null: 200 tables of independent raw parameters. Coverage: bootstrap intervals against the truth that the
tables were drawn from. Left out: each vehicle of the shipped tables predicted from the others.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import numpy as np
from tests.populations.drawn import axles, independent, planted, table_of

from similitude.populations.building import PI1, PRODUCTS, bundled_population
from similitude.populations.bundled import bundled_tables
from similitude.populations.leave_one_out import leave_one_out
from similitude.populations.population import populate
from similitude.populations.relations import relate
from similitude.populations.table import joined
from similitude.systems.bicycle import bicycle_groups

ROOT = Path(__file__).parents[1]
GROUPS = bicycle_groups()
SLOPE = 1.0977
TABLES, NULLS, COVERED = 200, 200, 100


def main() -> None:
    """Print one line a measurement."""
    for measure in (power, products, nulls, coverage, left_out, groups_that_cluster):
        start = time.process_time()
        for line in measure():
            print(line, flush=True)
        print(f"    ({time.process_time() - start:.0f} s of processor time)", flush=True)


def power() -> list[str]:
    """How often a planted slope is found, and how often its interval holds it."""
    found = held = sole = 0
    error = []
    for seed in range(TABLES):
        relations = relate(populate(GROUPS, table_of(planted(150, seed, slope=SLOPE))))
        one = relations.of("pi3", "pi4")
        if one is None or not one.found:
            continue
        found += 1
        sole += len(relations.discoveries) == 1
        low, high = one.interval
        held += low <= SLOPE <= high
        error.append(one.coefficients["slope"] / SLOPE - 1 if "slope" in one.coefficients else np.nan)
    return [
        f"planted pi4 = {SLOPE} pi3, n = 150, 3 % scatter, 10 % outliers: found in {found} of {TABLES} "
        f"tables, alone in {sole}; its 95 % interval holds it in {held}; rms error of the slope "
        f"{100 * float(np.sqrt(np.nanmean(np.square(error)))):.2f} %"
    ]


def products() -> list[str]:
    """How often eta is found as a product that no pair explains."""
    n, eta = 60, 0
    for seed in range(n):
        relations = relate(populate(GROUPS, table_of(axles(150, seed))))
        eta += {"pi1", "pi2", "pi3", "pi4"} in [set(one.groups) for one in relations.discoveries]
    return [f"planted eta = pi4 pi2/(pi3 pi1) = 1.5, 5 % scatter, n = 150: found in {eta} of {n} tables"]


def nulls() -> list[str]:
    """How often independent raw parameters give any discovery at all."""
    said = []
    for n in (12, 150):
        false = sum(
            len(relate(populate(GROUPS, table_of(independent(n, seed + 1000)))).discoveries) > 0
            for seed in range(NULLS)
        )
        said.append(f"independent raw parameters, n = {n}: {false} of {NULLS} tables with a false discovery")
    return said


def coverage() -> list[str]:
    """How often 95 % bootstrap intervals of mean and sd of ln groups hold the truth."""
    truth = populate(GROUPS, table_of(axles(20_000, 1, scatter=0.1)[:20_000]))
    mean, sd = truth.group_moments[0], np.sqrt(np.diag(truth.group_moments[1]))
    hits = np.zeros((2, len(mean)))
    for seed in range(COVERED):
        values = axles(120, seed + 5000, scatter=0.1)
        values[::3, 4:] = np.nan  # a third does not know its stiffness
        for i, (ends, true) in enumerate(
            zip(populate(GROUPS, table_of(values)).intervals(60), (mean, sd), strict=True)
        ):
            hits[i] += (ends[:, 0] <= true) & (true <= ends[:, 1])
    share = 100 * hits / COVERED
    return [
        f"bootstrap 95 % intervals, n = 120, a third without stiffness: of means {share[0].mean():.0f} % "
        f"hold the truth ({share[0].min():.0f} to {share[0].max():.0f} by group), of sds "
        f"{share[1].mean():.0f} % ({share[1].min():.0f} to {share[1].max():.0f})"
    ]


def left_out() -> list[str]:
    """Every vehicle predicted from the others of its population."""
    tables = bundled_tables(ROOT / "data", GROUPS.model)
    big = joined([tables["passenger_cars"], tables["light_trucks"]], name="all_vehicles")
    said = []
    for name in ("passenger_cars", "light_trucks", "all_vehicles"):
        population = bundled_population(GROUPS, tables.get(name, big))
        result = leave_one_out(population, {"pi1": PI1, **PRODUCTS})
        whole = np.nanmax(np.abs(result.away), axis=1) <= 1.959964
        parts = ", ".join(f"{n} {hit} of {known}" for n, (hit, known) in result.inside.items())
        said.append(
            f"left out, {name}: {100 * result.share:.1f} % of predictions inside 95 % ({parts}); "
            f"{100 * whole.mean():.1f} % of {len(whole)} vehicles with all their groups inside"
        )
    return said


def groups_that_cluster() -> list[str]:
    """What the tables say of pi4/pi3 against eta, and of pi5 against rho."""
    tables = bundled_tables(ROOT / "data", GROUPS.model)
    population = populate(GROUPS, tables["passenger_cars"])
    relations = relate(population)
    logs = population.logs
    k, eta = logs[:, 3] - logs[:, 2], logs[:, 3] - logs[:, 2] + logs[:, 1] - logs[:, 0]
    said = [f"cars that state both axles: sd of ln pi4/pi3 {np.nanstd(k, ddof=1):.3f}, of ln eta "
            f"{np.nanstd(eta, ddof=1):.3f}, n {np.isfinite(eta).sum()}"]  # fmt: skip
    return said + [f"passenger_cars: {one.text}  n {one.n}  out of sample {one.out_of_sample:.3f}"
            f"  p {one.p:.3g}  {'found' if one.found else 'not proven'}"
            f"  95 % {one.interval[0]:.4g} to {one.interval[1]:.4g}"
            for one in (*relations, *relations.candidates)]  # fmt: skip


if __name__ == "__main__":
    main()
