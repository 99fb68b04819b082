"""What the numbers of an estimator say about how large its variables can get.

Samples: what the gates let in. Filters: the greatest output and memory of a section over all inputs of that
size is the l1 norm of its impulse response. Unknowns: what the population allows. The rest follows
(`program.fixed.bounds`).

Invariant: every bound is computed from the configuration; none is written down.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from similitude.program.fixed.bounds import MARGIN, Ranges, Span, span, walked
from similitude.program.fixed.lower import settled
from similitude.program.ir import Assign, Program, walk

LONGEST = 60.0  # s between two samples that are told apart; a longer time goes in as this
DECAYED = 1e-12  # of an impulse response's start, where its sum ends
INPUT_RATE = 15.0  # 1/s of the greatest input: 20 rad/s of road wheels, ten times a racing driver's
NO_WEIGHT = 2.0**-40  # of the greatest square: where the sum of squares starts


@dataclass(frozen=True)
class Names:
    """What a model calls its unknown and the scale that is measured along."""

    target: str
    speed: str


def impulse_norms(sections: NDArray[np.float64]) -> tuple[list[float], float]:
    """The l1 norms from the input to each memory of a cascade, and to its output.

    Parameters
    ----------
    sections : (k, 5) numbers b0, b1, b2, a1, a2.

    Returns
    -------
    memories, output : (2 k,) and one number: greatest magnitude per magnitude of the input.
    """
    memory = np.zeros(2 * len(sections))
    sums, out_sum = np.zeros_like(memory), 0.0
    x, quiet = 1.0, 0
    while quiet < 8:
        for k, (b0, b1, b2, a1, a2) in enumerate(np.asarray(sections).tolist()):
            y = b0 * x + memory[2 * k]
            memory[2 * k] = b1 * x - a1 * y + memory[2 * k + 1]
            memory[2 * k + 1] = b2 * x - a2 * y
            x = y
        sums += abs(memory)
        out_sum += abs(x)
        quiet = quiet + 1 if max(abs(memory).max(), abs(x)) < DECAYED * out_sum else 0
        x = 0.0
    return sums.tolist(), out_sum


def sections_of(numbers: Mapping[str, float]) -> NDArray[np.float64]:
    """The biquads of a configuration by name, (k, 5)."""
    count = sum(name.startswith("biquad_") and name.endswith("_0") for name in numbers)
    return np.array([[numbers[f"biquad_{i}_{j}"] for j in range(5)] for i in range(1, count + 1)])


def filter_ranges(numbers: Mapping[str, float]) -> dict[str, Span]:
    """Memories and filtered values of an estimator with biquads for input and output."""
    memories, out = impulse_norms(sections_of(numbers))
    found: dict[str, Span] = {}
    for signal in ("input", "output"):
        limit = MARGIN * numbers[f"{signal}_limit"]
        for k, norm in enumerate(memories):
            found[f"{signal}_memory_{k}"] = (-norm * limit, norm * limit)
        for name in ("before", "before_0", "before_1", "filtered"):
            found[f"{signal}_{name}"] = (-out * limit, out * limit)
    return found


def sample_ranges(numbers: Mapping[str, float], speed: str) -> dict[str, Span]:
    """What the gates let in, and what they remember of it."""
    i, o, s = (numbers[f"{name}_limit"] for name in ("input", "output", "signal"))
    return {
        "dt": (-LONGEST, LONGEST),
        "input": (-i, i),
        speed: (-s, s),
        "measured": (-o, o),
        "last_input": (-i, i),
        "last_measured": (-o, o),
        f"last_{speed}": (numbers[f"{speed}_least"], s),
        "fresh": (0.0, numbers["settle_samples"] + 1),
        "started": (0.0, 1.0),
    }


def nearest_forgetting(forgetting: float) -> tuple[float, int]:
    """The 1 - 2^-k that is nearest in memory, and k."""
    k = max(1, round(-math.log2(1 - forgetting)))
    return 1 - 2.0**-k, k


def regressor_limit(program: Program, numbers: Mapping[str, float], names: Names) -> float:
    """The greatest psi of an input and output that change no faster than anything can steer and turn.

    A filter passes a change on magnified by its l1 norm at most; faster than that is a fault of a sensor.
    """
    norm = impulse_norms(sections_of(numbers))[1]
    fastest = INPUT_RATE * numbers["input_limit"] * numbers["sample_time"]
    change = {"input": fastest, "output": numbers["output_jump"]}
    psi = next(s.expression for s in walk(program.step) if isinstance(s, Assign) and s.target == "psi")
    known = {**_points(numbers), **_slowest(program, numbers, names)}
    slopes = {signal: sp.diff(psi, sp.Symbol(f"{signal}_before_0", real=True)) for signal in change}
    return sum(norm * most * max(map(abs, span(slopes[signal], known))) for signal, most in change.items())


def _points(numbers: Mapping[str, float]) -> dict[str, Span]:
    return {name: (value, value) for name, value in numbers.items()}


def _slowest(program: Program, numbers: Mapping[str, float], names: Names) -> dict[str, Span]:
    """The measured scale and what follows from it where it is least."""
    last = f"last_{names.speed}"
    known = {**_points(numbers), last: (numbers[f"{names.speed}_least"],) * 2}
    star = next(s.expression for s in program.init if isinstance(s, Assign) and s.target == "star")
    return {last: known[last], "star": span(star, known)}


def paper_derived(program: Program, numbers: Mapping[str, float], names: Names) -> dict[str, float]:
    """All numbers of ``paper_fixed`` from those that are judgement: forgetting by a shift, and what follows.

    Parameters
    ----------
    program : Program    of `paper_sums`.
    numbers : its configuration by the name of each real, `DERIVED` not needed.
    """
    forgetting, k = nearest_forgetting(numbers["forgetting"])
    psi = regressor_limit(program, numbers, names)
    derived = {"psi_limit": psi, "updates_most": 2.0**k, "normal_start": NO_WEIGHT * psi**2}
    return {**numbers, **derived, "forgetting": forgetting}


DERIVED = ("psi_limit", "updates_most", "normal_start")


def paper_ranges(program: Program, numbers: Mapping[str, float], names: Names) -> Ranges:
    """Ranges of ``paper_fixed``."""
    limit, updates = numbers[f"{names.target}_limit"], numbers["updates_most"]
    psi = MARGIN * numbers["psi_limit"]
    stated = {
        **sample_ranges(numbers, names.speed),
        **filter_ranges(numbers),
        names.target: (-limit, limit),
        "psi": (-psi, psi),
        "updates": (0.0, updates),
        "span": (1.0, updates),
        "pace": (1 / updates, 1.0),
        **dict.fromkeys(("scatter", "log_variance"), (0.0, numbers["variance_limit"])),
        "raw_spread": (0.0, numbers["output_jump"] ** 2),
    }
    wide = frozenset({"normal", "cross", "mean_square", "rest_square"})
    return Ranges(stated, wide, frozenset({"fresh", "updates", "span"}))


BAND_WIDE = (
    "Q A excitation mean_square block_score block_weight scatter_sum scatter_weight information".split()
)
INFORMATION = 2.0**20  # where the sum of it saturates: an sd of a thousandth
TOLD = 2.0**10  # by one sample, which no sample does: an sd of 3 %


def band_derived(program: Program, numbers: Mapping[str, float], names: Names) -> dict[str, float]:
    """All numbers of ``band`` in fixed point: forgetting by a shift."""
    return {**numbers, "forgetting": nearest_forgetting(numbers["forgetting"])[0]}


def band_ranges(program: Program, numbers: Mapping[str, float], names: Names) -> Ranges:
    """Ranges of ``band``: a block holds so many of the greatest squares, the scatter so many blocks."""
    target, limit = names.target, numbers["variance_limit"]
    heard = 2 * (numbers["noise_zero"] - numbers["noise_one"])  # of white noise, in a filtered difference
    edge = K_EDGE * numbers[f"{target}_high"]
    stated = {
        **sample_ranges(numbers, names.speed),
        **filter_ranges(numbers),
        target: (-edge, edge),
        "log_variance": (0.0, limit),
        "aged": (0.0, limit),
        "blocks": (-1.0, numbers["blocks_most"]),
        "block_age": (0.0, numbers["block"] + numbers["dt_high"]),
        "spread": (0.0, heard * numbers["output_jump"] ** 2),
        "innovation_variance": (0.0, numbers["output_jump"] ** 2),
        "information": (0.0, INFORMATION),
        "told": (0.0, TOLD),
        **dict.fromkeys(("block_score", "block_weight", "scatter_sum", "scatter_weight"), (0.0, 1.0)),
    }
    return Ranges(
        {**stated, **_blocks(program, numbers, stated)},
        frozenset(BAND_WIDE),
        frozenset({"fresh", "blocks"}),
    )


K_EDGE = 2.0  # times the greatest K: what a ratio may say before it is held at the population's edge


def _blocks(program: Program, numbers: Mapping[str, float], stated: Mapping[str, Span]) -> dict[str, Span]:
    constants, _ = settled(program, numbers)
    found = walked(program, {n: float(v) for n, v in constants.items()}, Ranges(stated))
    samples = numbers["block"] / numbers["dt_low"] + 1
    psi = max(map(abs, found["psi"]))
    weight, kept = MARGIN * samples * psi**2, MARGIN / (1 - numbers["block_keep"])
    score = (
        MARGIN * numbers["output_jump"] * math.sqrt(weight)
    )  # residuals no larger than a believable change
    return {
        "block_score": (-score, score),
        "block_weight": (0.0, weight),
        "scatter_sum": (0.0, kept * score**2),
        "scatter_weight": (0.0, kept * weight),
    }


SCALAR_WIDE = frozenset({"mean_square", "excitation", "weighed"})


def as_stated(program: Program, numbers: Mapping[str, float], names: Names) -> dict[str, float]:
    """Numbers of an estimator that needs no others in fixed point."""
    return dict(numbers)


def scalar_ranges(program: Program, numbers: Mapping[str, float], names: Names) -> Ranges:
    """Ranges of ``scalar_population``: a model may turn twice as fast as a car is believed to."""
    turn, jump = K_EDGE * numbers["output_limit"], numbers["output_jump"]
    variance = numbers["start_variance"]
    gain = MARGIN * math.sqrt(variance / numbers["noise_variance"]) / 2  # of p s/(s^2 p + R) over all s
    stated = {
        **sample_ranges(numbers, names.speed),
        names.target: (0.0, K_EDGE * numbers[f"{names.target}_high"]),
        "p": (0.0, variance),
        "gain": (-gain, gain),
        "innovation_variance": (0.0, jump**2),
        **dict.fromkeys(("y", "y_slope"), (-turn, turn)),
    }
    constants, _ = settled(program, numbers)
    found = walked(program, {n: float(v) for n, v in constants.items()}, Ranges(stated))
    rate = turn * max(map(abs, found["a"]))
    stated |= dict.fromkeys(("w", "w_slope"), (-rate, rate))
    return Ranges(stated, SCALAR_WIDE, frozenset({"fresh"}), full=True)
