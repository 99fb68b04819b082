"""What is measured and what must hold: times a sample, ratios inside one run, their bounds.

Invariant: sample counts and rounds stand here and nowhere else; a bound is judged on the ratio of
medians, the ratio of the shortest times stands beside it.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from bench.drives import CAR, NOISE, road_drive, square_drive
from bench.kernels import (
    Kernel,
    generated_kernel,
    population_config,
    reference_paper_kernel,
    regression,
    rls_kernel,
    small_car_config,
)
from bench.model_analysis import REACTIONS, run_analysis, scalings
from bench.pi_theorem import SIZES, actions
from bench.timing import Times, interleave
from bench.whole_process import processes
from similitude.program.library import Library, shipped


@dataclass(frozen=True)
class Counts:
    """How many samples and rounds; the same on every machine."""

    compiled: int = 20_000  # samples of a loop in C
    compiled_rounds: int = 101
    scripted: int = 400  # samples of a loop in Python
    scripted_rounds: int = 15
    log: int = 60_000  # rows of the log: ten minutes at 100 Hz
    processes: int = 9  # rounds; 0 leaves the processes out
    groups: tuple[int, ...] = SIZES  # numbers of variables whose Pi groups are found
    groups_rounds: int = 7
    reactions: int = REACTIONS  # of the chain whose scalings are found
    analyses: int = 5  # rounds of scalings and of the whole analysis; 0 leaves the latter out


QUICK = Counts(1000, 3, 60, 2, 0, 0, (7, 40), 1, 6, 0)
LONGEST_MS = {40: 5.0, 200: 15.0}  # for the Pi groups of so many variables
LONGEST_S = {"scalings": 2.0, "analyze": 3.0}  # of sixty reactions; of the bicycle, process and all


@dataclass(frozen=True)
class Row:
    """One thing that was timed; ``per`` says of what a time in microseconds is."""

    name: str
    per: str
    median_us: float
    least_us: float


@dataclass(frozen=True)
class Bound:
    """A ratio of two rows and what it must not exceed."""

    name: str
    over: str
    under: str
    ratio: float
    ratio_of_least: float
    bound: float

    @property
    def holds(self) -> bool:
        """Whether the ratio of medians is within its bound."""
        return self.ratio <= self.bound


def measure(counts: Counts) -> tuple[list[Row], list[Bound]]:
    """Take every measurement; about a minute with the standard counts."""
    rows, bounds = compiled(counts)
    rows += scripted(counts)
    more, limits = dimensional(counts)
    rows, bounds = rows + more, bounds + limits
    more, limits = structural(counts)
    rows, bounds = rows + more, bounds + limits
    if counts.processes:
        more, bound = whole_process(counts)
        rows += more
        bounds.append(bound)
    return rows, bounds


def compiled(counts: Counts) -> tuple[list[Row], list[Bound]]:
    """The loops in C, and the two bounds on the generated ones."""
    kernels = compiled_kernels(counts.compiled)
    times = interleave({n: k.run for n, k in kernels.items()}, counts.compiled_rounds)
    rows = [_row(name, times[name], counts.compiled) for name in kernels]
    return rows, [
        _bound("population against textbook", "population, generated C", "textbook RLS, C", times, 12.0),
        _bound(
            "saturating tyres against textbook", "the same, saturating tyres", "textbook RLS, C", times, 16.0
        ),
        _bound("paper against hand-written", "paper, generated C", "paper, hand-written C", times, 1.3),
    ]


def compiled_kernels(samples: int) -> dict[str, Kernel]:
    """The loops in C by the names of their rows."""
    road, square = road_drive(samples), square_drive(samples)
    population, paper = shipped("bicycle_population"), shipped("bicycle_paper")
    saturating = shipped("saturating_bicycle_population")
    setting = small_car_config(paper, square)
    return {
        "textbook RLS, C": rls_kernel(*regression(samples)),
        "population, generated C": generated_kernel(population.name, population_config(population), road),
        "the same, saturating tyres": generated_kernel(saturating.name, population_config(saturating), road),
        "paper, hand-written C": reference_paper_kernel(paper, setting, square),
        "paper, generated C": generated_kernel(paper.name, setting, square),
    }


def scripted(counts: Counts) -> list[Row]:
    """The Python twin, and padasip and filterpy where they are installed."""
    actions = scripted_actions(counts.scripted)
    times = interleave(actions, counts.scripted_rounds)
    return [_row(name, times[name], counts.scripted) for name in actions]


def scripted_actions(samples: int) -> dict[str, Callable[[], object]]:
    """The loops in Python by the names of their rows."""
    from bench.python_filters import Ekf, padasip_rls

    rows = road_drive(samples).samples()
    compiled = shipped("bicycle_population")
    twin, config = Library(compiled.name, compiled.layout, None), population_config(compiled)
    phi, y = regression(samples)
    return {
        "padasip RLS, one weight": lambda: padasip_rls(phi, y),
        "filterpy EKF, the same ten states": lambda: Ekf(CAR["L"], NOISE).run(rows),
        "population, Python twin": lambda: twin.run(config, twin.start(config), rows),
    }


def dimensional(counts: Counts) -> tuple[list[Row], list[Bound]]:
    """Pi groups of a few and of many variables by every tool; bounds in milliseconds, not ratios."""
    rows, bounds = [], []
    for size in counts.groups:
        times = interleave(actions(size), counts.groups_rounds)
        named = {f"Pi groups of {size}, {tool}": taken for tool, taken in times.items()}
        rows += [Row(name, "list", 1e6 * t.median, 1e6 * t.least) for name, t in named.items()]
        for tool in ("similitude", "similitude, base given"):
            name, most = f"Pi groups of {size}, {tool}", LONGEST_MS.get(size)
            if most:
                against = Times((most * 1e-3,))
                bounds.append(_bound(f"{name} in {most:g} ms", name, "ms", {**named, "ms": against}, 1.0))
    return rows, bounds


def structural(counts: Counts) -> tuple[list[Row], list[Bound]]:
    """Scalings of a chain of reactions and a whole analysis; bounds in seconds, not ratios."""
    timed = interleave(scalings(counts.reactions), max(counts.analyses, 1), clock=time.perf_counter)
    rows = [Row(name, "system", 1e6 * t.median, 1e6 * t.least) for name, t in timed.items()]
    first = next(iter(timed))
    bounds = [_within(first, timed[first], LONGEST_S["scalings"])]
    if counts.analyses:
        name = "similitude analyze bicycle"
        taken = interleave({name: run_analysis}, counts.analyses, clock=time.perf_counter)[name]
        rows.append(Row(name, "process", 1e6 * taken.median, 1e6 * taken.least))
        bounds.append(_within(name, taken, LONGEST_S["analyze"]))
    return rows, bounds


def _within(name: str, taken: Times, most: float) -> Bound:
    return _bound(f"{name} in {most:g} s", name, "s", {name: taken, "s": Times((most,))}, 1.0)


def whole_process(counts: Counts) -> tuple[list[Row], Bound]:
    """`similitude identify` as a whole process, and its bound."""
    with processes(counts.log) as actions:
        times = interleave(actions, counts.processes, clock=time.perf_counter)
    names = {"imports": "import numpy, pyarrow.parquet, pyplot", "identify": "similitude identify, 10 min"}
    times = {names[key]: value for key, value in times.items()}
    rows = [Row(n, "process", 1e6 * t.median, 1e6 * t.least) for n, t in times.items()]
    return rows, _bound("identify against imports", names["identify"], names["imports"], times, 4.0)


def _row(name: str, times: Times, samples: int) -> Row:
    return Row(name, "sample", 1e6 * times.median / samples, 1e6 * times.least / samples)


def _bound(name: str, over: str, under: str, times: dict[str, Times], bound: float) -> Bound:
    return Bound(
        name,
        over,
        under,
        times[over].median / times[under].median,
        times[over].least / times[under].least,
        bound,
    )
