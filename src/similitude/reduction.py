"""Reduction: which unknowns to carry in place of the groups, and how the groups follow from them.

Invariant: every group of the rewritten model is an expression in the unknowns and in the known
scales, so the reduced rates hold nothing else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import sympy as sp

from similitude.errors import ModelError
from similitude.groups import Groups
from similitude.saturation import Saturation


@dataclass(frozen=True)
class Unknown:
    """A slow unknown; its uncertainty is that of its logarithm where ``kind`` is ``log``.

    ``role``: ``identify`` (the first one: may change at any time), ``estimate`` (constant, learnt),
    ``seldom`` (constant, learnt from one sample in a while: what it trades against is learnt first),
    ``beyond`` (constant, what bends the model beyond its linear range: there it learns from every sample, and
    the others from one in a while),
    ``consider`` (constant, kept at its prior while its uncertainty is carried along).
    """

    name: str
    unit: str
    kind: Literal["log", "linear"]
    role: Literal["identify", "estimate", "seldom", "beyond", "consider"]
    meaning: str

    @property
    def symbol(self) -> sp.Symbol:
        """The symbol of the unknown's value (not of its logarithm)."""
        return sp.Symbol(self.name, real=True)

    @property
    def jacobian(self) -> sp.Expr:
        """d(value)/d(coordinate): the value itself for a logarithm, one otherwise."""
        return self.symbol if self.kind == "log" else sp.Integer(1)


@dataclass(frozen=True)
class Reduction:
    """The rewritten model in the chosen unknowns; the first unknown is the one to identify.

    ``live`` is the condition, in scales and in ``<unknown>_prior``, under which the dynamics can
    be seen at all at the sample's scales.

    Raises
    ------
    ModelError    a group has no expression, or an expression uses an unknown that is not listed.
    """

    groups: Groups
    unknowns: tuple[Unknown, ...]
    substitution: Mapping[str, sp.Expr]
    live: sp.Basic

    def __post_init__(self) -> None:
        missing = sorted({g.name for g in self.groups.groups} - set(self.substitution))
        known = {u.name for u in self.unknowns} | set(self.groups.base)
        used = {s.name for e in self.substitution.values() for s in sp.sympify(e).free_symbols}
        if missing or used - known:
            names = missing or sorted(used - known)
            raise ModelError(
                f"reduction of {self.groups.model.name!r}: {', '.join(names)} "
                + ("has no expression" if missing else "is neither an unknown nor a scale"),
                usually="A group was forgotten, or an unknown was left out of the list.",
                paste=f"substitution={{..., {names[0]!r}: ...}}",
                read="docs/architecture.md, 'Reduction'",
            )

    def _reduce(self, expression: sp.Expr) -> sp.Expr:
        replace = {g.symbol: self.substitution[g.name] for g in self.groups.groups}
        reduced = sp.sympify(expression).subs(replace, simultaneous=True)
        logs = [u.symbol for u in self.unknowns if u.kind == "log"]
        saturated = {f: sp.Dummy(f"s{i}", real=True) for i, f in enumerate(_saturations(reduced))}
        back = {dummy: f.func(sp.factor(f.args[0])) for f, dummy in saturated.items()}
        return _structured(reduced.xreplace(saturated), logs).xreplace(back)

    @property
    def rates(self) -> dict[str, sp.Expr]:
        """d(x*)/d(t*) in dimensionless states and inputs, unknowns and scales."""
        return {name: self._reduce(rate) for name, rate in self.groups.rates.items()}

    @property
    def output_map(self) -> dict[str, sp.Expr]:
        """Dimensionless outputs in the same symbols."""
        return {name: self._reduce(out) for name, out in self.groups.output_map.items()}


def _saturations(expression: sp.Expr) -> list[sp.Expr]:
    return sorted(expression.atoms(Saturation), key=sp.default_sort_key)


def _structured(expression: sp.Expr, symbols: list[sp.Symbol]) -> sp.Expr:
    """The expression as nested sums of powers of the symbols with factored coefficients.

    A rate then reads as its forces do, and its derivatives share them.
    """
    if not symbols:
        return sp.factor(expression)
    parts = sp.collect(sp.expand(expression), symbols[0], evaluate=False)
    return sp.Add(*(power * _structured(part, symbols[1:]) for power, part in parts.items()))
