"""The statements of the paper's regression: filters, prediction, recursive least squares.

    y = phi K + e       y    second difference of the filtered output (eq 24)
                        phi  what a unit of K adds to it (eqs 25-26)

in the output's own units, both without the filters' common gain, so the newest sample has weight one in y and
the residual is the innovation of the raw output. Recursive least squares in the sum of squares,

    normal <- forgetting normal + phi^2 + least,    K <- K + phi (y - phi K)/normal,

is the textbook form with P = 1/normal in half as many operations; least keeps it off zero in an endless turn.

Invariant: the history the regressor is read from moves on once a sample, after its last use.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.held_sample import HALF, S, set_status
from similitude.estimators.high_pass_section import moved_on, sections
from similitude.estimators.paper_fields import state_fields
from similitude.estimators.paper_gates import WAS_USABLE, gates, time_gate
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When

INVERSE = S("inverse")  # of the scale that is measured along


def before_first(r: Regression) -> list[Statement]:
    """The statements of ``init``: all that follows from the configuration, the rest at rest."""
    per_input, per_output = (split.as_independent(S(r.speed))[0] for split in regressors(r))
    last = f"last_{r.speed}"
    start = {
        "from_input": per_input,
        "from_output": per_output,
        last: S(f"{r.speed}_least"),
        **{line.target: line.expression for line in _prior(r, S(last))},
        "log_variance": S("variance_limit"),
        "wait": S("settle_samples") + 1,
    }
    names = [s.name for f in state_fields(r) for s in f.symbols]
    names = [last, *(n for n in names if n != last)]
    return [Assign(name, sp.sympify(start.get(name, 0))) for name in names]


def one_sample(r: Regression) -> list[Statement]:
    """The statements of ``step``."""
    last = S(f"last_{r.speed}")
    body = (
        *gates(r),
        Assign(INVERSE.name, 1 / S("scale_now")),
        *_filter(),
        *_predict(r),
        *_learn(r),
        *moved_on("input"),
        *moved_on("output"),
    )
    nothing = (
        Assign("predicted", S("last_measured")),
        Assign("expected", sp.Integer(0)),
        Assign("innovation", sp.Integer(0)),
        Assign("learnt", sp.Integer(0)),
        Assign(INVERSE.name, 1 / last),
    )
    return [*time_gate(body, nothing), *_outputs(r)]


def regressors(r: Regression) -> tuple[sp.Expr, sp.Expr]:
    """phi per change of filtered input and of filtered output, in the scales: eq 22 as one of K."""
    groups, layout = r.reduction.groups, r.layout
    into, out = groups.scale[layout.input.name], groups.scale[layout.output.name]
    per_step = r.per_target * S("sample_time") / groups.time_scale
    return (
        sp.simplify(per_step * out / into) * r.numerator,
        sp.simplify(per_step) * r.denominator,
    )


def _at_inverse(r: Regression, expression: sp.Expr) -> sp.Expr:
    """What of an expression the measured scale changes, in its reciprocal."""
    changing = expression.as_independent(S(r.speed))[1]
    return sp.powsimp(changing.xreplace({S(r.speed): 1 / INVERSE}))


def _prior(r: Regression, scale: sp.Symbol) -> list[Assign]:
    """The start is one of the group, so of K at the speed of now, until the first update."""
    unit = r.reduction.groups.scale[r.layout.output.name]
    now = {S(r.speed): scale}
    return [
        Assign("theta", S(f"{r.unknown}_start") / sp.sympify(r.per_target).xreplace(now)),
        Assign("normal", S("normal_start") * sp.simplify(r.per_target * unit).xreplace(now) ** 2),
    ]


def _filter() -> list[Statement]:
    return [*sections(S("input_step"), "input"), *sections(S("output_step"), "output")]


def _predict(r: Regression) -> list[Statement]:
    """The regressor, what it says of the newest output, and by how much that is wrong."""
    per_input, per_output = regressors(r)
    phi = S("from_input") * _at_inverse(r, per_input) * S("input_2_change")
    phi -= S("from_output") * _at_inverse(r, per_output) * S("output_2_change")
    return [
        Assign("phi", phi, "regressor, eqs 25-26"),
        Assign("expected", S("phi") * S("theta")),
        Assign("y", S("output_2_now") - S("output_2_change"), "second difference, eq 24"),
        Assign("residual", S("y") - S("expected")),
        Assign("predicted", S("y_now") - S("residual"), "the newest output has weight one in y"),
    ]


def _learn(r: Regression) -> list[Statement]:
    """Recursive least squares with forgetting where the raw output exceeds the dead zone."""
    phi, theta, normal, forgetting = (S(n) for n in ("phi", "theta", "normal", "forgetting"))
    limit, moved = S(f"{r.layout.target}_limit"), S("moved")
    used = sp.And(S("waiting") < HALF, sp.Abs(S("y_now")) > S("dead_zone"))
    step = (S("residual") ** 2 - S("mean_square")) / S("weight")
    body = (
        Assign("innovation", S("residual")),
        Assign("learnt", sp.Integer(1)),
        Assign("normal", forgetting * normal + phi**2 + S("normal_least")),
        Assign(moved.name, theta + S("residual") * phi / normal),
        When(
            sp.Abs(moved) < limit,
            (Assign("theta", moved),),
            (Assign("theta", sp.Piecewise((limit, moved > 0), (-limit, True))),),
        ),
        Assign("weight", forgetting * S("weight") + 1),
        Assign("mean_square", S("mean_square") + step),
        *_verdict(r),
    )
    otherwise = (
        Assign("learnt", sp.Integer(0)),
        Assign("innovation", sp.Piecewise((S("residual"), WAS_USABLE), (0, True))),
        When(S("weight") < HALF, tuple(_prior(r, S("scale_now"))), (), "nothing was learnt yet"),
    )
    return [When(used, body, otherwise, "outside the dead zone, filters settled")]


def _verdict(r: Regression) -> list[Statement]:
    """Status of a sample that was used, but for a constant at its least."""
    lines: list[Statement] = [set_status("ok")]
    validity = r.reduction.groups.model.validity
    if validity is not None:
        now = {S(r.speed): S("scale_now"), r.layout.output.symbol: S("y_now")}
        value = sp.sympify(validity[0]).xreplace(now)
        lines.append(When(sp.Abs(value) > S("validity_limit"), (set_status("outside_linear"),)))
    return lines


def _outputs(r: Regression) -> list[Statement]:
    """The constant and its group; scatter of the residual as variance, without the noise's bias."""
    estimate, limit, low = S("estimate"), S("variance_limit"), S(f"{r.layout.target}_low")
    scatter = S("innovation_variance") / (S("normal") * estimate**2)
    status = S("status")
    learnt = sp.Or(status < HALF, sp.And(status > 1 + HALF, status < 2 + HALF))  # ok, outside_linear
    at_least = (Assign("estimate", low), When(learnt, (set_status("at_limit"),)))
    return [
        When(S("theta") > low, (Assign("estimate", S("theta")),), at_least, "no stiffness is zero or less"),
        Assign(r.unknown, estimate * _group_per_constant(r)),
        Assign(
            "innovation_variance",
            sp.Max(S("mean_square"), S("noise_variance")),
            "never below the sensor's share",
        ),
        When(
            S("learnt") > HALF,
            (
                Assign("information", S("information") + S("expected") ** 2 / S("innovation_variance")),
                Assign("scatter", scatter),
                Assign("log_variance", sp.Min(S("scatter"), limit)),
            ),
            (),
            "nothing was learnt: nothing is known otherwise than before",
        ),
        Assign("information_gained", S("information")),
        Assign("variance", S("log_variance")),
    ]


def _group_per_constant(r: Regression) -> sp.Expr:
    constant, _ = r.per_target.as_independent(S(r.speed))
    return constant * _at_inverse(r, r.per_target)
