"""The structs of the paper's regression: what it is told, what it remembers, what it hands out.

Invariant: sample and output begin as those of the population filter do, so one loop runs both.
"""

from __future__ import annotations

from similitude.estimators import filter_fields as ff
from similitude.estimators.high_pass_section import poles_fields, section_fields
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Field


def config_fields(r: Regression) -> tuple[Field, ...]:
    """What the regression is told once: scales, frozen groups, filter and the paper's constants."""
    i, o, signal, target = r.layout.input, r.layout.output, r.layout.signals[0], r.reduction.unknowns[0]
    validity = r.reduction.groups.model.validity
    unit = validity[1].unit if validity else "-"
    return (
        *(Field(q.name, q.unit, q.meaning) for q in r.layout.scales),
        *(Field(n, "-", f"frozen {n.replace('_slope', f'/{r.unknown}')}") for n in r.known),
        Field("sample_time", "s", "sample time the filters are designed for"),
        *poles_fields(),
        Field(f"{r.unknown}_start", "-", f"{r.unknown} before the first update"),
        Field("normal_start", "-", "sum of squared regressors before the first update, dimensionless"),
        Field("normal_least", f"({o.unit})^2/({target.unit})^2", "added at each update, > 0"),
        Field("forgetting", "-", "share of the past kept at each update"),
        Field("dead_zone", o.unit, f"|{o.name}| that must be exceeded for an update"),
        Field("settle_samples", "-", "whole samples in a row before an update, 3 or more"),
        Field("noise_variance", f"({o.unit})^2", f"least variance of {o.name} a sample, > 0"),
        Field(f"{target.name}_low", target.unit, f"least {target.name} that is reported, > 0"),
        Field(f"{target.name}_limit", target.unit, f"greatest magnitude of {target.name}"),
        Field("variance_limit", "-", "greatest variance that is reported"),
        Field("dt_low", "s", "shortest step that counts as one sample"),
        Field("dt_high", "s", "longest step that counts as one sample"),
        Field(f"{signal.name}_least", signal.unit, f"least {signal.meaning} to learn at, > 0"),
        Field("input_limit", i.unit, f"greatest believable {i.name}"),
        Field("output_limit", o.unit, f"greatest believable {o.name}"),
        Field("output_jump", o.unit, f"greatest believable change of {o.name} in one sample"),
        Field("signal_limit", signal.unit, "greatest believable scale"),
        Field("validity_limit", unit, "edge of the model's linear range"),
    )


def state_fields(r: Regression) -> tuple[Field, ...]:
    """What the regression remembers between samples."""
    i, o, signal, target = r.layout.input, r.layout.output, r.layout.signals[0], r.reduction.unknowns[0]
    return (
        Field("from_input", "-", "regressor per change of input, but for what the scale changes"),
        Field("from_output", "-", "the same per change of output"),
        Field("theta", target.unit, f"{target.name} of the regression"),
        Field("normal", f"({o.unit})^2/({target.unit})^2", "sum of squared regressors, forgetting"),
        Field("mean_square", f"({o.unit})^2", "mean square of the residual"),
        Field("weight", "-", "updates the mean square rests on"),
        Field("information", "-", f"information gained about ln {target.name}"),
        Field("log_variance", "-", f"variance of ln {target.name} at the last update"),
        *section_fields("input", i.unit),
        *section_fields("output", o.unit),
        Field(f"last_{signal.name}", signal.unit, f"last {signal.meaning} fast enough to learn"),
        Field("wait", "-", "usable samples until the filters have settled"),
    )


def output_fields(r: Regression) -> tuple[Field, ...]:
    """What each step hands out; always finite; that of the population filter and one more."""
    return (*ff.output_fields(r.layout), Field(r.unknown, "-", "group at the last usable scale"))
