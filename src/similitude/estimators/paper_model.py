"""What the paper's regression takes from a model: its linear z-coefficients m1, m2, in symbols.

Invariant: nothing here knows a bicycle; a model the regression does not hold for is refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from similitude.errors import ModelError
from similitude.estimators import filter_fields as ff
from similitude.reduction import Reduction


@dataclass(frozen=True)
class Regression:
    """The paper's linear z-coefficients of a reduced model, in symbols.

    ``numerator`` = m1/T and ``denominator`` = m2/T in the groups and in ``<group>_slope``;
    ``unknown`` the group that is regressed, ``slopes`` the groups taken proportional to it.
    ``per_target`` = unknown group / unknown of the reduction, in the scales.
    """

    reduction: Reduction
    unknown: str
    slopes: tuple[str, ...]
    numerator: sp.Expr
    denominator: sp.Expr
    per_target: sp.Expr

    @property
    def layout(self) -> ff.Layout:
        """Names of input, output and scales, as every estimator of the reduction has them."""
        return ff.Layout(self.reduction)

    @property
    def speed(self) -> str:
        """The scale that is measured along; the bicycle's U."""
        return self.layout.signals[0].name

    @property
    def known(self) -> tuple[str, ...]:
        """Groups and slopes that are frozen at given values, in the order of the groups."""
        used = {s.name for e in (self.numerator, self.denominator) for s in e.free_symbols}
        names = [n for g in self.reduction.groups.groups for n in (g.name, f"{g.name}_slope")]
        return tuple(n for n in names if n in used)

    @property
    def regressors(self) -> tuple[sp.Expr, sp.Expr]:
        """What a unit of the unknown adds to y per change of input and of output, in the scales (eq 22)."""
        groups, layout = self.reduction.groups, self.layout
        into, out = groups.scale[layout.input.name], groups.scale[layout.output.name]
        per_step = self.per_target * sp.Symbol("sample_time", real=True) / groups.time_scale
        return sp.simplify(per_step * out / into) * self.numerator, sp.simplify(per_step) * self.denominator

    @property
    def constants(self) -> tuple[sp.Expr, sp.Expr]:
        """What the measured scale leaves alone: of the input over that of the output; one over the latter."""
        scale = sp.Symbol(self.speed, real=True)
        by_input, by_output = (e.as_independent(scale)[0] for e in self.regressors)
        return by_input / by_output, 1 / by_output

    def changing(self, scale: Mapping[sp.Symbol, sp.Expr]) -> tuple[sp.Expr, sp.Expr]:
        """Of the regressors what the measured scale changes, at the scale that is given."""
        symbol = sp.Symbol(self.speed, real=True)
        by_input, by_output = (e.as_independent(symbol)[1].xreplace(dict(scale)) for e in self.regressors)
        return by_input, by_output


def regression(
    reduction: Reduction, *, unknown: str = "pi3", slopes: tuple[str, ...] = ("pi4",)
) -> Regression:
    """Derive the linear z-coefficients m1, m2 of a second-order model with one input and output.

    With x' = A x + B u, y = C x in dimensionless time and every group of ``slopes`` proportional
    to ``unknown``, the zero-order hold over a short step T has b1 = -b2 = m1 pi and
    a1 + 2 = 1 - a2 = m2 pi with m1 = T d(C B)/d(pi), m2 = -T d(trace A)/d(pi).

    Parameters
    ----------
    reduction : Reduction    its first unknown is proportional to the group ``unknown``.
    unknown : the group to identify.
    slopes : groups frozen as slope x unknown.

    Raises
    ------
    ModelError    not second order, not linear, a direct feedthrough, or C B or trace A is not
                  proportional to ``unknown``: the regression does not hold for such a model.

    References
    ----------
    Brennan & Alleyne 2004, eqs 20-23 (with T once in m2, as its eq 23 has it).
    """
    groups, pi = reduction.groups, sp.Symbol(unknown, real=True)
    model = groups.model
    A, B, C = proportional_matrices(reduction, unknown=unknown, slopes=slopes)
    rates = [sp.simplify(e / pi) for e in ((C * B)[0], -A.trace())]
    if any(pi in e.free_symbols for e in rates):
        raise _error(model.name, f"has C B or trace A that is not proportional to {unknown}")
    target = reduction.unknowns[0].symbol
    per_target = sp.simplify(reduction.substitution[unknown] / target)
    if per_target.free_symbols - {sp.Symbol(n, real=True) for n in groups.base}:
        raise _error(model.name, f"has {unknown} that is not a scale times {target.name}")
    return Regression(reduction, unknown, tuple(slopes), rates[0], rates[1], per_target)


def proportional_matrices(
    reduction: Reduction, *, unknown: str, slopes: tuple[str, ...]
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """A, B, C in dimensionless time with ``slopes`` proportional to ``unknown``: C (s - A)^-1 B is eq 20.

    Parameters
    ----------
    reduction, unknown, slopes : as of `regression`; a slope's factor is the symbol ``<group>_slope``.

    Raises
    ------
    ModelError    not two states, one input, one output and one scale measured along, not linear, or a
                  direct feedthrough.

    References
    ----------
    Brennan & Alleyne 2004, eq 20.
    """
    groups = reduction.groups
    model, pi = groups.model, sp.Symbol(unknown, real=True)
    slope = {sp.Symbol(n, real=True): sp.Symbol(f"{n}_slope", real=True) * pi for n in slopes}
    fixed = {sp.Symbol(n, real=True): e for n, e in groups.constraints.items()}
    if (len(model.states), len(model.inputs), len(model.outputs)) != (2, 1, 1):
        raise _error(model.name, "needs two states, one input and one output")
    if len(model.signals) != 1:
        raise _error(model.name, "needs one scale that is measured along")
    x, u = sp.Matrix([q.symbol for q in model.states]), sp.Matrix([model.inputs[0].symbol])
    f = sp.Matrix([groups.rates[q.name] for q in model.states]).subs(fixed).subs(slope)
    g = sp.Matrix([groups.output_map[model.outputs[0].name]]).subs(fixed).subs(slope)
    A, B, C, D = f.jacobian(x), f.jacobian(u), g.jacobian(x), g.jacobian(u)
    signals = set(x) | set(u)
    if D != sp.zeros(1, 1) or any(m.free_symbols & signals for m in (A, B, C)):
        raise _error(model.name, "must be linear, without a direct feedthrough")
    return A, B, C


def _error(model: str, what: str) -> ModelError:
    return ModelError(
        f"model {model!r} {what}",
        usually="The paper's regression holds for one kind of model only.",
        paste="similitude identify LOG --estimator population",
        read="docs/architecture.md, 'Estimators'",
    )
