"""Analysis: everything the general method says of one model, computed once and shown in several ways.

    units       remove one scale for each independent dimension           `dimensional`, `groups`
    structure   removes scalings that are no units                        `symmetry.scalings`
    outputs     cannot see some of what is left                           `symmetry.identifiability`

Invariant: nothing here is rounded; what a page shows is text made from these exact values.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import sympy as sp

from similitude.dimensional.base_advice import BaseAdvice, advise_base
from similitude.dimensional.matrix import DimensionMatrix, dimension_matrix
from similitude.dimensional.pi_groups import pi_groups
from similitude.invariance.invariances import Invariances, invariances
from similitude.model import Model
from similitude.rewriting.equivalence import Equivalence, prove_equivalence
from similitude.rewriting.rewritten import Rewritten, rewrite
from similitude.symmetry.check import ScalingCheck
from similitude.symmetry.equations import Equations, equations_of
from similitude.symmetry.identifiability import Identifiability, identifiable
from similitude.symmetry.lattice import canonical, integers, kernel
from similitude.symmetry.scalings import Scalings, scalings_of
from similitude.symmetry.short_rows import shortened


@dataclass(frozen=True)
class NamedGroup:
    """A Pi group with the name it has on every page, the parameter it measures, and words for it."""

    name: str
    exponents: Mapping[str, Fraction]
    parameter: str = ""
    meaning: str = ""


@dataclass(frozen=True)
class CheckedRow:
    """One invariance of one output: sum of coefficient times sensitivity equals ``rhs`` [-].

    ``residual`` [-] is what is left of it, zero where it is proven.
    """

    output: str
    dimension: str
    coefficients: Mapping[str, Fraction]
    rhs: Fraction
    residual: float


@dataclass(frozen=True)
class Analysis:
    """A model and what was found about it.

    ``base`` is empty and ``rewritten`` None where no parameters can measure everything; ``why`` then says so,
    and ``groups`` are those of all variables. ``rows_after``: how many rows of the rewritten model couple any
    sensitivities; none, as it has no dimension left. ``beyond``: scalings that are no units.
    ``steady``: what the outputs tell while signals among the parameters are held, None where there
    are none.
    """

    model: Model
    equations: Equations
    base: tuple[str, ...]
    base_origin: str
    why: str
    matrix: DimensionMatrix
    invariances: tuple[CheckedRow, ...]
    groups: tuple[NamedGroup, ...]
    rewritten: Rewritten | None
    equivalence: Equivalence | None
    rows_after: int | None
    scalings: Scalings
    check: ScalingCheck
    beyond: tuple[Mapping[str, int], ...]
    seen: Identifiability
    steady: Identifiability | None
    meanings: Mapping[str, str] = field(default_factory=dict)

    @property
    def units(self) -> int:
        """How many of the scalings are units."""
        return self.matrix.rank


def analyze_model(
    model: Model,
    *,
    base: Sequence[str] | None = None,
    base_origin: str = "",
    meanings: Mapping[str, str] = {},
) -> Analysis:
    """Look a model over.

    Parameters
    ----------
    model : Model
    base : repeating variables; advised where left out.
    base_origin : who chose the base, for the page.
    meanings : parameter -> what its group tells, in words.

    Returns
    -------
    Analysis

    Raises
    ------
    ModelError    the base cannot measure the model, or a rate is no formula.
    """
    equations = equations_of(model)
    matrix = _matrix(model, equations)
    why = ""
    if base is None:
        advice = advise_base(model)
        base, base_origin = advice.best, "advised"
        why = "" if base is not None else _no_base(advice)
    rewritten = None if base is None else rewrite(model, base=base)
    scalings = scalings_of(equations, prefer=base or ())
    return Analysis(
        model=model,
        equations=equations,
        base=tuple(base or ()),
        base_origin=base_origin,
        why=why,
        matrix=matrix,
        invariances=_invariances(model),
        groups=_groups(model, matrix, rewritten, meanings),
        rewritten=rewritten,
        equivalence=None if rewritten is None else prove_equivalence(rewritten),
        rows_after=None if rewritten is None else _rows_left(rewritten.model),
        scalings=scalings,
        check=scalings.verify(),
        beyond=_beyond(scalings, matrix, base),
        seen=identifiable(model),
        steady=identifiable(model, held=model.signals) if model.signals else None,
        meanings=dict(meanings),
    )


def _invariances(model: Model) -> tuple[CheckedRow, ...]:
    """The rows of every output, over time where there are states, proven in symbols."""
    checked = []
    for output in model.output_map:
        found = _of_output(model, output)
        left = found.verify()
        checked += [
            CheckedRow(output, row.dimension, row.coefficients, row.rhs, _residual(left[row.dimension]))
            for row in found.rows
        ]
    return tuple(checked)


def _rows_left(model: Model) -> int:
    """Rows that are not empty, over all outputs."""
    return sum(not row.is_empty for output in model.output_map for row in _of_output(model, output).rows)


def _of_output(model: Model, output: str) -> Invariances:
    return invariances(model, output, response="time" if model.states else "steady_state")


def _residual(left: sp.Expr) -> float:
    """Zero where a row is proven, the largest value found where it is only found to hold."""
    return float(left) if left.is_number else math.inf


def _matrix(model: Model, equations: Equations) -> DimensionMatrix:
    """Dimensions of time and of every quantity, as one table."""
    units = {equations.time: model.time_unit} if equations.time in equations.names else {}
    units |= {q.name: q.unit for q in model.quantities}
    return dimension_matrix(units, angle=False)


def _no_base(advice: BaseAdvice) -> str:
    first = str(advice).splitlines()[0]
    return first.removeprefix("No base: ") if first.startswith("No base") else first


def _groups(
    model: Model, matrix: DimensionMatrix, rewritten: Rewritten | None, meanings: Mapping[str, str]
) -> tuple[NamedGroup, ...]:
    if rewritten is not None:
        return tuple(
            NamedGroup(
                g.name,
                dict(g.exponents),
                g.parameter,
                meanings.get(g.parameter) or _words(model, g.parameter),
            )
            for g in rewritten.groups.groups
        )
    units = {q.name: q.unit for q in model.quantities}
    everything = {name: units.get(name, model.time_unit) for name in matrix.names}
    return tuple(NamedGroup(f"pi{i + 1}", exponents) for i, exponents in enumerate(pi_groups(everything)))


def _words(model: Model, parameter: str) -> str:
    return model.quantity(parameter).meaning


def _beyond(
    scalings: Scalings, matrix: DimensionMatrix, base: Sequence[str] | None
) -> tuple[Mapping[str, int], ...]:
    """Scalings that are independent of the units' and of one another, each with few names."""
    names = scalings.equations.names
    rows = [[row.get(name, 0) for name in names] for row in scalings.weights]
    held = list(base) if base is not None else [matrix.names[place] for place in matrix.leading[0]]
    at_base = [[row[names.index(name)] for row in rows] for name in held]
    mixes = kernel(at_base, len(rows))  # with the base held the units have no part in them
    free = [
        [sum(c * row[j] for c, row in zip(mix, rows, strict=True)) for j in range(len(names))]
        for mix in mixes
    ]
    columns = [matrix.column(name) for name in names]
    units = [integers(row) for row in zip(*columns, strict=True) if any(row)]
    short = shortened(canonical(free, len(names)), units)
    return tuple({n: w for n, w in zip(names, row, strict=True) if w} for row in short)
