"""What a second-order system with one stiff unknown is as regressions: its coefficients, in symbols.

    y'' = K [ B1 s1 u' - M2 s2 y' - K1 s3 y ] + K^2 s4 [ G2 u - K2 y ]          (second order)
    y'  = K [ B1 s1 u  - M2 s2 y ]                                              (first order, fast band)

Derivatives are in seconds, y and u in their own units. B1, M2, K1, K2, G2 hold the frozen unknowns
alone, s1 … s4 the scales alone (of a car 1/L^2, 1/(L U), 1/L^2, 1/(L^3 U), with y/unit in the last
bracket), so K stays what it is while the scales change. What the change itself adds (dU/dt) is left out.

Invariant: nothing here knows a bicycle; a model the form does not hold for is refused.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from similitude.errors import ModelError
from similitude.estimators import filter_fields as ff
from similitude.reduction import Reduction


@dataclass(frozen=True)
class SecondOrder:
    """Coefficients of a reduced model as regressions in its first unknown.

    ``input_gain`` = B1, ``damping`` = M2, ``stiffness`` = K1, ``pair_output`` = K2 and ``pair_input``
    = G2 in the frozen unknowns; ``per_input_rate`` = s1, ``per_rate`` = s2, ``per_output`` = s3,
    ``per_pair_input``, ``per_pair_output`` (s4 and s4/unit) in the scales.
    """

    reduction: Reduction
    input_gain: sp.Expr
    damping: sp.Expr
    stiffness: sp.Expr
    pair_output: sp.Expr
    pair_input: sp.Expr
    per_input_rate: sp.Expr
    per_rate: sp.Expr
    per_output: sp.Expr
    per_pair_input: sp.Expr
    per_pair_output: sp.Expr

    @property
    def layout(self) -> ff.Layout:
        """Names of input, output and scales, as every estimator of the reduction has them."""
        return ff.Layout(self.reduction)

    @property
    def speed(self) -> str:
        """The scale that is measured along; the bicycle's U."""
        return self.layout.signals[0].name

    @property
    def target(self) -> str:
        """Name of the unknown that is identified."""
        return self.layout.target

    @property
    def frozen(self) -> tuple[str, ...]:
        """Names of the unknowns that are held at given values."""
        return self.layout.unknowns[1:]


def second_order(reduction: Reduction, *, unknown: str = "pi3") -> SecondOrder:
    """Derive the coefficients of a linear model with two states, one input and one output.

    With x' = A x + B u, y = C x in dimensionless time and pi the group ``unknown``, the transfer
    function's numerator is B1 pi s + G2 pi^2, its denominator s^2 + M2 pi s + K1 pi + K2 pi^2.

    Parameters
    ----------
    reduction : Reduction    its first unknown is proportional to the group ``unknown``.
    unknown : the group that carries it.

    Raises
    ------
    ModelError    not linear and of second order with one measured scale, or a coefficient has
                  another form in ``unknown``.

    References
    ----------
    Brennan & Alleyne 2004, eqs 19-20, for the bicycle.
    """
    groups, name = reduction.groups, reduction.groups.model.name
    A, B, C = _matrices(reduction)
    pi, target = sp.Symbol("pi", real=True), reduction.unknowns[0].symbol
    per = sp.simplify(reduction.substitution[unknown] / target)
    if per.free_symbols - {sp.Symbol(n, real=True) for n in groups.base}:
        raise _error(name, f"has {unknown} that is not a scale times {target.name}")
    forms = {
        "input": ((C * B)[0], 1),
        "damping": (-A.trace(), 1),
        "determinant": (A.det(), 2),
        "pair": ((C * (A - A.trace() * sp.eye(2)) * B)[0], 2),
    }
    found = {}
    for key, (expression, degree) in forms.items():
        poly = sp.Poly(sp.expand(sp.simplify(expression.subs(target, pi / per))), pi)
        if poly.degree() > degree or not poly.coeff_monomial(1).is_zero:
            raise _error(name, f"has a coefficient ({key}) of another form in {unknown}")
        found[key] = poly
    if not found["pair"].coeff_monomial(pi).is_zero:
        raise _error(name, f"has a steady response that does not go with {unknown} squared")
    tau, unit = groups.time_scale, groups.scale[reduction.groups.model.outputs[0].name]
    into = groups.scale[reduction.groups.model.inputs[0].name]

    def part(key: str, power: int) -> sp.Expr:
        return sp.factor(found[key].coeff_monomial(pi**power))

    return SecondOrder(
        reduction,
        input_gain=part("input", 1),
        damping=part("damping", 1),
        stiffness=part("determinant", 1),
        pair_output=part("determinant", 2),
        pair_input=part("pair", 2),
        per_input_rate=sp.simplify(per * unit / tau / into),
        per_rate=sp.simplify(per / tau),
        per_output=sp.simplify(per / tau**2),
        per_pair_input=sp.simplify(per**2 * unit / tau**2 / into),
        per_pair_output=sp.simplify(per**2 / tau**2),
    )


def _matrices(reduction: Reduction) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """A, B and C of the reduced model, refused where it is not linear or of another size."""
    model = reduction.groups.model
    if (len(model.states), len(model.inputs), len(model.outputs)) != (2, 1, 1):
        raise _error(model.name, "needs two states, one input and one output")
    if len(model.signals) != 1:
        raise _error(model.name, "needs one scale that is measured along")
    x, u = sp.Matrix([q.symbol for q in model.states]), sp.Matrix([model.inputs[0].symbol])
    f = sp.Matrix([reduction.rates[q.name] for q in model.states])
    g = sp.Matrix([reduction.output_map[model.outputs[0].name]])
    A, B, C, D = f.jacobian(x), f.jacobian(u), g.jacobian(x), g.jacobian(u)
    signals = set(x) | set(u)
    if D != sp.zeros(1, 1) or any(m.free_symbols & signals for m in (A, B, C)):
        raise _error(model.name, "must be linear, without a direct feedthrough")
    return A, B, C


def _error(model: str, what: str) -> ModelError:
    return ModelError(
        f"model {model!r} {what}",
        usually="The regressions of the ladder hold for one kind of model; the population filter for any.",
        paste="similitude identify LOG --estimator population",
        read='docs/estimators.md, "What they assume"',
    )
