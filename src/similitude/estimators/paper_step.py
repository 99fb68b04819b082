"""The statements of the paper's regression: gates, filters, prediction, least squares.

Invariant: the history the regressor is read from is updated once a sample, after its last use.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.paper_fields import BIQUAD, state_fields
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When
from similitude.status import STATUS

HALF = sp.Rational(1, 2)


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def before_first(r: Regression) -> list[Statement]:
    """The statements of ``init``: m1/T and m2/T from the frozen groups, the rest at rest."""
    zero = [s.name for f in state_fields(r) for s in f.symbols]
    start = {
        "m1_rate": r.numerator,
        "m2_rate": r.denominator,
        "theta": S(f"{r.unknown}_start"),
        "P": S("P_start"),
        f"last_{r.speed}": S(f"{r.speed}_least"),
    }
    return [Assign(name, sp.sympify(start.get(name, 0))) for name in zero]


def one_sample(r: Regression) -> list[Statement]:
    """The statements of ``step``."""
    dt = S("dt")
    return [
        Assign("predicted", S("last_measured")),
        Assign("innovation", sp.Integer(0)),
        When(
            sp.And(dt > 0, dt < 1e6),
            (*_gates(r), *_scales(r), *_predict(r), *_learn(r), *_remember(r)),
            (Assign("status", sp.Integer(STATUS["bad_sample"])),),
            "time must advance",
        ),
        *_outputs(r),
    ]


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.And(x > -S(limit), x < S(limit))


def _status(name: str) -> Assign:
    return Assign("status", sp.Integer(STATUS[name]))


def _gates(r: Regression) -> list[Statement]:
    """Hold the last usable values over missing ones; say what the sample can be used for."""
    scale, last = S(r.speed), f"last_{r.speed}"
    inputs_fine = sp.And(_within(S("input"), "input_limit"), _within(scale, "signal_limit"))
    now = (Assign("u_now", S("input")), Assign("scale_now", scale))
    held = (Assign("u_now", S("last_input")), Assign("scale_now", S(last)))
    missing = (Assign("usable", sp.Integer(0)),)
    even = sp.And(S("dt") > S("dt_low"), S("dt") < S("dt_high"))
    at, old, theta = S("scale_now"), S(last), S("theta")
    per = r.per_target
    ratio = sp.simplify(per.xreplace({scale: at}) / per.xreplace({scale: old}))
    rescale = (
        Assign("ratio", ratio, f"of {r.unknown} for the same {r.layout.target}"),
        Assign("theta", theta * S("ratio")),
        Assign("P", S("P") * S("ratio") ** 2),
    )
    return [
        _status("not_excited"),
        Assign("usable", sp.Integer(1)),
        Assign("live", sp.Integer(1)),
        When(inputs_fine, now, (*held, *missing), "a missing input or scale is held"),
        When(
            _within(S("measured"), "output_limit"),
            (Assign("y_now", S("measured")),),
            (Assign("y_now", S("last_measured")), *missing),
            "a missing measurement is held",
        ),
        When(
            at > S(f"{r.speed}_least"),
            (
                When(S("started") > HALF, rescale, (), "same physical constant in the new scale"),
                Assign(last, at),
                Assign("started", sp.Integer(1)),
            ),
            (Assign("live", sp.Integer(0)), _status("too_slow")),
            "the dynamics cannot be seen",
        ),
        When(
            sp.And(sp.Not(even), S("fresh") > HALF),
            (Assign("fresh", sp.Integer(0)), _status("restarted")),
            (),
            "the samples before are not where the regression needs them",
        ),
        When(
            S("usable") > HALF,
            (Assign("fresh", sp.Min(S("fresh") + 1, S("settle_samples") + 1)),),
            (Assign("fresh", sp.Integer(0)), _status("no_measurement")),
        ),
    ]


def _scales(r: Regression) -> list[Statement]:
    """m1, m2 at the scale of now."""
    groups, layout = r.reduction.groups, r.layout
    at = {S(r.speed): S(f"last_{r.speed}")}
    return [
        Assign("T", S("sample_time") / groups.time_scale.xreplace(at), "dimensionless sample time"),
        Assign("star", 1 / groups.scale[layout.output.name].xreplace(at), "output to its group"),
        Assign("u_star", 1 / groups.scale[layout.input.name].xreplace(at), "input to its group"),
        Assign("m1", S("m1_rate") * S("T") * S("u_star")),
        Assign("m2", S("m2_rate") * S("T") * S("star")),
    ]


def _biquad(x: sp.Symbol, section: int, signal: str, name: str) -> list[Assign]:
    """One section, direct form II transposed; its output is the temporary ``name``."""
    b0, b1, b2, a1, a2 = (S(f"biquad_{section}_{i}") for i in range(len(BIQUAD)))
    first, second = (f"{signal}_memory_{2 * section - 2 + i}" for i in range(2))
    return [
        Assign(name, b0 * x + S(first)),
        Assign(first, b1 * x - a1 * S(name) + S(second)),
        Assign(second, b2 * x - a2 * S(name)),
    ]


def _predict(r: Regression) -> list[Statement]:
    """Regressor and one-step prediction from the past alone, then both filters.

    The filters' share of the newest value is known, so the filtered prediction is one of the raw
    output too: the raw value whose filtered value is the predicted one.
    """
    r1, r2 = S("output_before_0"), S("output_before_1")
    d1, d2 = S("input_before_0"), S("input_before_1")
    b1, b2 = S("biquad_1_0"), S("biquad_2_0")
    return [
        Assign("phi", S("m2") * (r2 - r1) + S("m1") * (d1 - d2), "regressor, eqs 25-26"),
        Assign("filtered", 2 * r1 - r2 + S("phi") * S("theta") / S("star"), "predicted, filtered"),
        Assign("rest", b2 * S("output_memory_0") + S("output_memory_2"), "filtered if r were 0"),
        Assign("predicted", (S("filtered") - S("rest")) / (b1 * b2)),
        When(S("usable") > HALF, (Assign("innovation", S("y_now") - S("predicted")),)),
        *_biquad(S("u_now"), 1, "input", "input_half"),
        *_biquad(S("input_half"), 2, "input", "input_filtered"),
        *_biquad(S("y_now"), 1, "output", "output_half"),
        *_biquad(S("output_half"), 2, "output", "output_filtered"),
    ]


def _learn(r: Regression) -> list[Statement]:
    """Recursive least squares with forgetting where the raw output exceeds the dead zone."""
    phi, theta, P, forgetting = (S(n) for n in ("phi", "theta", "P", "forgetting"))
    r0, r1, r2 = S("output_filtered"), S("output_before_0"), S("output_before_1")
    y_now, dead, limit = S("y_now"), S("dead_zone"), S(f"{r.unknown}_limit")
    used = sp.And(
        S("live") > HALF,
        S("fresh") > S("settle_samples"),
        sp.Or(y_now > dead, y_now < -dead),
    )
    weighted = sp.Max(S("mean_square"), S("noise_variance") / _raw_unit(r) ** 2)
    return [
        Assign("y", S("star") * (r0 - 2 * r1 + r2), "second difference, eq 24"),
        When(
            used,
            (
                Assign("residual", S("y") - phi * theta),
                Assign("gain", P * phi / (forgetting + phi * P * phi)),
                Assign("weight", forgetting * S("weight") + 1),
                Assign(
                    "mean_square",
                    S("mean_square") + (S("residual") ** 2 - S("mean_square")) / S("weight"),
                ),
                Assign("information", S("information") + (phi * theta) ** 2 / weighted),
                Assign("theta", theta + S("gain") * S("residual")),
                Assign("theta", sp.Max(sp.Min(theta, limit), -limit)),
                Assign("P", (1 - S("gain") * phi) * P / forgetting),
                Assign("P", sp.Max(sp.Min(P, S("P_high")), S("P_low"))),
                *_verdict(r),
            ),
            (),
            "outside the dead zone, filters settled",
        ),
    ]


def _verdict(r: Regression) -> list[Statement]:
    """Status of a sample that was used."""
    lines: list[Statement] = [_status("ok")]
    validity = r.reduction.groups.model.validity
    if validity is not None:
        now = {S(r.speed): S(f"last_{r.speed}"), r.layout.output.symbol: S("y_now")}
        square = validity[0].xreplace(now) ** 2
        lines.append(When(square > S("validity_limit") ** 2, (_status("outside_linear"),)))
    low = S("theta") <= S(f"{r.unknown}_low")
    return [*lines, When(low, (_status("at_limit"),), (), "no stiffness is zero or less")]


def _remember(r: Regression) -> list[Statement]:
    return [
        Assign("output_before_1", S("output_before_0")),
        Assign("output_before_0", S("output_filtered")),
        Assign("input_before_1", S("input_before_0")),
        Assign("input_before_0", S("input_filtered")),
        Assign("last_input", S("u_now")),
        Assign("last_measured", S("y_now")),
    ]


def _raw_unit(r: Regression) -> sp.Expr:
    """Raw output per dimensionless filtered output, for the newest sample alone."""
    scale = r.reduction.groups.scale[r.layout.output.name]
    return scale.xreplace({S(r.speed): S(f"last_{r.speed}")}) / (S("biquad_1_0") * S("biquad_2_0"))


def _outputs(r: Regression) -> list[Statement]:
    pi, spread = S(r.unknown), S("innovation_variance") / S("raw_unit") ** 2
    scale = {S(r.speed): S(f"last_{r.speed}")}
    uncertain = S("P") * spread / pi**2
    limit = S("variance_limit")
    return [
        Assign(r.unknown, sp.Max(S("theta"), S(f"{r.unknown}_low"))),
        Assign("estimate", pi / r.per_target.xreplace(scale)),
        Assign("raw_unit", _raw_unit(r)),
        Assign(
            "innovation_variance",
            sp.Max(S("mean_square") * S("raw_unit") ** 2, S("noise_variance")),
        ),
        Assign(
            "variance",
            sp.Piecewise((sp.Min(uncertain, limit), S("weight") > HALF), (limit, True)),
            f"of ln {r.layout.target}: scatter only, the noise's bias is not in it",
        ),
        Assign("information_gained", S("information")),
    ]
