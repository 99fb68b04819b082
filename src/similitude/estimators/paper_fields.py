"""The structs of the paper's regression: what it is told, what it remembers, what it hands out.

Invariant: sample and output begin as those of the population filter do, so one loop runs both.
"""

from __future__ import annotations

from similitude.estimators import filter_fields as ff
from similitude.estimators.biquad_section import BIQUAD
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Field


def config_fields(r: Regression) -> tuple[Field, ...]:
    """What the regression is told once: scales, frozen groups, filter and the paper's constants."""
    i, o, signal = r.layout.input, r.layout.output, r.layout.signals[0]
    validity = r.reduction.groups.model.validity
    unit = validity[1].unit if validity else "-"
    numbers = "b0, b1, b2, a1, a2 of the high-pass"
    return (
        *(Field(q.name, q.unit, q.meaning) for q in r.layout.scales),
        *(Field(n, "-", f"frozen {n.replace('_slope', f'/{r.unknown}')}") for n in r.known),
        Field("sample_time", "s", "sample time the filters are designed for"),
        Field("biquad_1", "-", f"first section: {numbers}", len(BIQUAD)),
        Field("biquad_2", "-", f"second section: {numbers}", len(BIQUAD)),
        Field(f"{r.unknown}_start", "-", f"{r.unknown} before the first update"),
        Field("P_start", "-", "P before the first update"),
        Field("forgetting", "-", "share of the past kept at each update"),
        Field("dead_zone", o.unit, f"|{o.name}| that must be exceeded for an update"),
        Field("settle_samples", "-", "whole samples in a row before an update, 3 or more"),
        Field("noise_variance", f"({o.unit})^2", f"least variance of {o.name} a sample, > 0"),
        Field(f"{r.unknown}_low", "-", f"least {r.unknown} that is reported, > 0"),
        Field(f"{r.unknown}_limit", "-", f"greatest magnitude of {r.unknown}"),
        Field("P_low", "-", "least P, > 0"),
        Field("P_high", "-", "greatest P"),
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
    i, o, signal = r.layout.input, r.layout.output, r.layout.signals[0]
    return (
        Field("m1_rate", "-", "m1/T"),
        Field("m2_rate", "-", "m2/T"),
        Field("m1", f"1/({i.unit})", "m1 per physical input at the last usable scale"),
        Field("m2", f"1/({o.unit})", "m2 per physical output, the same"),
        Field("unit", o.unit, "output per dimensionless output, the same"),
        Field("star", f"1/({o.unit})", "its reciprocal"),
        Field("inv_direct", "-", "1/weight of the newest output in the filter"),
        Field("inv_forgetting", "-", "1/forgetting factor"),
        Field("least_spread", f"({o.unit})^2", "least variance of the filtered second difference"),
        Field("theta", "-", f"{r.unknown} at the last usable scale"),
        Field("P", "-", "covariance of theta per residual variance"),
        Field("mean_square", "-", "mean square of the residual"),
        Field("weight", "-", "updates the mean square rests on"),
        Field("information", "-", f"information gained about ln {r.layout.target}"),
        Field("input_memory", i.unit, f"memory of both sections for {i.name}", 4),
        Field("output_memory", o.unit, f"memory of both sections for {o.name}", 4),
        Field("input_before", i.unit, f"filtered {i.name}, one and two samples ago", 2),
        Field("output_before", o.unit, f"filtered {o.name}, one and two samples ago", 2),
        Field("last_input", i.unit, "last usable input"),
        Field("last_measured", o.unit, "last usable measurement"),
        Field(f"last_{signal.name}", signal.unit, f"last {signal.meaning} fast enough to learn"),
        Field("fresh", "-", "usable samples in a row"),
        Field("started", "-", "0 before the first usable scale, 1 after"),
    )


def output_fields(r: Regression) -> tuple[Field, ...]:
    """What each step hands out; always finite; that of the population filter and one more."""
    return (*ff.output_fields(r.layout), Field(r.unknown, "-", "group at the last usable scale"))
