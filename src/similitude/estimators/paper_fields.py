"""The structs of the paper's regression: what it is told, what it remembers, what it hands out.

Invariant: sample and output begin as those of the population filter do, so one loop runs both.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.estimators.high_pass_section import poles_fields, section_fields
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Field


def config_fields(r: Regression) -> tuple[Field, ...]:
    """What the regression is told once: scales, frozen groups, filter and the paper's constants."""
    i, o, signal = r.layout.input, r.layout.output, r.layout.signals[0]
    unit_theta = theta_unit(r)
    validity = r.reduction.groups.model.validity
    unit = validity[1].unit if validity else "-"
    return (
        *_regressor_fields(r),
        *poles_fields(),
        Field("theta_start", unit_theta, "theta before the first update"),
        Field("normal_start", f"({o.unit})^2/({unit_theta})^2", "sum of squared regressors before it, > 0"),
        Field("normal_least", f"({o.unit})^2/({unit_theta})^2", "added to it at each update, > 0"),
        Field("forgetting", "-", "share of the past kept at each update"),
        Field("dead_zone", o.unit, f"|{o.name}| that must be exceeded for an update"),
        Field(
            "settle_samples", "-", "usable samples in a row until one may update, itself included, 4 or more"
        ),
        Field("noise_variance", f"({o.unit})^2", f"least variance of {o.name} a sample, > 0"),
        Field("theta_low", unit_theta, "least theta that is reported, > 0"),
        Field("theta_limit", unit_theta, "greatest magnitude of theta"),
        Field("variance_limit", "-", "greatest variance that is reported"),
        Field("sample_time", "s", "sample time the filters are designed for"),
        Field("dt_room", "s", "a step that is this much off is not one sample"),
        Field(f"{signal.name}_least", signal.unit, f"least {signal.meaning} to learn at, > 0"),
        Field("input_limit", i.unit, f"greatest believable {i.name}"),
        Field("output_limit", o.unit, f"greatest believable {o.name}"),
        Field("output_jump", o.unit, f"greatest believable change of {o.name} in one sample"),
        Field("signal_limit", signal.unit, "greatest believable scale"),
        Field("validity_limit", unit, "edge of the model's linear range"),
    )


def theta_unit(r: Regression) -> str:
    """Unit of what is regressed: the damping of a sample, at scale one."""
    scale = r.layout.signals[0]
    power = sp.degree(1 / r.changing({})[1], sp.Symbol(scale.name, real=True))
    return scale.unit if power == 1 else f"({scale.unit})^{power}"


def _regressor_fields(r: Regression) -> tuple[Field, Field]:
    """The frozen groups in two numbers."""
    i, o, target = r.layout.input, r.layout.output, r.reduction.unknowns[0]
    ratio, per_theta = (sp.sstr(sp.simplify(e)) for e in r.constants)
    unit = theta_unit(r)
    return (
        Field("input_ratio", f"({o.unit})/({i.unit})/({unit})", f"b1 over a1 + 2: {ratio}"),
        Field(f"{target.name}_per_theta", f"({target.unit})/({unit})", per_theta),
    )


def state_fields(r: Regression) -> tuple[Field, ...]:
    """What the regression remembers between samples."""
    i, o, signal, target = r.layout.input, r.layout.output, r.layout.signals[0], r.reduction.unknowns[0]
    unit_theta = theta_unit(r)
    return (
        Field("theta", unit_theta, f"(a1 + 2) {signal.name}, in proportion to {target.name}"),
        Field("normal", f"({o.unit})^2/({unit_theta})^2", "sum of squared regressors, forgetting"),
        Field("square_sum", f"({o.unit})^2", "sum of squared residuals, forgetting"),
        Field("weight", "-", "updates it rests on, forgetting"),
        *section_fields("input", i.unit),
        *section_fields("output", o.unit),
        Field(f"last_{signal.name}", signal.unit, f"last {signal.meaning} fast enough to learn"),
        Field("wait", "-", "usable samples until the filters have settled, 0 and less: they have"),
        Field("residual", o.unit, "by how much the newest output was predicted wrong"),
    )


def output_fields(r: Regression) -> tuple[Field, ...]:
    """What is handed out, always finite: what every estimator hands out, and the group."""
    return (*ff.estimate_fields(r.layout), Field(r.unknown, "-", "group at the last usable scale"))
