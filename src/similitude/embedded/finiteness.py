"""A program for Frama-C Eva that shows that a step's numbers stay finite, and the bounds it rests on.

One step is taken from any state within bounds, with a sample of any numbers; afterwards every real of state
and output must be finite, and every state whose bound Eva can carry must be within it again. The bounds of
filter memories cannot be carried by intervals (a stable filter's box is no invariant): they are the l1 norms
of the filter's impulse responses times the gates, which hold for every sequence that the gates let through.

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
FINITE = "finite.c"


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
    constants = dict(zip(library.names("state"), library.layout.init(config.tolist()), strict=True))
    n = dict(zip(library.names("config"), config.tolist(), strict=True))
    speed = _speed(library)
    slowest, fastest, K = n[f"{speed}_least"], n["signal_limit"], n[_named(library, "_limit", "theta")]
    memories, bend = impulse_norms(sections_of(library, config))
    ranges: dict[str, tuple[float, float]] = {}
    for signal, held in (("input", "last_input"), ("output", "last_measured")):
        limit = n[f"{signal}_limit"]
        ranges |= {held: (-limit, limit), f"{signal}_change": (-2 * limit, 2 * limit)}
        for k in (1, 2):
            at, moved = (MARGIN * limit * memories[2 * k - 2 + i] for i in (0, 1))
            ranges |= {f"{signal}_{k}": (-at, at), f"{signal}_{k}_change": (-moved, moved)}
    phi = constants["from_input"] * ranges["input_2_change"][1]
    phi += constants["from_output"] / slowest * ranges["output_2_change"][1]
    residual = MARGIN * bend * n["output_limit"] + phi * K
    kept = 1.0 / (1.0 - n["forgetting"])
    prior = n["normal_start"] / (n["L"] * np.array([fastest, slowest])) ** 2
    gained = (phi * K) ** 2 / n["noise_variance"]
    ranges |= {
        "theta": (-K, K),
        "normal": (0.5 * min(n["normal_least"], prior[0]), 2 * max(kept * phi**2, prior[1])),
        "mean_square": (0.0, 1.1 * residual**2),
        "weight": (0.0, 1.1 * kept),
        "information": (0.0, GROWN * 2.0 ** math.ceil(math.log2(gained) + 1)),
        "log_variance": (0.0, n["variance_limit"]),
        f"last_{speed}": (slowest, fastest),
        "wait": (-0.5, n["settle_samples"] + 1),
    }
    rests = {
        "mean_square",
        *(s for s in ranges if s[-2:] in ("_1", "_2") or s.endswith(("_1_change", "_2_change"))),
    }
    return Bounds(ranges, frozenset(set(ranges) - rests))


def _speed(library: Library) -> str:
    return library.names("sample")[2]


def _named(library: Library, end: str, state: str) -> str:
    """The configuration field with that ending whose unit is that of a state."""
    unit = next(row[1] for row in library.layout.STATE if row[0] == state)
    return next(row[0] for row in library.layout.CONFIG if row[0].endswith(end) and row[1] == unit)


_MAIN = """\
/* One step of {name} from any state within its bounds, for Frama-C Eva (25.0):
 *
 *   frama-c -eva -eva-precision {precision} -warn-special-float non-finite \\
 *           -cpp-extra-args=-DSIMILITUDE_CONTRACT_OFF -cpp-extra-args=-DGATED {file} {name}.c
 *
 * shows that no operation overflows or has no result, whatever the sample within the gates; with
 * -warn-special-float none and without -DGATED that what comes out is finite, whatever numbers the
 * sample holds. No alarm and no assertion that is unknown is the proof. Bounds of filter memories are l1
 * norms of impulse responses times the gates, times {margin:g}. */

#include <__fc_builtin.h>
#include "{name}_config.h"

#define ANY Frama_C_float_interval(-3.4028234e38f, 3.4028234e38f)

int main(void)
{{
    {name}_state state;
    {name}_sample sample;
    {name}_output output;
    {name}_init(&{name}_numbers, &state);
{states}
#if defined(GATED)
{within}
#else
{samples}
#endif
    (void){name}_step(&{name}_numbers, &state, &sample, &output);
{asserts}
    return 0;
}}
"""


def finite_text(library: Library, config: NDArray, estimator: str, *, precision: int = 5) -> str:
    """The C program that Eva is given beside an exported estimator.

    Parameters
    ----------
    config : the flat configuration, of which the gates and filters are read.
    estimator : one of ``BOUNDS``.
    """
    bounds = BOUNDS[estimator](library, config)
    names = {"state": _elements(library, "state"), "output": _elements(library, "output")}
    states = [
        f"    state.{names['state'][n]} = Frama_C_float_interval({_number(low)}, {_number(high)});"
        for n, (low, high) in bounds.ranges.items()
    ]
    asserts = [f"    //@ assert output: \\is_finite(output.{text});" for text in names["output"].values()]
    asserts += [f"    //@ assert state: \\is_finite(state.{text});" for text in names["state"].values()]
    asserts += [
        f"    //@ assert bound: {_number(low)} <= state.{names['state'][n]} <= {_number(high)};"
        for n, (low, high) in bounds.ranges.items()
        if n in bounds.carried
    ]
    return _MAIN.format(
        name=library.name,
        file=FINITE,
        precision=precision,
        margin=MARGIN,
        states="\n".join(states),
        within="\n".join(
            f"    sample.{f} = Frama_C_float_interval({_number(low)}, {_number(high)});"
            for f, (low, high) in _gates(library, config).items()
        ),
        samples="\n".join(f"    sample.{f} = ANY;" for f in library.names("sample")),
        asserts="\n".join(asserts),
    )


def _elements(library: Library, struct: str) -> dict[str, str]:
    rows = getattr(library.layout, struct.upper())
    return {
        (name if size == 1 else f"{name}_{i}"): (name if size == 1 else f"{name}[{i}]")
        for name, _, _, size in rows
        for i in range(size)
    }


def _gates(library: Library, config: NDArray) -> dict[str, tuple[float, float]]:
    def limit(name: str) -> tuple[float, float]:
        value = float(config[library.index("config", f"{name}_limit")])
        return -value, value

    dt, driven, speed, measured = library.names("sample")
    longest = float(config[library.index("config", "dt_high")])
    return {dt: (0.0, longest), driven: limit("input"), speed: limit("signal"), measured: limit("output")}


def _number(value: float) -> str:
    """A literal in single precision; rounding is far below the margins."""
    return f"{float(value):.9g}" + ("" if "." in f"{value:.9g}" or "e" in f"{value:.9g}" else ".0") + "f"


BOUNDS = {"paper": paper_bounds}  # estimator -> bounds of its state
