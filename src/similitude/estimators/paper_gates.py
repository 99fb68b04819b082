"""The paper's regression before it computes: what a sample can be used for, and what is held.

``waiting`` counts down to the sample on which the filters have settled, and on from there without an end (a
float stops by itself where one is lost in it), so that the usual sample asks one question of it; at
``settle_samples`` it says that the newest sample was not usable.

Invariant: after the gates the changes and the last scale are differences and values of believable numbers.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.held_sample import HALF, S, set_status
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When
from similitude.status import STATUS

WAS_USABLE = S("waiting") < S("settle_samples")
SETTLED = S("waiting") <= 0
NOT_YET = S("status") < STATUS["not_excited"] + HALF  # nothing was said of this sample


def time_gate(body: tuple[Statement, ...], otherwise: tuple[Statement, ...]) -> list[Statement]:
    """``body`` where time advances; a step of another length counts like a missing sample before."""
    dt = S("dt")
    uneven = When(
        sp.And(dt > 0, dt < 1e6),
        (set_status("restarted"), Assign("waiting", S("settle_samples"))),
        (set_status("bad_sample"),),
        "time must advance",
    )
    even = sp.Abs(dt - S("sample_time")) < S("dt_room")
    return [
        Assign("waiting", S("wait")),
        set_status("not_excited"),
        When(even, (), (uneven,), "else the sample before is elsewhere"),
        When(S("status") < STATUS["bad_sample"] - HALF, body, otherwise),
    ]


def gates(r: Regression) -> list[Statement]:
    """All that precedes the filters; a later status replaces an earlier one.

    The output is looked at first: how the sample before was, counts for its jump alone.
    """
    scale, change, jump = S(r.speed), S("measured") - S("last_measured"), S("output_jump")
    inputs = sp.And(_within(S("input"), "input_limit"), _within(scale, "signal_limit"))
    steady = sp.Or(sp.Abs(change) < jump, sp.Not(WAS_USABLE))
    output = sp.And(_within(S("measured"), "output_limit"), steady)
    missing = (set_status("no_measurement"), Assign("waiting", S("settle_samples") + 1))
    use_output = (Assign("output_step", change), Assign("y_now", S("measured")))
    held_output = (Assign("output_step", sp.Integer(0)), Assign("y_now", S("last_measured")), *missing)
    use_inputs = (
        Assign("input_step", S("input") - S("last_input")),
        Assign("last_input", S("input")),
        Assign("scale_now", scale),
    )
    last_scale = Assign("scale_now", S(f"last_{r.speed}"))
    held_inputs = (Assign("input_step", sp.Integer(0)), last_scale, *missing)
    slow = (
        last_scale,
        Assign("waiting", S("settle_samples")),
        When(NOT_YET, (set_status("too_slow"),)),
    )
    return [
        When(output, use_output, held_output, "a missing output is held"),
        When(inputs, use_inputs, held_inputs, "so is an input or a scale"),
        Assign("waiting", S("waiting") - 1, "usable samples in a row"),
        When(sp.Not(S("scale_now") > S(f"{r.speed}_least")), slow, (), "too slow to see the dynamics"),
        Assign(f"last_{r.speed}", S("scale_now")),
        Assign("last_measured", S("y_now")),
        Assign("wait", S("waiting")),
    ]


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.Abs(x) < S(limit)
