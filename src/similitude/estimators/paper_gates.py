"""The paper's regression before it computes: what a sample can be used for, and what is held.

``waiting`` counts down to the sample on which the filters have settled, so that the usual sample asks
one question of it; beyond ``settle_samples`` it says that the newest sample was not usable.

Invariant: after the gates the changes and the last scale are differences and values of believable numbers.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.held_sample import HALF, S, set_status
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When
from similitude.status import STATUS

AGAIN = Assign("waiting", S("settle_samples") + 1)
WAS_USABLE = S("waiting") <= S("settle_samples")
IS_MISSING = sp.And(
    S("status") > STATUS["no_measurement"] - HALF, S("status") < STATUS["no_measurement"] + HALF
)
NOT_YET = S("status") < STATUS["not_excited"] + HALF  # nothing was said of this sample


def time_gate(body: tuple[Statement, ...], otherwise: tuple[Statement, ...]) -> list[Statement]:
    """``body`` where time advances; a step of another length counts like a missing sample before."""
    dt = S("dt")
    uneven = When(
        sp.And(dt > 0, dt < 1e6),
        (When(WAS_USABLE, (set_status("restarted"),)), AGAIN),
        (set_status("bad_sample"),),
        "time must advance",
    )
    even = sp.And(dt > S("dt_low"), dt < S("dt_high"))
    return [
        Assign("waiting", S("wait")),
        set_status("not_excited"),
        When(sp.Not(even), (uneven,), (), "the sample before is elsewhere"),
        When(S("status") < STATUS["bad_sample"] - HALF, body, otherwise),
    ]


def gates(r: Regression) -> list[Statement]:
    """All that precedes the filters; a later status replaces an earlier one."""
    scale, change, jump = S(r.speed), S("measured") - S("last_measured"), S("output_jump")
    inputs = sp.And(_within(S("input"), "input_limit"), _within(scale, "signal_limit"))
    steady = sp.Or(sp.Abs(change) < jump, sp.Not(WAS_USABLE))
    output = sp.And(_within(S("measured"), "output_limit"), steady)
    use_inputs = (
        Assign("input_step", S("input") - S("last_input")),
        Assign("last_input", S("input")),
        Assign("scale_now", scale),
    )
    use_output = (Assign("output_step", change), Assign("y_now", S("measured")))
    last_scale = Assign("scale_now", S(f"last_{r.speed}"))
    missing = set_status("no_measurement")
    held_inputs = (Assign("input_step", sp.Integer(0)), last_scale, missing)
    held_output = (Assign("output_step", sp.Integer(0)), Assign("y_now", S("last_measured")), missing)
    counted = When(S("waiting") > HALF, (Assign("waiting", S("waiting") - 1),), (), "usable samples in a row")
    slow = (
        last_scale,
        Assign("waiting", sp.Max(S("waiting"), 1)),
        When(NOT_YET, (set_status("too_slow"),)),
    )
    return [
        When(inputs, use_inputs, held_inputs, "a missing input or scale is held"),
        When(output, use_output, held_output, "so is an output"),
        When(IS_MISSING, (AGAIN,), (counted,)),
        When(sp.Not(S("scale_now") > S(f"{r.speed}_least")), slow, (), "too slow to see the dynamics"),
        Assign(f"last_{r.speed}", S("scale_now")),
        Assign("last_measured", S("y_now")),
        Assign("wait", S("waiting")),
    ]


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.Abs(x) < S(limit)
