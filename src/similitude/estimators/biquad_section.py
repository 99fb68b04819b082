"""Second-order filter sections as statements: the paper's high-pass and the ladder's band-pass.

Invariant: a section is direct form II transposed; two sections make a fourth-order filter, always
(a single fourth-order section is unstable in single precision below 0.2 Hz at 100 Hz).
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.estimators.held_sample import S
from similitude.program.ir import Assign, Field

BIQUAD = ("b0", "b1", "b2", "a1", "a2")  # order of a section's numbers, a0 = 1


def section(x: sp.Symbol, number: int, signal: str, name: str) -> list[Assign]:
    """One section; its output is the temporary ``name``, its numbers are ``biquad_<number>``.

    Parameters
    ----------
    x : what goes in.
    number : of the section, from 1; its memory is ``<signal>_memory_<2 number - 2>`` and the next.
    signal : whose memory is used.
    name : of the temporary that holds what comes out.
    """
    b0, b1, b2, a1, a2 = (S(f"biquad_{number}_{i}") for i in range(len(BIQUAD)))
    first, second = (f"{signal}_memory_{2 * number - 2 + i}" for i in range(2))
    return [
        Assign(name, b0 * x + S(first)),
        Assign(first, b1 * x - a1 * S(name) + S(second)),
        Assign(second, b2 * x - a2 * S(name)),
    ]


def cascade(x: sp.Symbol, sections: int, signal: str, name: str) -> list[Assign]:
    """Sections 1 to ``sections`` in a row; the last one's output is the temporary ``name``."""
    lines: list[Assign] = []
    for number in range(1, sections + 1):
        out = name if number == sections else f"{signal}_after_{number}"
        lines += section(x, number, signal, out)
        x = S(out)
    return lines


def biquad_fields(names: Sequence[str]) -> tuple[Field, ...]:
    """Configuration of the sections: five numbers each, named by what they belong to."""
    numbers = ", ".join(BIQUAD)
    return tuple(
        Field(f"biquad_{i}", "-", f"section {i}, {what}: {numbers}", len(BIQUAD))
        for i, what in enumerate(names, start=1)
    )
