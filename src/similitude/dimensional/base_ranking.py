"""RankedBase: one valid base with the three numbers it is judged by, and the verdict in words.

    E = B^-1 D      variables' dimensions in those of the base (r, n); a group is x_j / prod base_i^E_ij
    drift^2         mean over the groups j of  sum_i (E_ij sd_i)^2
    condition       largest over smallest singular value of E; at least 1, and 1 is best

Invariant: the order depends on exact exponents and on what was stated, so it is the same whatever the
units, and the same again tomorrow.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from similitude.dimensional.matrix import DimensionMatrix

DIGITS = 9  # what two routes to one singular value agree in; ties are then settled by the given order


@dataclass(frozen=True)
class RankedBase:
    """A valid base and how good it is.

    Parameters
    ----------
    base : names, in the order of the candidates.
    unmeasured : those whose value is not known.
    unstated : those whose spread nobody stated, where spreads were given.
    drift : rms sd of ln(group) that the base's stated spreads cause [-]; None where none was given.
    condition : of the exponents [-].
    largest : largest exponent of a base variable in a group [-].
    """

    base: tuple[str, ...]
    unmeasured: tuple[str, ...]
    unstated: tuple[str, ...]
    drift: float | None
    condition: float
    largest: Fraction

    @property
    def reason(self) -> str:
        """The verdict in words, most important first."""
        clauses = []
        if self.unmeasured:
            clauses.append(f"{_are(self.unmeasured)} not measured")
        if self.unstated:
            clauses.append(f"the spread of {', '.join(self.unstated)} is not stated")
        if self.drift is not None:
            whose = "the spread stated" if self.unstated else "its spread"
            clauses.append(f"{whose} moves the groups by {_share(self.drift)}")
        clauses.append(f"condition {self.condition:.3g}, exponents up to {self.largest}")
        return "; ".join(clauses)


def _share(drift: float) -> str:
    """A sd of a logarithm in words: per cent while that is meant the same by everybody."""
    return f"{100 * drift:.2g} %" if drift < 0.3 else f"a factor of {math.exp(drift):.3g}"


def _are(names: Sequence[str]) -> str:
    return f"{', '.join(names)} {'is' if len(names) == 1 else 'are'}"


def rank_bases(
    matrix: DimensionMatrix,
    bases: Sequence[tuple[str, ...]],
    candidates: Sequence[str],
    *,
    spread: Mapping[str, float] | None,
    measured: Collection[str] | None,
) -> tuple[RankedBase, ...]:
    """Judge valid bases and put the better ones first.

    Parameters
    ----------
    matrix : DimensionMatrix   of n variables.
    bases : k valid bases of r names each.
    candidates : the order that settles ties.
    spread, measured : as for `advise_base`.

    Returns
    -------
    k bases, best first.
    """
    import numpy as np

    if not bases:
        return ()
    span = matrix.leading[1]
    exact = {column: span.exponents(column) for column in set(matrix.columns)}
    R = np.array([[float(x) for x in exact[column]] for column in matrix.columns])
    R = R.reshape(len(matrix.names), span.rank).T  # (r, n)
    at = np.array([[matrix.names.index(name) for name in base] for base in bases], dtype=int)
    E = np.linalg.solve(R[:, at].transpose(1, 0, 2), np.broadcast_to(R, (len(bases), *R.shape)))  # (k, r, n)
    # of E E' (k, r, r), small where E is long; 1 where there is no dimension at all
    squares = np.linalg.eigvalsh(E @ E.transpose(0, 2, 1)) if at.size else np.ones((len(bases), 1))
    condition = np.sqrt(squares[:, -1] / squares[:, 0])
    ranked = [
        _ranked(base, E[i], float(condition[i]), at[i], spread=spread, measured=measured)
        for i, base in enumerate(bases)
    ]
    place = {name: i for i, name in enumerate(candidates)}
    return tuple(sorted(ranked, key=lambda one: (*_grade(one), [place[name] for name in one.base])))


def _grade(one: RankedBase) -> tuple:
    drift = None if one.drift is None else round(one.drift, DIGITS)
    return len(one.unmeasured), len(one.unstated), drift or 0.0, round(one.condition, DIGITS), one.largest


def _ranked(base, E, condition, at, *, spread, measured) -> RankedBase:
    import numpy as np

    groups = np.delete(E, at, axis=1)  # (r, n - r)
    drift = None
    if spread is not None:
        sd = np.array([spread.get(name, 0.0) for name in base])
        moved = ((groups * sd[:, None]) ** 2).sum(axis=0)
        drift = float(np.sqrt(moved.mean())) if moved.size else 0.0
    largest = float(np.abs(groups).max()) if groups.size else 0.0
    return RankedBase(
        base=base,
        unmeasured=() if measured is None else tuple(n for n in base if n not in measured),
        unstated=() if spread is None else tuple(n for n in base if n not in spread),
        drift=drift,
        condition=condition,
        largest=Fraction(largest).limit_denominator(1000),
    )
