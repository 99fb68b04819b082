"""The paper's regression before it computes: what a sample can be used for, and what is held.

Invariant: after the gates ``u_now``, ``y_now`` and the last scale are believable numbers.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When
from similitude.status import STATUS

HALF = sp.Rational(1, 2)


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def set_status(name: str) -> Assign:
    """``status`` becomes the code of that name."""
    return Assign("status", sp.Integer(STATUS[name]))


def gates(r: Regression) -> list[Statement]:
    """All that precedes the first use of the sample; a later status replaces an earlier one."""
    even = sp.And(S("dt") > S("dt_low"), S("dt") < S("dt_high"))
    again = (Assign("fresh", sp.Integer(0)), set_status("restarted"))
    counted = sp.Min(S("fresh"), S("settle_samples")) + 1
    missing = (Assign("fresh", sp.Integer(0)), set_status("no_measurement"))
    return [
        set_status("not_excited"),
        *_hold(r),
        *_follow_scale(r),
        When(sp.And(sp.Not(even), S("fresh") > HALF), again, (), "the sample before is elsewhere"),
        When(S("usable") > HALF, (Assign("fresh", counted),), missing, "usable samples in a row"),
    ]


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.And(x > -S(limit), x < S(limit))


def _hold(r: Regression) -> list[Statement]:
    """The filters are fed the last usable values over missing ones."""
    scale = S(r.speed)
    inputs_fine = sp.And(_within(S("input"), "input_limit"), _within(scale, "signal_limit"))
    now = (Assign("u_now", S("input")), Assign("scale_now", scale))
    held = (Assign("u_now", S("last_input")), Assign("scale_now", S(f"last_{r.speed}")))
    change, jump = S("measured") - S("last_measured"), S("output_jump")
    sudden = sp.And(S("fresh") > HALF, sp.Or(change > jump, change < -jump))
    fine = sp.And(_within(S("measured"), "output_limit"), sp.Not(sudden))
    measured = (Assign("y_now", S("measured")),)
    last = (Assign("y_now", S("last_measured")),)
    unusable = Assign("usable", sp.Integer(0))
    return [
        Assign("usable", sp.Integer(1)),
        When(inputs_fine, now, (*held, unusable), "a missing input or scale is held"),
        When(fine, measured, (*last, unusable), "so is an output"),
    ]


def at_now(r: Regression, expression: sp.Expr) -> sp.Expr:
    """An expression in the scales as they are used now."""
    return sp.sympify(expression).xreplace({S(r.speed): S(f"last_{r.speed}")})


def at_scale_of_now(r: Regression) -> list[Assign]:
    """m1, m2 and units at the scale of now, kept until the scale changes."""
    groups, layout = r.reduction.groups, r.layout
    per_input = S("sample_time") / at_now(r, groups.time_scale * groups.scale[layout.input.name])
    per_output = S("sample_time") / at_now(r, groups.time_scale) * S("star")
    unit = at_now(r, groups.scale[layout.output.name])
    return [
        Assign("unit", unit),
        Assign("star", 1 / unit),
        Assign("m1", S("m1_rate") * per_input, "eq 22, per physical input"),
        Assign("m2", S("m2_rate") * per_output, "eq 22, per physical output"),
    ]


def _follow_scale(r: Regression) -> list[Statement]:
    """The same physical constant in the scale of now; slower than the least scale nothing moves."""
    old, now = f"last_{r.speed}", S("scale_now")
    per = r.per_target
    ratio = sp.simplify(per.xreplace({S(r.speed): now}) / per.xreplace({S(r.speed): S(old)}))
    rescale = (
        Assign("ratio", ratio, f"of {r.unknown} for the same {r.layout.target}"),
        Assign("theta", S("theta") * S("ratio")),
        Assign("P", S("P") * S("ratio") ** 2),
    )
    another = (
        When(S("started") > HALF, rescale, (), "the same constant"),
        Assign(old, now),
        *at_scale_of_now(r),
    )
    follow = (
        When(sp.Or(now > S(old), now < S(old)), another, (), "another scale"),
        Assign("live", sp.Integer(1)),
        Assign("started", sp.Integer(1)),
    )
    too_slow = (Assign("live", sp.Integer(0)), set_status("too_slow"))
    return [When(now > S(f"{r.speed}_least"), follow, too_slow, "fast enough to see the dynamics")]
