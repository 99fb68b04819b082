"""Bounds of a regression's state that hold for every sequence of samples which the gates let through.

What a step keeps by itself (a sum with forgetting, a clamp, a gate) Eva finds again. The memories of
filters it cannot (a stable filter's box is no invariant): they are within the l1 norm of the impulse response
times the gate. Nor a mean square, which is an average of what was seen, nor the sums of a block, which has
at most so many samples.

Invariant: bounds are computed from the numbers that are exported, none is written by hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.embedded.guard import sections_of
from similitude.program.library import Library

MARGIN = 2.0  # on l1 norms: rounding in the filter, and single precision's own of the bound
DECAYED, QUIET = 1e-12, 8  # of an impulse response: below this share of its sum, that many samples in a row
GROWN = 2.0**25  # increments after which a sum in single precision has stopped growing
LOST = 2.0**24  # in single precision, one taken from minus this much is lost
ONE = 1.0 - 2.0**-20  # forgetting and adding one leaves at least one, but for rounding
ROOM = 1.1  # on what is a mean or a sum of bounded terms: its rounding


@dataclass(frozen=True)
class Bounds:
    """Ranges of the state by name of each real; of them, those that Eva is asked to find again."""

    ranges: dict[str, tuple[float, float]]
    carried: frozenset[str]


def impulse_norms(sections: NDArray) -> tuple[list[float], float]:
    """Greatest magnitude of every memory, and of the output, per magnitude of what goes in.

    Parameters
    ----------
    sections : (k, 5) biquads in transposed direct form two, or (k, 2) of `high_pass_section`.

    Returns
    -------
    memories, output : l1 norms of the impulse responses; of the form as differences, for each section what it
        holds and its change, and for the output the second difference.
    """
    step = _biquads if sections.shape[1] == 5 else _bends
    memory, sums, out_sum = np.zeros(2 * len(sections)), np.zeros(2 * len(sections)), 0.0
    inputs = iter((1.0,) if sections.shape[1] == 5 else (1.0, -2.0, 1.0))
    quiet = 0
    while quiet < QUIET:
        memory, out = step(sections, memory, next(inputs, 0.0))
        sums += abs(memory)
        out_sum += abs(out)
        quiet = quiet + 1 if max(abs(memory).max(), abs(out)) < DECAYED * out_sum else 0
    return sums.tolist(), out_sum


def _biquads(sections: NDArray, memory: NDArray, x: float) -> tuple[NDArray, float]:
    after = memory.copy()
    for k, (b0, b1, b2, a1, a2) in enumerate(sections):
        y = b0 * x + memory[2 * k]
        after[2 * k], after[2 * k + 1] = b1 * x - a1 * y + memory[2 * k + 1], b2 * x - a2 * y
        x = y
    return after, x


def _bends(sections: NDArray, memory: NDArray, bend: float) -> tuple[NDArray, float]:
    after = memory.copy()
    for k, (c, a2) in enumerate(sections):
        held, change = memory[2 * k : 2 * k + 2]
        now = bend + a2 * change - c * held
        after[2 * k], after[2 * k + 1] = held + now, now
        bend = now - change
    return after, bend


def paper_bounds(library: Library, config: NDArray) -> Bounds:
    """Bounds of the paper's regression."""
    n = dict(zip(library.names("config"), config.tolist(), strict=True))
    speed = _speed(library)
    slowest, fastest, theta = n[f"{speed}_least"], n["signal_limit"], n["theta_limit"]
    memories, bend = impulse_norms(sections_of(library, config))
    ranges: dict[str, tuple[float, float]] = {}
    for signal, held in (("input", "last_input"), ("output", "last_measured")):
        limit = n[f"{signal}_limit"]
        ranges |= {held: (-limit, limit), f"{signal}_change": (-2 * limit, 2 * limit)}
        for k in (1, 2):
            at, moved = (MARGIN * limit * memories[2 * k - 2 + i] for i in (0, 1))
            ranges |= {f"{signal}_{k}": (-at, at), f"{signal}_{k}_change": (-moved, moved)}
    phi = n["input_ratio"] * ranges["input_2_change"][1] + ranges["output_2_change"][1] / slowest
    residual = MARGIN * bend * n["output_limit"] + phi * theta
    kept = 1.0 / (1.0 - n["forgetting"])
    start, spread = n["normal_start"], n["noise_variance"]
    ranges |= {
        "theta": (-theta, theta),
        "normal": (0.5 * min(kept * n["normal_least"], start), 2 * max(kept * phi**2, start)),
        "square_sum": (0.0, 2 * max(kept * residual**2, spread)),
        "weight": (ONE, ROOM * kept),
        f"last_{speed}": (slowest, fastest),
        "wait": (-LOST, n["settle_samples"]),
        "residual": (-residual, residual),
    }
    rests = {
        "residual",
        *(s for s in ranges if s[-2:] in ("_1", "_2") or s.endswith(("_1_change", "_2_change"))),
    }
    return Bounds(ranges, frozenset(set(ranges) - rests))


def band_bounds(library: Library, config: NDArray) -> Bounds:
    """Bounds of the regression in a band."""
    constants = dict(zip(library.names("state"), library.layout.init(config.tolist()), strict=True))
    n = dict(zip(library.names("config"), config.tolist(), strict=True))
    speed, target = _speed(library), library.names("state")[0]
    slowest, fastest = n[f"{speed}_least"], n["signal_limit"]
    low, high = n[f"{target}_low"], n[f"{target}_high"]
    sections = sections_of(library, config)
    memories, out = impulse_norms(sections)
    ranges: dict[str, tuple[float, float]] = {target: (low, high)}
    before, widest = {}, {}  # greatest filtered signal; what intervals make of it within a step
    for signal, held in (("input", "last_input"), ("output", "last_measured")):
        limit = n[f"{signal}_limit"]
        within = [MARGIN * limit * norm for norm in memories]
        ranges |= {held: (-limit, limit)}
        ranges |= {f"{signal}_memory_{i}": (-at, at) for i, at in enumerate(within)}
        before[signal] = MARGIN * limit * out
        ranges[f"{signal}_before"] = (-before[signal], before[signal])
        widest[signal] = limit
        for k, section in enumerate(sections):
            widest[signal] = within[2 * k] + abs(section[0]) * widest[signal]
    from_input = abs(constants["input_gain"]) / n["L"] ** 2
    from_output = abs(constants["damping"]) / (n["L"] * slowest)
    psi = from_input * before["input"] + from_output * before["output"]
    y = widest["output"] + before["output"]
    residual, drive = y + high * psi, high * from_input * before["input"]
    kept, own = 1.0 / (1.0 - n["forgetting"]), n["noise_variance"] * from_output
    with_y = own * abs(n["noise_zero"] - n["noise_one"])
    samples = n["block"] / n["dt_low"] + 2.0
    score, weight = ROOM * samples * psi * residual, ROOM * samples * psi**2
    blocks = 2.0 / (1.0 - n["block_keep"])
    told = (high * psi) ** 2 / n["scatter_low"]
    sum_y = 2.0 * kept * (psi * y + with_y)
    rests = {
        "excitation": (0.0, ROOM * drive**2),
        "mean_square": (0.0, ROOM * residual**2),
        "block_score": (-score, score),
        "block_weight": (0.0, weight),
    }
    carried = {
        "Q": (-sum_y, sum_y),
        "A": (-2.0 * kept * own * from_output * n["noise_zero"], 2.0 * kept * psi**2),
        "block_age": (0.0, n["block"]),
        "scatter_sum": (0.0, blocks * (score + psi * residual) ** 2),
        "scatter_weight": (0.0, blocks * (weight + psi**2)),
        "blocks": (-1.0, ROOM * n["blocks_most"]),  # intervals round a minimum up
        "log_variance": (0.0, MARGIN * n["variance_limit"]),
        "aged": (0.0, MARGIN * n["variance_limit"]),
        "information": (0.0, GROWN * 2.0 ** math.ceil(math.log2(told) + 1)),
        f"last_{speed}": (slowest, fastest),
        "fresh": (0.0, n["settle_samples"] + 1),
        "started": (0.0, 1.0),
    }
    filtered = {name for name in ranges if "_memory_" in name or name.endswith("_before")}
    return Bounds({**ranges, **rests, **carried}, frozenset({*ranges, *carried} - filtered))


def _speed(library: Library) -> str:
    return library.names("sample")[2]


BOUNDS = {"paper": paper_bounds, "band": band_bounds}  # estimator -> bounds of its state
