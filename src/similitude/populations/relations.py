"""Relations of a population: exact constraints, power laws and lines, and products that cluster.

A pair of groups gives a line or a power law. Three and four groups give a product of powers +1 and -1
that is nearly the same for every system; it counts only where every member pays for itself: left out,
the product would scatter more than chance explains. Ranked by how well a system that was not in the
table is predicted.

Invariant: nothing is entered. A relation is a discovery only against the null of independent raw
parameters given the shared base, false discoveries controlled over everything that was tried.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from similitude.populations.exact_constraints import find_constraints
from similitude.populations.independence import discoveries, probability
from similitude.populations.lines import MAD, fit_pair, out_of_sample
from similitude.populations.population import Population

LEVEL = 0.01  # share of false discoveries that is accepted
LARGEST = 4  # groups in one product
BETTER = 0.8  # out-of-sample error over that of a part, that makes one more group worth it
SHOWN = 8  # candidates that are kept although they are no discoveries
FEWEST_TO_TRIM = 8  # systems below which none is left out as far from the others


@dataclass(frozen=True)
class Relation:
    """One relation between groups.

    Parameters
    ----------
    kind : str               "constraint", "power" or "line"
    groups : names
    coefficients : dict      constraint: group -> coefficient, and "constant"; line: "slope", "intercept";
                             power of two: "exponent", "factor"; product: group -> exponent, "constant"
    interval : (low, high)   95 %, of slope, exponent or constant
    scatter : float          robust sd of ln of the last group about it [-]
    out_of_sample : float    the same for systems that it was not fitted to [-]
    n : int                  systems that know all its groups
    p, q : float             probability under the null, and adjusted for all that were tried
    given_base : bool        whether what the base explains was taken out first
    found : bool             a discovery
    loss : float or None     rms change of the output that its scatter causes, as a share [-]
    """

    kind: str
    groups: tuple[str, ...]
    coefficients: dict[str, float]
    interval: tuple[float, float]
    scatter: float
    out_of_sample: float
    n: int
    p: float = 0.0
    q: float = 0.0
    given_base: bool = True
    found: bool = True
    loss: float | None = None

    @property
    def text(self) -> str:
        """The relation as people write it."""
        c = self.coefficients
        if self.kind == "constraint":
            terms = " + ".join(f"{'' if c[g] == 1 else f'{c[g]:.4g} '}{g}" for g in self.groups)
            return f"{terms} = {c['constant']:.4g}".replace("+ -", "- ")
        x, y = self.groups[0], self.groups[-1]
        if "slope" in c:
            return f"{y} = {c['slope']:.4g} {x}" + (f" {c['intercept']:+.4g}" if c["intercept"] else "")
        if "exponent" in c:
            return f"{y} = {c['factor']:.4g} {x}^{c['exponent']:.3g}"
        above = " ".join(g for g in self.groups if c[g] > 0)
        below = " ".join(g for g in self.groups if c[g] < 0)
        below = f"({below})" if " " in below else below
        return f"{above or '1'}{f'/{below}' if below else ''} = {c['constant']:.4g}"


@dataclass(frozen=True)
class Relations:
    """What a population keeps to.

    Parameters
    ----------
    constraints : exact.   discoveries : proven, best first.   candidates : best of what is not proven, by
    scatter over that of independent members.
    tried : int            relations that were tested; `level` of the discoveries may be false.
    """

    constraints: tuple[Relation, ...]
    discoveries: tuple[Relation, ...]
    candidates: tuple[Relation, ...] = ()
    tried: int = 0
    level: float = LEVEL

    def __iter__(self):
        return iter((*self.constraints, *self.discoveries))

    def __len__(self) -> int:
        return len(self.constraints) + len(self.discoveries)

    def of(self, *groups: str) -> Relation | None:
        """The relation of exactly these groups, discoveries before candidates."""
        for relation in (*self, *self.candidates):
            if set(relation.groups) == set(groups):
                return relation
        return None


@dataclass(eq=False)
class _Columns:
    """Logarithms of groups and of their own parameters, and the base, all (n, ...)."""

    names: tuple[str, ...]
    logs: NDArray
    own: NDArray
    base: NDArray
    tied: list[set[str]] = field(default_factory=list)

    def known(self, places: Sequence[int]) -> NDArray:
        """Rows that know all of these, copies once."""
        rows = np.flatnonzero(np.isfinite(self.logs[:, places]).all(axis=1))
        _, first = np.unique(np.round(self.logs[np.ix_(rows, places)], 9), axis=0, return_index=True)
        return rows[np.sort(first)]


def relate(population: Population, *, level: float = LEVEL, largest: int = LARGEST) -> Relations:
    """Find the relations between the groups of a population.

    Parameters
    ----------
    population : Population
    level : share of false discoveries that is accepted.
    largest : groups in one product at most.

    Returns
    -------
    Relations
    """
    columns = _columns(population)
    constraints = tuple(_constraint(one) for one in find_constraints(np.exp(columns.logs), columns.names))
    columns.tied = [set(one.groups) for one in constraints]
    tested = [one for places in itertools.combinations(range(len(columns.names)), 2)
              if (one := _pair(columns, places)) is not None]  # fmt: skip
    for size in range(3, largest + 1):
        for places in itertools.combinations(range(len(columns.names)), size):
            tested += _products(columns, places)
    q = discoveries(np.array([p for p, *_ in tested]), level)
    order = np.argsort(q, kind="stable")
    proven = [_fitted(columns, tested[i], float(q[i]), found=True) for i in order if q[i] <= level]
    rest = [
        _fitted(columns, tested[i], float(q[i]), found=False) for i in _promising(columns, tested, q, level)
    ]
    best = tuple(sorted(_leading(proven), key=lambda one: one.out_of_sample))
    return Relations(constraints, best, tuple(rest), len(tested), level)


def _columns(population: Population) -> _Columns:
    groups = population.groups
    logs = population.logs
    base = [n for n in groups.base if n not in groups.model.signals]
    own = population.logs_of([{g.parameter: 1} for g in groups.groups])
    own = np.where(np.isfinite(own), own, logs)  # a table of groups alone has no parameters
    told = population.logs_of([{n: 1} for n in base])
    posterior = population.space.logs(population.gaussian.rows)
    guess = posterior[:, [population.space.parameters.index(n) for n in base]]
    return _Columns(population.names, logs, own, np.where(np.isfinite(told), told, guess))


def _constraint(one: dict[str, float]) -> Relation:
    names = tuple(n for n in one if n not in ("constant", "rows"))
    coefficients = {n: one[n] for n in (*names, "constant")}
    constant = one["constant"]
    return Relation("constraint", names, coefficients, (constant, constant), 0.0, 0.0, int(one["rows"]))


Tested = tuple[float, bool, tuple[int, ...], tuple[int, ...]]  # p, given the base, places, exponents


def _pair(columns: _Columns, places: tuple[int, ...]) -> Tested | None:
    rows = columns.known(places)
    if any({columns.names[j] for j in places} <= tied for tied in columns.tied) or len(rows) < 4:
        return None
    one, other = (columns.own[rows, j] for j in places)
    p, given = probability(one, other, columns.base[rows])
    return p, given, places, ()


def _products(columns: _Columns, places: tuple[int, ...]) -> list[Tested]:
    """Products of +1 and -1 powers of these groups, each with its worst member's probability."""
    rows = columns.known(places)
    if len(rows) < 4 or _depends(columns, places):
        return []
    base, own = columns.base[rows], columns.own[np.ix_(rows, places)]
    logs = columns.logs[np.ix_(rows, places)]
    found = []
    for signs in itertools.product((1, -1), repeat=len(places) - 1):
        e = np.array((1, *signs))
        without = [np.where(np.arange(len(e)) == j, 0, e) for j in range(len(e))]
        tighter = _scatter(logs @ e) < min(_scatter(logs @ rest) for rest in without)
        worst, given = (0.0 if tighter else 1.0), True
        for j, rest in enumerate(without):
            if worst > 0.2:  # one member does not pay: counted as tried, and that is all
                break
            p, given = probability(own @ rest, own[:, j] * e[j], base, opposite=True)
            worst = max(worst, p)
        last = int(e[-1])  # written with the last group above the line
        found.append((worst, given, places, tuple(int(x) * last for x in e)))
    return found


def _depends(columns: _Columns, places: Sequence[int]) -> bool:
    """Whether these are a constraint and one more group, a pair in disguise unless both pay."""
    return any(tied == {columns.names[j] for j in places} for tied in columns.tied)


def _scatter(values: NDArray) -> float:
    """Robust sd; of few values the plain one."""
    if len(values) < FEWEST_TO_TRIM:
        return float(values.std(ddof=1))
    return float(MAD * np.median(np.abs(values - np.median(values))))


def _promising(columns: _Columns, tested: list[Tested], q: NDArray, level: float) -> list[int]:
    """The best of what is not proven, by its scatter over what independent members would scatter."""
    open_ = [i for i in range(len(tested)) if q[i] > level and _may_be_one(columns, tested[i])]
    return sorted(open_, key=lambda i: _relative(columns, tested[i]))[:SHOWN]


def _may_be_one(columns: _Columns, one: Tested) -> bool:
    """Unlikely by chance; of fewer rows than can prove anything, only that every member helps."""
    p, _, places, _ = one
    return p < (1.0 if len(columns.known(places)) < FEWEST_TO_TRIM else 0.1)


def _relative(columns: _Columns, one: Tested) -> float:
    _, _, places, e = one
    rows = columns.known(places)
    logs = columns.logs[np.ix_(rows, places)]
    signs = np.array(e or (1, -1))
    return _scatter(logs @ signs) / max(float(np.sqrt((logs.var(axis=0)).sum())), 1e-12)


def _leading(found: list[Relation]) -> list[Relation]:
    """Pairs, and products of which no part predicts as well and that are no part of a better one."""
    kept: list[Relation] = []
    for one in sorted(found, key=lambda r: (len(r.groups), r.out_of_sample)):
        parts = [k for k in kept if set(k.groups) < set(one.groups)]
        if all(one.out_of_sample < BETTER * part.out_of_sample for part in parts):
            kept.append(one)
    return [
        one for one in kept
        if len(one.groups) == 2 or not any(
            set(one.groups) < set(more.groups) and more.out_of_sample < BETTER * one.out_of_sample
            for more in kept
        )
    ]  # fmt: skip


def _fitted(columns: _Columns, one: Tested, q: float, *, found: bool) -> Relation:
    p, given, places, e = one
    rows = columns.known(places)
    names = tuple(columns.names[j] for j in places)
    if not e:
        x, y = (columns.logs[rows, j] for j in places)
        fit = fit_pair(x, y)
        interval = next(iter(fit.intervals.values()))
        error = out_of_sample(x, y, fit)
        return Relation(
            fit.kind, names, fit.coefficients, interval, fit.scatter, error, len(rows), p, q, given, found
        )
    sums = columns.logs[np.ix_(rows, places)] @ np.array(e)
    spread, n = _scatter(sums), len(rows)
    far = np.abs(sums - np.median(sums)) > 3 * max(spread, 1e-12)
    kept = sums[~far] if n >= FEWEST_TO_TRIM else sums
    from scipy.stats import t

    half = t.ppf(0.975, max(len(kept) - 1, 1)) * kept.std(ddof=1) / np.sqrt(len(kept))
    mean = float(kept.mean())
    error = float(kept.std(ddof=1) * np.sqrt(1 + 1 / len(kept)))
    coefficients = {name: float(x) for name, x in zip(names, e, strict=True)} | {
        "constant": float(np.exp(mean))
    }
    interval = (float(np.exp(mean - half)), float(np.exp(mean + half)))
    return Relation(
        "power", names, coefficients, interval, float(kept.std(ddof=1)), error, n, p, q, given, found
    )
