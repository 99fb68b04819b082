"""One statement of the paper with what this package computes beside it, and what follows.

Invariant: a verdict is never written down; it follows from the computed number, the printed one and
a tolerance, or from conditions that were computed. Values are rounded to digits that do not depend
on the machine.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

HOLDS, CONDITION, FAILS = "holds", "holds with a condition", "does not hold"
VERDICTS = (HOLDS, CONDITION, FAILS)
NOTHING = 1e-9  # an identity in floating point is met to this


@dataclass(frozen=True)
class Claim:
    """A checked statement.

    Parameters
    ----------
    id, where : str          its name, and its place in the paper
    statement : str          what is claimed, in words
    printed, ours            number, list of numbers or text, in ``unit``
    tolerance                number or text: by how much ours may differ from printed
    verdict : str            one of `VERDICTS`
    condition : str          under which it holds, where it holds with one
    why : str                what to know
    """

    id: str
    where: str
    statement: str
    printed: Any
    ours: Any
    tolerance: Any
    verdict: str
    unit: str = "-"
    condition: str = ""
    why: str = ""

    @property
    def record(self) -> dict[str, Any]:
        """The claim as it stands in JSON."""
        return {
            "id": self.id,
            "where": self.where,
            "printed": self.printed,
            "ours": self.ours,
            "verdict": self.verdict,
            "tolerance": self.tolerance,
            "unit": self.unit,
            "statement": self.statement,
            "condition": self.condition,
            "why": self.why,
        }


def claim(
    id: str,
    where: str,
    statement: str,
    *,
    printed: Any,
    ours: Any,
    holds: bool,
    tolerance: Any,
    under: bool | None = None,
    condition: str = "",
    unit: str = "-",
    why: str = "",
    digits: int = 4,
) -> Claim:
    """Make a claim from conditions that were computed.

    Parameters
    ----------
    printed, ours : as printed, as computed; numbers and lists of numbers are rounded.
    holds : whether it holds as printed.
    tolerance : what decided that, a number or words.
    under, condition : whether it holds under the condition named; none was tried when left out.
    digits : significant digits that are kept of ours.
    """
    word = HOLDS if holds else CONDITION if under else FAILS
    said = condition if word == CONDITION else ""
    return Claim(id, where, statement, printed, rounded(ours, digits), tolerance, word, unit, said, why)


def number_claim(
    id: str,
    where: str,
    statement: str,
    *,
    printed: float,
    ours: float,
    tolerance: float,
    conditioned: float | None = None,
    **more: Any,
) -> Claim:
    """Make a claim from two numbers: it holds where they differ by no more than the tolerance.

    Parameters
    ----------
    printed, ours, tolerance : in one unit.
    conditioned : what is computed under the condition named, to be within the tolerance then.
    more : as of `claim`.
    """
    under = None if conditioned is None else abs(conditioned - printed) <= tolerance
    return claim(
        id,
        where,
        statement,
        printed=printed,
        ours=ours,
        holds=abs(ours - printed) <= tolerance,
        under=under,
        tolerance=tolerance,
        **more,
    )


def identity_claim(id: str, where: str, statement: str, residual: float, **more: Any) -> Claim:
    """Make a claim from an identity: the largest relative residual must be rounding and no more.

    Parameters
    ----------
    residual : left side minus right, relative; ours is 0 where it is below `NOTHING`.
    """
    return claim(
        id,
        where,
        statement,
        printed=0,
        ours=0.0 if abs(residual) <= NOTHING else residual,
        holds=abs(residual) <= NOTHING,
        tolerance=NOTHING,
        **more,
    )


def rounded(value: Any, digits: int = 4) -> Any:
    """A value with so many significant digits; lists entry by entry, text and whole numbers as they are."""
    if isinstance(value, list | tuple | np.ndarray):
        return [rounded(each, digits) for each in value]
    if isinstance(value, str | bool | int) or value is None:
        return value
    number = float(value)
    if number == 0 or not math.isfinite(number):
        return number if math.isfinite(number) else None
    kept = float(f"{number:.{digits - 1}e}")
    return int(kept) if kept == int(kept) and abs(kept) < 1e15 and digits < 16 else kept
