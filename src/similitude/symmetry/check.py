"""ScalingCheck: the scalings and the reduced system held against the equations, by other routes.

    scaled     f_i(lambda^w z) against lambda^(w_i - w_t) f_i(z), at random points and random lambda
    restored   each original rate against what the reduced system and the way back make of it
    missed     scalings that exist and were not found: n - count - rank of (z_j d ln F_i/dz_j) over random
               points, F_i = t f_i/x_i, without taking the equations apart

Invariant: nothing of `relations` is used here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np
import sympy as sp

from similitude.symmetry.arithmetic import DIGITS, BadPoint, Digits, Floats, Modular, run
from similitude.symmetry.equations import Equations
from similitude.symmetry.reduced_system import ReducedSystem
from similitude.symmetry.row_space import reduced
from similitude.symmetry.tape import Tape, record

EXACT = 1e-40  # relative; rounding at DIGITS digits is near 1e-58
ZERO = 1e-45  # what cancels at values near one is below it
POINTS = 3
SPARE = 4  # points more than a rate has variables, for the rank
FLAT = 1e-9  # singular values below this share of the largest are zero
TRIES = 30


@dataclass(frozen=True)
class ScalingCheck:
    """Largest relative deviations [-], and how many scalings were missed; true where all is well."""

    scaled: float
    restored: float
    missed: int

    def __bool__(self) -> bool:
        return self.scaled < EXACT and self.restored < EXACT and not self.missed


def check_scalings(
    equations: Equations, weights: Sequence[Mapping[str, int]], reduced: ReducedSystem
) -> ScalingCheck:
    """Hold scalings and reduced system against the equations.

    Raises
    ------
    ModelError    the equations are singular wherever they were tried.
    """
    with mpmath.workdps(DIGITS):
        scaled = _scaled(equations, weights)
        restored = _restored(equations, reduced)
    return ScalingCheck(scaled, restored, _missed(equations, len(weights)))


def _sides(equations: Equations) -> dict[str, sp.Expr]:
    """Name -> what it, or its rate, equals."""
    kept = {f"d{name}/dt": rate for name, rate in equations.rates.items()}
    return kept | {name: value for name, value in equations.relations.items()}


def _scaled(equations: Equations, weights: Sequence[Mapping[str, int]]) -> float:
    sides = _sides(equations)
    tape, names, time = record(sides.values()), equations.names, equations.time
    left = [name[1:].removesuffix("/dt") if name.endswith("/dt") else name for name in sides]

    def once(rng: np.random.Generator) -> float:
        field = Digits()
        point = dict(zip(names, field.draw(rng, len(names)), strict=True))
        factor = dict.fromkeys(names, mpmath.mpf(1))
        for row, scale in zip(weights, field.draw(rng, len(weights)), strict=True):
            for name, power in row.items():
                factor[name] *= scale**power
        here = run(tape, field, {n: np.array([x], dtype=object) for n, x in point.items()})
        there = run(tape, field, {n: np.array([x * factor[n]], dtype=object) for n, x in point.items()})
        worst = 0.0
        for side, name, a, b in zip(sides, left, here, there, strict=True):
            by = factor[name] / (factor[time] if side.endswith("/dt") else mpmath.mpf(1))
            worst = max(worst, _deviation(a[0] * by, b[0]))
        return worst

    return max(_at_points(once))


def _restored(equations: Equations, reduced: ReducedSystem) -> float:
    states = [name for name in equations.states if name in reduced.rates]
    rates = [equations.rates[name] for name in states]
    tape = record([*rates, *(reduced.restore(name) for name in states)])
    names = sorted({s.name for e in rates for s in e.free_symbols} | set(equations.names))
    names += [f"drift_{name}" for name in reduced.base if name in equations.signals]

    def once(rng: np.random.Generator) -> float:
        field = Digits()
        point = {
            n: np.array([x], dtype=object) for n, x in zip(names, field.draw(rng, len(names)), strict=True)
        }
        values = run(tape, field, point)
        pairs = zip(values[: len(states)], values[len(states) :], strict=True)
        return max((_deviation(a[0], b[0]) for a, b in pairs), default=0.0)

    return max(_at_points(once))


def _deviation(a, b) -> float:
    size = max(abs(a), abs(b))
    return float(abs(a - b) / size) if size > ZERO else 0.0


def _at_points(once) -> list[float]:
    """Results at POINTS points where nothing is singular."""
    found, seed = [], 0
    while len(found) < POINTS:
        try:
            found.append(once(np.random.default_rng(seed)))
        except BadPoint:
            if seed > TRIES * POINTS:
                raise
        seed += 1
    return found


def _missed(equations: Equations, count: int) -> int:
    """Scalings beyond `count`: in floats, and where that finds any, without losing small terms."""
    time = sp.Symbol(equations.time, real=True)
    sides = [time * rate / sp.Symbol(name, real=True) for name, rate in equations.rates.items()]
    sides += [value / sp.Symbol(name, real=True) for name, value in equations.relations.items()]
    tapes = [
        (record([side]), sorted(s.name for s in side.free_symbols)) for side in sides if side.free_symbols
    ]
    total = len(equations.names) - count
    if total == _rank(tapes, equations.names, Floats()):
        return 0
    exact = all(tape.rational and not tape.branches for tape, _ in tapes)
    with mpmath.workdps(DIGITS):
        return total - _rank(tapes, equations.names, Modular() if exact else Digits())


def _rank(tapes: Sequence[tuple[Tape, list[str]]], names: Sequence[str], field) -> int:
    """Rank of all gradients together."""
    place = {name: j for j, name in enumerate(names)}
    blocks = [np.zeros((0, len(names)), dtype=field.dtype)]
    for tape, used in tapes:
        small = _basis(_gradients(tape, used, field))
        wide = np.zeros((len(small), len(names)), dtype=field.dtype)
        wide[:, [place[name] for name in used]] = small
        blocks.append(wide)
    return len(_basis(np.concatenate(blocks)))


def _gradients(tape: Tape, used: Sequence[str], field) -> np.ndarray:
    """Rows z_j d ln F/dz_j (points, n) at random points of the names used."""
    rows, seed = [], 0
    while len(rows) < len(used) + SPARE and seed < TRIES + len(used) + SPARE:
        draws = field.draw(np.random.default_rng([seed, 7]), len(used))
        draws = np.exp(2 * draws - 2) if field.dtype is np.float64 else draws  # far apart, for the condition
        seed += 1
        values = {}
        for k, (name, z) in enumerate(zip(used, draws, strict=True)):
            values[name] = np.zeros(1 + len(used), dtype=field.dtype)
            values[name][[0, 1 + k]] = z
        try:
            value = run(tape, field, values)[0]
            rows.append(field.wrap(value[1:] * field.inverse(value[:1])))
        except BadPoint:
            continue
    return np.array(rows, dtype=field.dtype).reshape(-1, len(used))


def _basis(rows: np.ndarray) -> np.ndarray:
    """Rows (rank, n) that span the same; in floats those along which the rows are not flat."""
    if rows.dtype != np.float64:
        return reduced(rows)[0]
    sizes = np.linalg.norm(rows, axis=1, keepdims=True)
    straight = np.where(sizes > FLAT, rows / np.where(sizes > FLAT, sizes, 1.0), 0.0)
    _, singular, directions = np.linalg.svd(straight, full_matrices=False)
    return directions[singular > FLAT * singular[0]] if singular.size and singular[0] else directions[:0]
