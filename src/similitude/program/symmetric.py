"""The covariance of a filter as straight-line statements on its upper triangle.

Invariant: P stays symmetric because only one half is stored; what is overwritten was read before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import sympy as sp

from similitude.program.ir import Assign, Field


class Symmetric:
    """Symbols of the upper triangle of an (n, n) symmetric matrix stored row by row."""

    def __init__(self, name: str, n: int) -> None:
        self.name = name
        self.n = n

    def index(self, i: int, j: int) -> int:
        """Place of entry (i, j) in the stored array."""
        i, j = min(i, j), max(i, j)
        return i * self.n - i * (i - 1) // 2 + j - i

    @property
    def size(self) -> int:
        """Number of stored entries, n (n + 1) / 2."""
        return self.n * (self.n + 1) // 2

    def field(self, unit: str, meaning: str) -> Field:
        """The array that holds it in a struct."""
        return Field(self.name, unit, meaning, self.size)

    def target(self, i: int, j: int) -> str:
        """Name to assign entry (i, j) to."""
        return self.field("-", "").symbols[self.index(i, j)].name

    def __getitem__(self, at: tuple[int, int]) -> sp.Symbol:
        return sp.Symbol(self.target(*at), real=True)


@dataclass(frozen=True)
class Shared:
    """Columns of F that are proportional in every dense row: entry_i * weight_k, summed over k once."""

    weights: Mapping[int, sp.Expr]
    entries: Mapping[int, sp.Expr]


def predict(
    P: Symmetric,
    rows: Mapping[int, Mapping[int, sp.Expr]],
    shared: Shared,
    *,
    decay: Mapping[int, sp.Expr],
    noise: Mapping[int, sp.Expr],
    beside: Callable[[int, Mapping[int, sp.Symbol]], list[Assign]] = lambda j, FP: [],
) -> list[Assign]:
    """P <- F P F' + Q.

    Parameters
    ----------
    rows : index -> {column: entry} of the dense rows of F (the dynamic states).
    shared : further columns of the dense rows, proportional to one another.
    decay : index -> diagonal entry of F for slow states that decay; one where absent.
    noise : index -> variance added [coordinate^2].
    beside : what else is worked out of a column of P and {dense row: F P}, both before the step.
    """
    FP = {(i, j): sp.Symbol(f"FP_{i}_{j}", real=True) for i in rows for j in range(P.n)}
    slow = [j for j in range(P.n) if j not in rows]
    lines = [line for j in rows for line in _times(P, rows, shared, FP, j)]
    lines += [line for j in rows for line in beside(j, {i: FP[i, j] for i in rows})]
    dense = [(i, j) for i in rows for j in rows if j >= i]
    for i, j in dense:
        full = sp.Add(*(FP[i, k] * e for k, e in rows[j].items() if k in rows))
        lines.append(Assign(P.target(i, j), full + (noise.get(i, 0) if i == j else 0)))
    for k in slow:  # in place, one column after the other, so that few values wait
        lines += _times(P, rows, shared, FP, k)
        lines += beside(k, {i: FP[i, k] for i in rows})
        lines += [Assign(P.target(i, k), FP[i, k] * decay.get(k, 1)) for i in rows]
        if any(k in row for row in rows.values()):
            lines += [Assign(P.target(i, j), P[i, j] + FP[i, k] * rows[j].get(k, 0)) for i, j in dense]
    for i in rows:
        lines.append(Assign(f"WPF_{i}", sp.Add(*(w * FP[i, k] for k, w in shared.weights.items()))))
    for i, j in dense:
        together = sp.Symbol(f"WPF_{i}", real=True)
        lines.append(Assign(P.target(i, j), P[i, j] + together * shared.entries[j]))
    for i in slow:
        for j in slow[slow.index(i) :]:
            factor = decay.get(i, 1) * decay.get(j, 1)
            added = noise.get(i, sp.Integer(0)) if i == j else sp.Integer(0)
            if factor != 1 or added != 0:
                lines.append(Assign(P.target(i, j), factor * P[i, j] + added))
    return lines


def _times(
    P: Symmetric,
    rows: Mapping[int, Mapping[int, sp.Expr]],
    shared: Shared,
    FP: Mapping[tuple[int, int], sp.Symbol],
    j: int,
) -> list[Assign]:
    """Column j of F P in the dense rows."""
    together = sp.Symbol(f"PW_{j}", real=True)
    lines = [Assign(together.name, sp.Add(*(w * P[k, j] for k, w in shared.weights.items())))]
    for i, row in rows.items():
        total = sp.Add(*(entry * P[k, j] for k, entry in row.items()), shared.entries[i] * together)
        lines.append(Assign(FP[i, j].name, total))
    return lines


def column(
    P: Symmetric, gradient: Mapping[int, sp.Expr], prefix: str, rows: Iterable[int] | None = None
) -> list[Assign]:
    """``<prefix>_i = (P H')_i`` for a measurement with the given gradient H; of all rows or those given."""
    return [
        Assign(f"{prefix}_{i}", sp.Add(*(entry * P[i, k] for k, entry in gradient.items())))
        for i in (range(P.n) if rows is None else rows)
    ]


def reduce_by(
    P: Symmetric,
    gains: Mapping[int, sp.Symbol],
    order: Mapping[int, int],
    prefix: str,
) -> list[Assign]:
    """Joseph's update where every gain is the optimal one or zero: P_ij -= g c_i c_j / S.

    With gains K_i = g_i c_i/S, g_i in {0, 1}, Joseph's P_ij - K_i c_j - c_i K_j + K_i K_j S is
    P_ij - max(g_i, g_j) c_i c_j/S. ``order`` ranks the gains by how often they are zero: a gain of
    higher order is zero wherever one of lower order is. Coordinates without a gain are considered.
    """
    lines = []
    for i in range(P.n):
        for j in range(i, P.n):
            able = [k for k in (i, j) if k in gains]
            if not able:
                continue
            first = min(able, key=lambda k: order[k])
            other = j if first == i else i
            reduced = P[i, j] - gains[first] * sp.Symbol(f"{prefix}_{other}", real=True)
            lines.append(Assign(P.target(i, j), reduced))
    return lines
