"""The structs that the ladder's own estimators (band, output_error, robust) have in common.

Invariant: sample and output begin as those of the population filter do, so one loop runs them all.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.estimators.held_sample import S, at_now, gate_config, gate_state, set_status
from similitude.estimators.least_squares import scatter_config, scatter_state
from similitude.estimators.second_order import SecondOrder
from similitude.program.ir import Assign, Field, Statement, When


def config_fields(model: SecondOrder, own: tuple[Field, ...]) -> tuple[Field, ...]:
    """Scales, frozen unknowns, the estimator's own numbers, limits, and the common rest."""
    layout, target = model.layout, model.reduction.unknowns[0]
    validity = model.reduction.groups.model.validity
    frozen = [u for u in model.reduction.unknowns if u.name in model.frozen]
    return (
        *(Field(q.name, q.unit, q.meaning) for q in layout.scales),
        *(Field(u.name, u.unit, f"frozen {u.meaning}") for u in frozen),
        *own,
        Field(f"{target.name}_start", target.unit, f"{target.name} before the first update"),
        Field(f"{target.name}_low", target.unit, f"least {target.name} of the population"),
        Field(f"{target.name}_high", target.unit, f"greatest {target.name} of the population"),
        *scatter_config(),
        *gate_config(model),
        Field("validity_limit", validity[1].unit if validity else "-", "edge of the model's linear range"),
    )


def state_fields(model: SecondOrder, own: tuple[Field, ...]) -> tuple[Field, ...]:
    """The unknown, the estimator's own state, scatter and gates."""
    target = model.reduction.unknowns[0]
    return (
        Field(target.name, target.unit, target.meaning),
        *own,
        *scatter_state(target.name),
        *gate_state(model),
    )


def output_fields(model: SecondOrder) -> tuple[Field, ...]:
    """What each step hands out; always finite; that of the population filter and one more."""
    return (
        *ff.output_fields(model.layout),
        Field("unknowns", "-", "unknowns the excitation carries now; 0 while nothing is learnt"),
    )


def learnt_status(model: SecondOrder) -> list[Statement]:
    """Status of a sample that was used."""
    lines: list[Statement] = [set_status("ok")]
    validity = model.reduction.groups.model.validity
    if validity is not None:
        now = at_now(model, validity[0]).xreplace({model.layout.output.symbol: S("y_now")})
        lines.append(When(now**2 > S("validity_limit") ** 2, (set_status("outside_linear"),)))
    half = sp.Rational(1, 2)
    return [*lines, When(S("edge") > half, (set_status("at_limit"),), (), "the population's edge")]


def hand_out(model: SecondOrder) -> list[Statement]:
    """The outputs that every step ends with; prediction and innovation stand already."""
    return [
        Assign("estimate", S(model.target)),
        Assign("variance", sp.Min(S("log_variance") + S("aged"), S("variance_limit"))),
        Assign("information_gained", S("information")),
    ]
