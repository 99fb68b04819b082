"""A fourth-order high-pass as differences: fewer operations than two biquads, and no large numbers in it.

All four zeros of the paper's high-pass lie at z = 1 (nothing passes at rest). So each section is a second
difference followed by two poles, and remembers what comes out and its last change:

    change <- [second difference of what comes in] - c out + a2 change,    out <- out + change,
    c = 1 + a1 + a2

The next section needs the second difference of out: the change of the change, one subtraction. What the
regression needs, first and second difference of the last section, is there too. Nothing is multiplied by the
sections' gain b0, so the newest sample enters the last second difference with weight one. c is small and
given as such: formed of a1 and a2 in single precision it would lose its digits at high rates.

Invariant: memory holds sums and differences of what is near the signal's size; constants leave none.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.held_sample import S
from similitude.program.ir import Assign, Field

SECTIONS = 2
POLES = ("c", "a2")  # order of a section's numbers


def poles_fields() -> tuple[Field, ...]:
    """Configuration of the sections: two numbers each."""
    words = ("first", "second")
    return tuple(
        Field(f"poles_{k}", "-", f"{word} section of the high-pass: 1 + a1 + a2, a2", len(POLES))
        for k, word in enumerate(words, start=1)
    )


def section_fields(signal: str, unit: str) -> tuple[Field, ...]:
    """Memory of one signal: its last usable value, and each section's."""
    words = ("first", "second")
    return (
        Field(f"last_{_held(signal)}", unit, f"last usable {signal}"),
        Field(f"{signal}_change", unit, "its last change"),
        *(
            field
            for k, word in enumerate(words, start=1)
            for field in (
                Field(f"{signal}_{k}", unit, f"what the {word} section holds of it"),
                Field(f"{signal}_{k}_change", unit, "its last change"),
            )
        ),
    )


def _held(signal: str) -> str:
    return {"input": "input", "output": "measured"}[signal]


def sections(change: sp.Symbol, signal: str) -> list[Assign]:
    """Both sections of one signal whose change since the last sample is ``change``.

    Leaves ``<signal>_2_now``, the new change of the last section, and ``<signal>_2_change`` the old one;
    `moved_on` ends the sample.
    """
    second = S(f"{signal}_bend")
    lines = [
        Assign(second.name, change - S(f"{signal}_change"), "second difference"),
        Assign(f"{signal}_change", change),
    ]
    for k in range(1, SECTIONS + 1):
        held, old, now = (S(f"{signal}_{k}{end}") for end in ("", "_change", "_now"))
        c, a2 = S(f"poles_{k}_0"), S(f"poles_{k}_1")
        lines.append(Assign(now.name, second + a2 * old - c * held))
        if k < SECTIONS:
            second = S(f"{signal}_bend_{k}")
            lines += [
                Assign(second.name, now - old),
                Assign(held.name, held + now),
                Assign(old.name, now),
            ]
    return lines


def moved_on(signal: str) -> list[Assign]:
    """The last section's memory of the sample that `sections` took in."""
    held, old, now = (S(f"{signal}_{SECTIONS}{end}") for end in ("", "_change", "_now"))
    return [Assign(held.name, held + now), Assign(old.name, now)]
