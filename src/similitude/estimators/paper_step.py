"""The statements of the paper's regression: filters, prediction, recursive least squares.

    y = phi theta + e    y      second difference of the filtered output (eq 24)
                         theta  (a1 + 2) U, in proportion to K: the damping of a sample at speed one
                         phi    input times (b1 / (a1 + 2)) less output over U (eqs 25-26)

in the output's own units, both without the filters' common gain, so the newest sample has weight one in y and
the residual is the innovation of the raw output. Recursive least squares in the sum of squares,

    normal <- forgetting normal + phi^2 + least,    theta <- theta + phi (y - phi theta)/normal,

is the textbook form with P = 1/normal in half as many operations; least keeps it off zero in an endless turn.
The mean square of the residual is kept as a sum and the updates it rests on, alike forgotten. What is only
read (K, interval, group, scatter, prediction) is worked out by ``report`` when it is asked for.

Invariant: the history the regressor is read from moves on once a sample, after its last use.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.held_sample import S, set_status
from similitude.estimators.high_pass_section import moved_on, sections
from similitude.estimators.paper_fields import state_fields
from similitude.estimators.paper_gates import SETTLED, gates, time_gate
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When


def before_first(r: Regression) -> list[Statement]:
    """The statements of ``init``: the start, the sensor's noise for one update, all else at rest."""
    start = {
        "theta": S("theta_start"),
        "normal": S("normal_start"),
        "square_sum": S("noise_variance"),
        "weight": sp.Integer(1),
        f"last_{r.speed}": S(f"{r.speed}_least"),
        "wait": S("settle_samples"),
    }
    names = [s.name for f in state_fields(r) for s in f.symbols]
    return [Assign(name, sp.sympify(start.get(name, 0))) for name in names]


def one_sample(r: Regression) -> list[Statement]:
    """The statements of ``step``."""
    body = (
        *gates(r),
        *sections(S("input_step"), "input"),
        *sections(S("output_step"), "output"),
        *_predict(r),
        _learn(r),
        *moved_on("input"),
        *moved_on("output"),
    )
    return time_gate(body, (Assign("residual", sp.Integer(0)),))


def asked_for(r: Regression) -> list[Statement]:
    """The statements of ``report``: the constant and its group; scatter of the residual as variance.

    The scatter is that of the sum, without the noise's bias. The newest output has weight one in the
    residual.
    """
    theta, spread, limit = S("theta"), S("innovation_variance"), S("variance_limit")
    last, told = {S(r.speed): S(f"last_{r.speed}")}, S("told")
    return [
        Assign("told", sp.Max(theta, S("theta_low")), "no stiffness is zero or less"),
        Assign("estimate", told * S(f"{r.layout.target}_per_theta")),
        Assign(r.unknown, S("estimate") * sp.sympify(r.per_target).xreplace(last)),
        Assign("mean_square", S("square_sum") / S("weight")),
        Assign(spread.name, sp.Max(S("mean_square"), S("noise_variance")), "never below the sensor's share"),
        Assign("scatter", spread / (S("normal") * told**2)),
        Assign("variance", sp.Min(S("scatter"), limit)),
        Assign("predicted", S("last_measured") - S("residual")),
        Assign("innovation", sp.Piecewise((S("residual"), S("wait") < S("settle_samples")), (0, True))),
    ]


def _predict(r: Regression) -> list[Statement]:
    """The regressor, and by how much what it says of the newest output is wrong."""
    by_input, by_output = r.changing({S(r.speed): S("scale_now")})
    phi = S("input_ratio") * by_input * S("input_2_change") - by_output * S("output_2_change")
    return [
        Assign("phi", phi, "regressor, eqs 25-26"),
        Assign("y", S("output_2_now") - S("output_2_change"), "second difference, eq 24"),
        Assign("residual", S("y") - S("phi") * S("theta")),
    ]


def _learn(r: Regression) -> Statement:
    """Recursive least squares with forgetting where the raw output exceeds the dead zone."""
    phi, theta, normal, forgetting = (S(n) for n in ("phi", "theta", "normal", "forgetting"))
    body = (
        Assign("normal", forgetting * normal + phi**2 + S("normal_least")),
        Assign("moved", theta + S("residual") * phi / normal),
        When(sp.Abs(S("moved")) < S("theta_limit"), (Assign("theta", S("moved")),), (), "as far as any car"),
        Assign("weight", forgetting * S("weight") + 1),
        Assign("square_sum", forgetting * S("square_sum") + S("residual") ** 2),
        *_verdict(r),
    )
    used = sp.And(SETTLED, sp.Abs(S("y_now")) > S("dead_zone"))
    return When(used, body, (), "outside the dead zone, filters settled")


def _verdict(r: Regression) -> list[Statement]:
    """Status of a sample that was used."""
    validity = r.reduction.groups.model.validity
    lines: list[Statement] = [set_status("ok")]
    if validity is not None:
        now = {S(r.speed): S("scale_now"), r.layout.output.symbol: S("y_now")}
        value = sp.sympify(validity[0]).xreplace(now)
        lines.append(When(sp.Abs(value) > S("validity_limit"), (set_status("outside_linear"),)))
    at_limit = (set_status("at_limit"),)
    return [*lines, When(S("theta") <= S("theta_low"), at_limit, (), "no stiffness is zero or less")]
