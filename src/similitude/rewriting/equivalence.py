"""That a rewritten model is the same model: exactly at random points, then in symbols.

    c/T f*(x/c, Pi(p)) - f(x, p)  =  0        for each rate, and likewise for each output

Points are rational and such that every root a scale holds is rational too, so the arithmetic is exact.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

import sympy as sp

from similitude.invariance.exact_zero import DIGITS, proven_zero
from similitude.rewriting.rewritten import Rewritten

POINTS = 3


@dataclass(frozen=True)
class Equivalence:
    """What was shown.

    Parameters
    ----------
    points : at how many random rational points every difference was evaluated.
    exact : whether all were exactly zero, in rational arithmetic; False where a function of numbers had to
        be compared in 50 digits.
    in_symbols : formulas whose difference is zero whatever the symbols are.
    not_shown : formulas for which no algebra here shows it, and which rest on the points.
    wrong : formulas that differ, with the difference; empty for a model that was rewritten correctly.
    """

    points: int
    exact: bool
    in_symbols: tuple[str, ...]
    not_shown: tuple[str, ...]
    wrong: dict[str, sp.Expr]

    @property
    def holds(self) -> bool:
        """Whether no formula differs."""
        return not self.wrong


def prove_equivalence(rewritten: Rewritten) -> Equivalence:
    """Compare the rewritten model with the one it was made of.

    Parameters
    ----------
    rewritten : Rewritten, its chain-rule terms left aside: they vanish where the base stands still.
    """
    g, model = rewritten.groups, rewritten.groups.model
    again = rewritten.back()
    pairs = {f"rate of {q.name}": (again.rates[q.name], model.rates[q.name]) for q in model.states}
    pairs |= {f"output {q.name}": (again.output_map[q.name], model.output_map[q.name]) for q in model.outputs}
    exact, wrong, shown, open_ = True, {}, [], []
    draw = random.Random(len(pairs))
    roots = _common_root(g)
    for _ in range(POINTS):
        at = {
            q.symbol: sp.Rational(draw.randint(2, 29), draw.randint(2, 29))
            ** (roots if q in _scales(rewritten) else 1)
            for q in model.quantities
        }
        for where, (new, old) in pairs.items():
            difference = new.xreplace(at) - old.xreplace(at)
            if difference != 0:
                exact = exact and bool(difference.is_zero)
                size = abs(sp.N(difference, DIGITS))
                if not size.is_Float or size > sp.Float("1e-40") * (1 + abs(sp.N(old.xreplace(at), DIGITS))):
                    wrong[where] = new - old
    for where, (new, old) in pairs.items():
        if where not in wrong:
            (shown if proven_zero(new - old) == 0 else open_).append(where)
    return Equivalence(POINTS, exact, tuple(shown), tuple(open_), wrong)


def _scales(rewritten: Rewritten):
    return [rewritten.groups.model.quantity(name) for name in rewritten.groups.base]


def _common_root(groups) -> int:
    """The power by which every exponent of a base parameter becomes an integer."""
    scales = [*groups.scale.values(), groups.time_scale]
    denominators = [
        int(power.q) for scale in scales for power in scale.as_powers_dict().values() if power.is_Rational
    ]
    return math.lcm(*denominators) if denominators else 1
