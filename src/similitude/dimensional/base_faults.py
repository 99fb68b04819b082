"""A base that cannot be one, refused with the reason and a base to paste in its place.

Invariant: `base_solutions` returns only for a base whose dimensions are independent and reach every
variable; anything else is a ModelError with four parts.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from typing import NoReturn

from similitude.dimensional.base_check import BaseCheck, check_base
from similitude.dimensional.exact_span import Column, span_of
from similitude.dimensional.matrix import DimensionMatrix
from similitude.errors import ModelError, shown

READ = 'docs/groups.md, "A base that cannot be one"'


def base_names(matrix: DimensionMatrix, base: Sequence[str]) -> tuple[str, ...]:
    """The names of a base, once they are known to be names of different variables.

    Parameters
    ----------
    matrix : DimensionMatrix   of the variables.
    base : the names as the caller gave them.

    Raises
    ------
    ModelError    one text in place of several, an unknown name, or a name given twice.
    """
    if isinstance(base, str):
        split = [part for part in base.replace(",", " ").split() if part]
        raise _refused(
            f"base is the text {shown(base)}, not a sequence of names",
            "the names were written as one text; Python then sees its letters.",
            split,
        )
    known = matrix.names
    # a set has no order: that of the variables is the same tomorrow
    base = tuple(sorted(base, key=_place(known)) if isinstance(base, set | frozenset) else base)
    for name in base:
        if name not in known:
            near = difflib.get_close_matches(str(name), known, n=1, cutoff=0.5)
            near = near or [own for own in known if own.lower() == str(name).lower()]
            raise _refused(
                f"base names {shown(name)}, which is none of the variables ({', '.join(known) or 'none'})"
                + (f"; did you mean {shown(near[0])}?" if near else ""),
                "the name was misspelt, or its unit was left out of the variables.",
                [near[0] if near and own == name else own for own in base],
            )
    twice = [name for place, name in enumerate(base) if name in base[:place]]
    if twice:
        raise _refused(
            f"base names {', '.join(map(shown, dict.fromkeys(twice)))} more than once: {', '.join(base)}",
            "another variable was meant; one measure cannot serve twice.",
            list(dict.fromkeys(base)),
        )
    return base


def _place(known: Sequence[str]):
    return lambda name: (known.index(name) if name in known else len(known), str(name))


def base_solutions(matrix: DimensionMatrix, base: tuple[str, ...]) -> dict[Column, tuple[list[int], int]]:
    """Every dimension of the variables in those of a base, once it is known to be a valid one.

    Parameters
    ----------
    matrix : DimensionMatrix   of the variables.
    base : r different names of variables.

    Returns
    -------
    column -> n (r,), N integers with  base n = N column.

    Raises
    ------
    ModelError    the base is dependent, or does not reach every variable.
    """
    span = span_of([matrix.column(name) for name in base], len(matrix.rows))
    solved = {} if span is None else {column: span.solve(column) for column in set(matrix.columns)}
    if span is None or None in solved.values():
        _refuse(check_base(matrix, base))
    return solved


def _refuse(check: BaseCheck) -> NoReturn:
    raise ModelError(
        f"base {', '.join(check.base) or '()'}: {check.reason}",
        usually=_usual(check),
        paste=_paste(check),
        read=READ,
    )


def _usual(check: BaseCheck) -> str:
    if check.product:
        return "two of them measure the same thing, such as two lengths or a speed beside L and T."
    if check.lonely:
        return "a variable that brings its dimension matters only with a second one that has it."
    return "a base needs one variable for each independent dimension: one mass, one length, one time."


def _paste(check: BaseCheck) -> str:
    if check.lonely and not check.completions:
        return f"del variables[{check.lonely[0]!r}]"
    return f"base={[*check.kept, *check.completions[0]]!r}"


def _refused(what: str, usually: str, instead: Sequence[str]) -> ModelError:
    return ModelError(what, usually=usually, paste=f"base={list(instead)!r}", read=READ)
