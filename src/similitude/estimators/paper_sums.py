"""The paper's regression as two sums, for whole numbers: K = cross/normal, forgotten by a shift.

    normal <- (1 - 2^-k) normal + psi^2       psi = what a unit of K adds to the second difference
    cross  <- (1 - 2^-k) cross + psi change   change = second difference of the filtered output

This is the recursive least squares of `paper`, which moves K by psi times the residual over normal: the sums
lose nothing to rounding from sample to sample, and biquads keep formats where differences would need all
their digits. The mean square of the residual averages over the greatest power of two of updates made so far,
at most 2^k, in place of their number, which saves a division.

Filters, dead zone, outputs and status are those of `paper`; its gates are those of the other regressions.
Invariant: whatever the sample holds, the next usable samples count.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.estimators.biquad_section import biquad_fields, cascade
from similitude.estimators.held_sample import (
    HALF,
    S,
    at_now,
    gate_config,
    gate_state,
    gate_variables,
    gates,
    set_status,
)
from similitude.estimators.paper_fields import output_fields
from similitude.estimators.paper_model import Regression, regression
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction
from similitude.status import STATUS

R0, R1, R2 = S("output_filtered"), S("output_before_0"), S("output_before_1")
D0, D1, D2 = S("input_filtered"), S("input_before_0"), S("input_before_1")
EDGE = sp.Rational(65535, 65536)  # of the greatest magnitude: at it


def paper_sums(reduction: Reduction, *, unknown: str = "pi3", slopes: tuple[str, ...] = ("pi4",)) -> Program:
    """Derive the step program of the paper's regression in sums from a reduced model.

    Parameters
    ----------
    reduction, unknown, slopes : as `paper_regression` takes them.

    Returns
    -------
    Program    ``<model>_paper_fixed``, that the fixed profile is lowered from.

    Raises
    ------
    ModelError    the model is not one the regression holds for.

    References
    ----------
    Brennan & Alleyne 2004, eqs 21-27 and section 6.
    """
    r = regression(reduction, unknown=unknown, slopes=slopes)
    model = reduction.groups.model
    states = _state(r)
    return Program(
        name=f"{model.name}_paper_fixed",
        title=f"Regression of the paper for the {model.name} as two sums",
        provenance=(
            f"model: {model.name}, {model.source}",
            f"base: {', '.join(reduction.groups.base)}",
            f"unknown: {r.layout.target}; frozen: {', '.join(r.known)}",
            f"m1/T = {sp.sstr(r.numerator)}",
            f"m2/T = {sp.sstr(r.denominator)}",
        ),
        config=_config(r),
        state=states,
        sample=ff.sample_fields(r.layout),
        output=output_fields(r),
        variables=(*gate_variables(r), Field("started", "-", "1 after the first usable scale")),
        init=tuple(_start(r, states)),
        step=tuple(_step(r)),
        status=STATUS,
    )


def _config(r: Regression) -> tuple[Field, ...]:
    o, target = r.layout.output, r.reduction.unknowns[0]
    validity = r.reduction.groups.model.validity
    return (
        *(Field(q.name, q.unit, q.meaning) for q in r.layout.scales),
        *(Field(n, "-", f"frozen {n.replace('_slope', f'/{r.unknown}')}") for n in r.known),
        Field("sample_time", "s", "sample time the filters are designed for"),
        *biquad_fields(("high-pass", "high-pass")),
        Field(f"{target.name}_start", target.unit, f"{target.name} before the first update"),
        Field(f"{target.name}_low", target.unit, f"least {target.name} that is reported, > 0"),
        Field(f"{target.name}_limit", target.unit, f"greatest magnitude of {target.name}"),
        Field("psi_limit", "-", "greatest believable regressor, in its units"),
        Field("normal_start", "-", "sum of squares before the first update, in units of psi squared"),
        Field("forgetting", "-", "share of the past kept at each update, 1 - 2^-k"),
        Field("updates_most", "-", "updates the mean square averages over, 2^k"),
        Field("dead_zone", o.unit, f"|{o.name}| that must be exceeded for an update"),
        Field("noise_variance", f"({o.unit})^2", f"least variance of {o.name} a sample, > 0"),
        Field("variance_limit", "-", "greatest variance that is reported"),
        *gate_config(r),
        Field("validity_limit", validity[1].unit if validity else "-", "edge of the model's linear range"),
    )


def _state(r: Regression) -> tuple[Field, ...]:
    i, o, target = r.layout.input, r.layout.output, r.reduction.unknowns[0]
    return (
        Field("normal", "-", "sum of squares of the regressor"),
        Field("cross", "-", "sum of regressor times target"),
        Field("mean_square", f"({o.unit})^2", "mean square of the residual behind the filter"),
        Field(target.name, target.unit, target.meaning),
        Field("log_variance", "-", f"variance of ln {target.name} at the last update"),
        Field("raw_spread", f"({o.unit})^2", "variance of the innovation at the last update"),
        Field("star", f"1/({o.unit})", f"dimensionless per physical {o.name} at the last usable scale"),
        Field("per_unknown", "-", f"{r.unknown} per {target.name} at the same scale"),
        Field("updates", "-", "updates made, up to their greatest number"),
        Field("span", "-", "greatest power of two in them"),
        Field("pace", "-", "its reciprocal"),
        Field("input_memory", i.unit, f"memory of both sections for {i.name}", 4),
        Field("output_memory", o.unit, f"memory of both sections for {o.name}", 4),
        Field("input_before", i.unit, f"filtered {i.name}, one and two samples ago", 2),
        Field("output_before", o.unit, f"filtered {o.name}, one and two samples ago", 2),
        *(f for f in gate_state(r) if f.name != "started"),
    )


def _star(r: Regression) -> sp.Expr:
    groups = r.reduction.groups
    return at_now(r, 1 / groups.scale[r.layout.output.name])


def _start(r: Regression, states: tuple[Field, ...]) -> list[Statement]:
    target = r.layout.target
    start = {
        "normal": S("normal_start"),
        "cross": S("normal_start") * S(f"{target}_start"),
        target: S(f"{target}_start"),
        "log_variance": S("variance_limit"),
        "raw_spread": S("noise_variance"),
        "span": sp.Integer(1),
        "pace": sp.Integer(1),
        f"last_{r.speed}": S(f"{r.speed}_least"),
    }
    names = [s.name for f in states for s in f.symbols if s.name not in ("star", "per_unknown")]
    return [*(Assign(n, sp.sympify(start.get(n, 0))) for n in names), *_scales(r)]


def _scales(r: Regression) -> list[Assign]:
    """What follows from the measured scale."""
    per = at_now(r, r.per_target).xreplace(_by_star(r))
    return [Assign("star", _star(r)), Assign("per_unknown", per)]


def _step(r: Regression) -> list[Statement]:
    another = (Assign(f"last_{r.speed}", S("scale_now")), *_scales(r))
    return [
        Assign("predicted", S("last_measured")),
        Assign("innovation", sp.Integer(0)),
        When(
            sp.And(S("dt") > 0, S("dt") < 1e6),
            (*gates(r, another), *_predict(r), *_filter(), *_learn(r), *_remember()),
            (set_status("bad_sample"),),
            "time must advance",
        ),
        *_outputs(r),
    ]


def _rates(r: Regression) -> tuple[sp.Expr, sp.Expr]:
    """What a unit of the unknown adds to the output's change, per input and per output (physical)."""
    groups, layout = r.reduction.groups, r.layout
    star, per = S("star"), r.per_target
    unit = groups.scale[layout.output.name]
    into = groups.scale[layout.input.name]
    gain = sp.simplify(per * unit / groups.time_scale / into)
    damping = sp.simplify(per * unit / groups.time_scale)  # times star: the output is made dimensionless
    time = S("sample_time")
    return time * r.numerator * at_now(r, gain), time * r.denominator * at_now(r, damping) * star


def _predict(r: Regression) -> list[Statement]:
    """The regressor and, from the past alone, the raw output whose filtered value it predicts."""
    gain, damping = _rates(r)
    rest = S("biquad_2_0") * S("output_memory_0") + S("output_memory_2")
    inverse = 1 / (S("biquad_1_0") * S("biquad_2_0"))
    return [
        Assign("psi", gain * (D1 - D2) - damping * (R1 - R2), "regressor, eqs 25-26, for a unit of K"),
        Assign("told", S("psi") * S(r.layout.target), "second difference predicted"),
        Assign("filtered", 2 * R1 - R2 + S("told"), "filtered output predicted"),
        Assign("rest", rest, "filtered output if the newest were zero"),
        Assign("predicted", (S("filtered") - S("rest")) * inverse),
        When(S("usable") > HALF, (Assign("innovation", S("y_now") - S("predicted")),)),
    ]


def _filter() -> list[Statement]:
    return [
        *cascade(S("u_now"), 2, "input", "input_filtered"),
        *cascade(S("y_now"), 2, "output", "output_filtered"),
    ]


def _learn(r: Regression) -> list[Statement]:
    """Two sums and their ratio where the raw output exceeds the dead zone."""
    K, limit, keep = S(r.layout.target), S(f"{r.layout.target}_limit"), S("forgetting")
    y_now, dead = S("y_now"), S("dead_zone")
    beyond = sp.Or(y_now > dead, y_now < -dead)
    believable = (S("psi") < S("psi_limit"), S("psi") > -S("psi_limit"))
    used = sp.And(S("live") > HALF, S("fresh") > S("settle_samples"), beyond, *believable)
    more = sp.And(S("updates") >= 2 * S("span"), S("span") < S("updates_most"))
    body = (
        Assign("change", R0 - 2 * R1 + R2, "second difference, eq 24"),
        Assign("residual", S("change") - S("told")),
        Assign("rest_square", S("residual") ** 2),
        Assign("normal", keep * S("normal") + S("psi") ** 2),
        Assign("cross", keep * S("cross") + S("psi") * S("change")),
        Assign("mean_square", S("mean_square") + S("pace") * (S("rest_square") - S("mean_square"))),
        Assign("updates", sp.Min(S("updates") + 1, S("updates_most"))),
        When(more, (Assign("span", 2 * S("span")), Assign("pace", S("pace") / 2)), (), "twice as many"),
        Assign(r.layout.target, S("cross") / S("normal")),
        Assign(r.layout.target, sp.Max(sp.Min(K, limit), -limit)),
        *_spread(r),
        *_verdict(r),
    )
    return [When(used, body, (), "outside the dead zone, filters settled")]


def _verdict(r: Regression) -> list[Statement]:
    """Status of a sample that was used."""
    K, limit = S(r.layout.target), S(f"{r.layout.target}_limit")
    lines: list[Statement] = [set_status("ok")]
    validity = r.reduction.groups.model.validity
    if validity is not None:
        now = at_now(r, validity[0]).xreplace({r.layout.output.symbol: S("y_now")})
        beyond = sp.Or(now > S("validity_limit"), now < -S("validity_limit"))
        lines.append(When(beyond, (set_status("outside_linear"),)))
    edge = sp.Or(K <= S(f"{r.layout.target}_low"), K > EDGE * limit)
    return [*lines, When(edge, (set_status("at_limit"),), (), "no stiffness is zero or less")]


def _remember() -> list[Statement]:
    return [
        Assign(R2.name, R1),
        Assign(R1.name, R0),
        Assign(D2.name, D1),
        Assign(D1.name, D0),
        Assign("last_input", S("u_now")),
        Assign("last_measured", S("y_now")),
    ]


def _spread(r: Regression) -> list[Statement]:
    """Scatter of the residual as raw output, and the variance of the logarithm: spread/(normal K^2)."""
    direct = S("biquad_1_0") * S("biquad_2_0")
    raw = sp.Max(S("mean_square") / direct**2, S("noise_variance"))
    return [
        Assign("raw_spread", raw, "never below the sensor's share"),
        Assign(
            "scatter", S("raw_spread") * direct**2 / (S("cross") * S(r.layout.target)), "normal K = cross"
        ),
        Assign("log_variance", sp.Min(S("scatter"), S("variance_limit"))),
    ]


def _outputs(r: Regression) -> list[Statement]:
    """The unknown and its group, and how well they are known since the last update."""
    target = r.layout.target
    return [
        Assign("estimate", sp.Max(S(target), S(f"{target}_low"))),
        Assign(r.unknown, S("estimate") * S("per_unknown")),
        Assign("innovation_variance", S("raw_spread")),
        Assign("variance", S("log_variance")),
    ]


def _by_star(r: Regression) -> dict[sp.Symbol, sp.Expr]:
    """The measured scale from its reciprocal where that saves a division."""
    last = S(f"last_{r.speed}")
    found = sp.solve(sp.Eq(S("star"), _star(r)), last)
    return {last: found[0]} if len(found) == 1 else {}
