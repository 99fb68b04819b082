"""A program for Frama-C Eva that shows that a step's numbers stay finite.

One step is taken from any state within bounds, with a sample of any numbers; afterwards every real of state
and output must be finite, and every state whose bound Eva can carry must be within it again.
"""

from __future__ import annotations

from numpy.typing import NDArray

from similitude.embedded.state_bounds import MARGIN, Bounds
from similitude.embedded.texts import step_end
from similitude.program.library import Library

FINITE = "finite.c"
ADVANCES = 1e6  # s: a step that is longer is no time at all

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
    (void){name}_step(&{name}_numbers, &state, &sample{step_end}
{asserts}
    return 0;
}}
"""


def finite_text(library: Library, config: NDArray, bounds: Bounds, *, precision: int = 5) -> str:
    """The C program that Eva is given beside an exported estimator.

    Parameters
    ----------
    config : the flat configuration, of which the gates are read.
    bounds : of the state, of `similitude.embedded.state_bounds`.
    """
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
        step_end=step_end(library),
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
    asked = "dt_high" in library.names("config")
    longest = float(config[library.index("config", "dt_high")]) if asked else ADVANCES
    return {dt: (0.0, longest), driven: limit("input"), speed: limit("signal"), measured: limit("output")}


def _number(value: float) -> str:
    """A literal in single precision; rounding is far below the margins."""
    return f"{float(value):.9g}" + ("" if "." in f"{value:.9g}" or "e" in f"{value:.9g}" else ".0") + "f"
