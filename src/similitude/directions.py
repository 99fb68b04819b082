"""Which unknowns are worth identifying: population spread against noise, along one drive.

    M = sum over rows of s s'/sigma^2     information of the drive about the coordinates
    S                                     covariance of the population
    S^1/2 M S^1/2                         eigenvalues: squared moves of the output over the spread, in noise

Identify what moves the output most, learn or carry what still moves it by more than the noise, and forget
what does not. Freezing the others, as the paper does, is the limit of zero covariance; what that costs in
bias is worked out beside it.

Invariant: the covariance is never thrown away silently; a role can be overridden, and then says so.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from similitude.errors import UsageError
from similitude.output_sensitivity import output_sensitivity
from similitude.population import Prior
from similitude.reduction import Reduction

LEARNT = 0.9  # sd after the drive over that before, up to which an unknown is estimated and not only carried
READ = 'docs/populations.md, "What is worth identifying"'


@dataclass(frozen=True)
class Direction:
    """A direction of the population.

    ``move``: rms of the output over noise, summed over the drive, for one sd along it [-];
    ``of``: unknown -> its coordinate's move for one sd along the direction.
    """

    move: float
    of: Mapping[str, float]


@dataclass(frozen=True)
class Role:
    """One unknown's part.

    ``role``: ``identify``, ``estimate``, ``consider`` or ``never``; ``before``, ``after`` sd of its
    coordinate; ``move`` as of a direction; ``bias`` of the identified coordinate if this one is frozen one sd
    off; ``chosen`` by whom.
    """

    name: str
    role: str
    before: float
    after: float
    move: float
    bias: float
    chosen: str


@dataclass(frozen=True, eq=False)
class Reduced:
    """What to identify, and what the rest costs.

    Parameters
    ----------
    reduction : Reduction            with the roles in place, the identified unknown first
    directions : largest first       roles : one an unknown
    sd : float                       of the identified coordinate with the others carried
    frozen_sd, frozen_bias : float   what a filter with frozen others claims, and its rms bias
    """

    reduction: Reduction
    directions: tuple[Direction, ...]
    roles: tuple[Role, ...]
    sd: float
    frozen_sd: float
    frozen_bias: float

    @property
    def text(self) -> str:
        """The table as plain text."""
        heads = f"{'sd before':>10}{'after':>8}{'moves output':>14}{'bias if frozen':>16}"
        wide = max(10, *(len(one.name) + 2 for one in self.roles))
        lines = [f"{'unknown':<{wide}}{'role':<10}{heads}"]
        for one in self.roles:
            mine = one.role == "identify"
            lines.append(
                f"{one.name:<{wide}}{one.role:<10}{one.before:>10.3f}{one.after:>8.3f}{one.move:>12.1f} σ"
                f"{'' if mine else f'{100 * one.bias:.1f} %':>16}"
                + ("" if one.chosen == "rule" else f"  ({one.chosen})")
            )
        lines.append(
            f"carried: sd {100 * self.sd:.1f} %; frozen: claims {100 * self.frozen_sd:.1f} %, "
            f"biased by {100 * self.frozen_bias:.1f} % rms over the population"
        )
        return "\n".join(lines)


def reduce(
    reduction: Reduction,
    prior: Prior,
    u: NDArray,
    step: float,
    *,
    noise: float,
    scales: Mapping[str, float],
    roles: Mapping[str, str] | None = None,
) -> Reduced:
    """Rank directions and choose the unknowns' roles.

    Parameters
    ----------
    reduction : Reduction   unknowns in place of groups.
    prior : Prior           of at least these unknowns.
    u : (n,) input of a manoeuvre or a log [SI].    step : sample time [s].
    noise : sd of the measured output, white [SI].
    scales : name -> value [SI] of the base.
    roles : unknown -> role, where the rule is to be overridden.

    Returns
    -------
    Reduced

    Raises
    ------
    UsageError              a role or an unknown in `roles` does not exist, or two are to be identified.

    References
    ----------
    Brennan & Alleyne 2004, section 4.
    """
    names = tuple(one.name for one in reduction.unknowns)
    values = {**scales, **dict(zip(names, map(float, prior.of(names).mean), strict=True))}
    return rank(reduction, prior, output_sensitivity(reduction, values, u, step) / noise, roles=roles)


def rank(
    reduction: Reduction, prior: Prior, slopes: NDArray, *, roles: Mapping[str, str] | None = None
) -> Reduced:
    """The same from slopes of the output that are at hand.

    Parameters
    ----------
    reduction, prior, roles : as `reduce` takes them.
    slopes : (n, unknowns) d output / d coordinate over the noise [-].

    Returns
    -------
    Reduced

    Raises
    ------
    UsageError    as `reduce`.
    """
    names = tuple(one.name for one in reduction.unknowns)
    own = prior.of(names)
    M, S = slopes.T @ slopes, own.covariance
    after = np.linalg.inv(M + np.linalg.inv(S))
    move = np.sqrt(np.diag(M) * np.diag(S))
    chosen = _roles(names, move, np.sqrt(np.diag(after) / np.diag(S)), roles or {})
    first = names.index(next(n for n, role in chosen.items() if role == "identify"))
    others = [i for i in range(len(names)) if i != first]
    gain = M[first] / M[first, first]
    table = tuple(
        Role(n, chosen[n], float(np.sqrt(S[i, i])), float(np.sqrt(after[i, i])), float(move[i]),
             0.0 if i == first else float(abs(gain[i]) * np.sqrt(S[i, i])),
             "yours" if n in (roles or {}) else "rule")
        for i, n in enumerate(names)
    )  # fmt: skip
    return Reduced(
        _with_roles(reduction, chosen, first),
        _directions(names, M, S),
        table,
        float(np.sqrt(after[first, first])),
        float(1 / np.sqrt(M[first, first] + 1 / S[first, first])),
        float(np.sqrt(gain[others] @ S[np.ix_(others, others)] @ gain[others])),
    )


def _roles(names: Sequence[str], move: NDArray, kept: NDArray, wanted: Mapping[str, str]) -> dict[str, str]:
    known = ("identify", "estimate", "consider", "never")
    wrong = [n for n, role in wanted.items() if n not in names or role not in known]
    several = [n for n, role in wanted.items() if role == "identify"]
    if wrong or len(several) > 1:
        what = f"roles = {dict(wanted)}: "
        what += (
            f"{wrong[0]!r} or its role does not exist"
            if wrong
            else f"{', '.join(several)} are to be identified"
        )
        raise UsageError(
            what + f" (unknowns: {', '.join(names)}; roles: {', '.join(known)})",
            usually="one unknown is identified, the others are estimated, considered or never matter.",
            paste=f"roles={{{names[0]!r}: 'identify'}}",
            read=READ,
        )
    free = [i for i, n in enumerate(names) if n not in wanted]
    chosen = dict(wanted)
    if not several and free:
        best = max(free, key=lambda i: move[i])
        chosen[names[best]] = "identify"
    for i in free:
        rule = "never" if move[i] < 1 else "estimate" if kept[i] <= LEARNT else "consider"
        chosen.setdefault(names[i], rule)
    if "identify" not in chosen.values():
        raise UsageError(
            f"roles = {dict(wanted)} leave nothing to identify",
            usually="every unknown was given another role.",
            paste=f"roles={{{names[0]!r}: 'identify'}}",
            read=READ,
        )
    return chosen


def _with_roles(reduction: Reduction, chosen: Mapping[str, str], first: int) -> Reduction:
    """The reduction in these roles; what never matters is considered, which costs nothing in honesty."""
    given = [
        replace(one, role="consider" if chosen[one.name] == "never" else chosen[one.name])
        for one in reduction.unknowns
    ]
    return replace(reduction, unknowns=(given[first], *given[:first], *given[first + 1 :]))


def _directions(names: Sequence[str], M: NDArray, S: NDArray) -> tuple[Direction, ...]:
    values, vectors = np.linalg.eigh(S)
    root = (vectors * np.sqrt(np.maximum(values, 0))) @ vectors.T
    sizes, axes = np.linalg.eigh(root @ M @ root)
    found = []
    for k in range(len(names))[::-1]:
        w = root @ axes[:, k]
        w = w if w[np.argmax(np.abs(w))] > 0 else -w
        found.append(
            Direction(float(np.sqrt(max(sizes[k], 0))), dict(zip(names, map(float, w), strict=True)))
        )
    return tuple(found)
