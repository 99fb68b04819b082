"""How the population filter for small parts corrects: what learns, and what every sample corrects.

    learn      the unknowns' own block of the covariance, only while something is heard
    correct    all other rows
    c = P H    of the first output; of a further one less what goes with the first: two innovations that have
               nothing in common, so that both correct in a single pass

Invariant: the gains and covariance are those of the measurements taken one after the other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from similitude.estimators import filter_covariance as cov
from similitude.estimators.filter_adapt import set_lower_status
from similitude.estimators.filter_fields import INPUT_SCALE, Layout
from similitude.program.ir import Assign, Statement, When
from similitude.program.parts import as_part
from similitude.program.symmetric import column
from similitude.status import STATUS

HALF = sp.Rational(1, 2)


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def held_of(layout: Layout) -> tuple[list[int], list[int]]:
    """Coordinates that only learning corrects, and those that every sample does."""
    ranks = _ranks(layout)
    held = [i for i in range(layout.covariance.n) if ranks.get(i, 1) > 0]
    return held, [i for i in range(layout.covariance.n) if i not in held]


def _weights(layout: Layout) -> dict[int, str]:
    """Index of what is corrected at all -> name of what an innovation counts with for it."""
    names = layout.coordinates
    able = [i for i, name in enumerate(names) if name not in layout.considered]
    return cov.weights(layout, able, learn="inv_spread")


def _ranks(layout: Layout) -> dict[int, int]:
    """Index -> how often its gain is zero: 0 never, 1 while nothing is heard, and more."""
    ranks = {i: cov.ORDER.index(w) for i, w in _weights(layout).items()}
    return ranks | {layout.coordinates.index(layout.target): 1}


def _prefixes(layout: Layout) -> list[str]:
    """What the names begin with that belong to each of a sample's measurements."""
    return ["", *(f"{q.name}_" for q in layout.further)]


def _columns(
    layout: Layout, H: Mapping[int, sp.Expr], rows: Sequence[int], early: Sequence[int]
) -> list[Assign]:
    """Covariance of rows with each innovation, where it is not yet there."""
    t = layout.coordinates.index(layout.target)
    lines = column(layout.covariance, H, "c", (i for i in rows if i not in early))
    return lines + [line for i in rows if i != t for line in _further_columns(layout, i)]


def _further_columns(layout: Layout, i: int) -> list[Assign]:
    return [
        Assign(f"{n}c_{i}", S(f"{n}with_{i}") - S(f"c_{i}") * S(f"{n}after")) for n in _prefixes(layout)[1:]
    ]


def _less(layout: Layout, i: int, j: int) -> Assign:
    """An entry of P less what every measurement takes of it: by row ``i``'s gain."""
    P = layout.covariance
    taken = (S(f"{n}gain_{i}") * S(f"{n}c_{j}") for n in _prefixes(layout))
    return Assign(P.target(i, j), P[i, j] - sp.Add(*taken))


def _move(layout: Layout, i: int) -> list[Assign]:
    """A coordinate moves by all gains and innovations; the first unknown only at the end of the step."""
    name, kinds = layout.coordinates[i], {u.name: u.kind for u in layout.reduction.unknowns}
    by = sp.Add(*(S(f"{n}gain_{i}") * S(f"{n}innovation") for n in _prefixes(layout)))
    if name == layout.target:
        return [Assign("move", S("move") + by)]
    if name == INPUT_SCALE or kinds.get(name) == "log":
        return [Assign(f"move_{name}", by), *move_square(name, f"move_{name}")]
    return [Assign(name, S(name) + by)]


def learning(layout: Layout, H: Mapping[int, sp.Expr], early: Sequence[int]) -> list[Statement]:
    """What the innovations teach, while something is heard."""
    held, _ = held_of(layout)
    t, prefixes = layout.coordinates.index(layout.target), _prefixes(layout)
    gained, inv_P = S("gained"), S("inv_P")
    first = [Assign(f"{n}gain_{t}", S(f"{n}c_{t}") * S(f"{n}inv_spread")) for n in prefixes]
    told = sp.Add(*(S(f"{n}gain_{t}") * S(f"{n}c_{t}") for n in prefixes))
    body = (
        *_slow_weights(layout),
        *first,
        Assign("gained", told * inv_P, "share of the variance removed"),
        Assign("information", S("information") + gained * (1 + gained) * inv_P, "1/variance gained"),
        *_move(layout, t),
        *as_part("learn", _learn(layout, H, held, early)),
        *keep_each_within([n for n in layout.moving if n != layout.target]),
    )
    unheard = (set_lower_status("not_excited"),)
    return [
        *_further_columns(layout, t),
        When(S("excited") > 0, body, unheard, "heard of the samples before"),
    ]


def _learn(
    layout: Layout, H: Mapping[int, sp.Expr], held: Sequence[int], early: Sequence[int]
) -> list[Assign]:
    """The unknowns' own block, and where they move to."""
    t, weights, ranks = layout.coordinates.index(layout.target), _weights(layout), _ranks(layout)
    own = [i for i in held if i in weights and i != t]
    lines = _columns(layout, H, [i for i in held if i != t], early)
    lines += [
        Assign(f"{n}gain_{i}", S(f"{n}c_{i}") * S(f"{n}{weights[i]}")) for i in own for n in _prefixes(layout)
    ]
    for at, i in enumerate(held):
        for j in held[at:]:
            able = sorted((k for k in (i, j) if k in weights), key=ranks.__getitem__)
            if able:
                lines.append(_less(layout, able[0], j if able[0] == i else i))
    return [*lines, *(line for i in own for line in _move(layout, i))]


def correction(layout: Layout, H: Mapping[int, sp.Expr], early: Sequence[int]) -> list[Assign]:
    """The coordinates that every sample corrects, by all of its measurements in one pass."""
    n, (held, fast) = layout.covariance.n, held_of(layout)
    lines = _columns(layout, H, range(n), early)
    for i in fast:
        lines += [Assign(f"{p}gain_{i}", S(f"{p}c_{i}") * S(f"{p}inv_spread")) for p in _prefixes(layout)]
        lines += [_less(layout, i, j) for j in range(n) if j >= i or j in held]
        lines += _move(layout, i)
    return as_part("correct", lines)


def _slow_weights(layout: Layout) -> list[Statement]:
    """What the innovations count with for unknowns that cannot jump, and for those learnt now and then."""
    lines: list[Statement] = []
    for n in _prefixes(layout):
        slow = sp.Piecewise((S(f"{n}inv_spread"), S("jump") <= 0), (0, True))
        lines.append(Assign(f"{n}learn_slow", slow, "a jump is not blamed on what cannot jump"))
    if not layout.seldom:
        return lines
    seldom = [Assign(f"{n}learn_seldom", S(f"{n}learn_slow")) for n in _prefixes(layout)]
    return [
        *lines,
        Assign("unlearnt", S("unlearnt") + S("dt")),
        *(Assign(line.target, sp.Integer(0)) for line in seldom),
        When(
            S("unlearnt") >= S("seldom"),
            (*seldom, Assign("unlearnt", sp.Integer(0))),
            (),
            "the next sample tells little that this one does not",
        ),
    ]


def move_square(name: str, by: str) -> list[Assign]:
    """Move a positive state by so much of its logarithm: by the square of exp's series over half of it.

    Positive for any move and off by m^3/24, so no move has to be bounded; the least it leaves is a quarter.
    """
    half, m = S(f"half_{by}"), S(by)
    eighth = sp.Rational(1, 8)
    return [Assign(half.name, 1 + m * (HALF + eighth * m)), Assign(name, S(name) * (half * half))]


def keep_each_within(names: Sequence[str]) -> list[Statement]:
    """Unknowns inside what the population allows, after a measurement; the status says where one was not."""
    told = Assign("status", sp.Integer(STATUS["at_limit"]))
    sides = [(n, S(f"{n}_low"), S(n) < S(f"{n}_low")) for n in names]
    sides += [(n, S(f"{n}_high"), S(n) > S(f"{n}_high")) for n in names]
    return [When(beyond, (Assign(n, limit), told), (), "its allowed range") for n, limit, beyond in sides]
