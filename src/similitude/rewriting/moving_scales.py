"""Scales that are measured and change on the way: what the chain rule adds to the rewritten rates.

    x* = x/c,  c = ... b^e ...        dx*/dt* gains  -e x* b_rate,   b_rate = (T/b) db/dt   [-]

For the bicycle with base m, L, U:  -(U'/U)(L/U) v*  and the same for r*.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.groups import Groups


def rate_symbol(name: str) -> sp.Symbol:
    """The dimensionless rate of change of a base parameter, ``<name>_rate``."""
    return sp.Symbol(f"{name}_rate", real=True)


def chain_terms(groups: Groups, moving: Sequence[str]) -> dict[str, sp.Expr]:
    """State -> the terms that moving base parameters add to its rate; states they do not touch are left out.

    Parameters
    ----------
    groups : the rewritten model.
    moving : names of base parameters that change on the way.
    """
    terms = {}
    for state in groups.model.states:
        powers = groups.scale[state.name].as_powers_dict()
        total = sp.Add(*(-powers[sp.Symbol(b, real=True)] * rate_symbol(b) * state.symbol for b in moving))
        if total != 0:
            terms[state.name] = total
    return terms
