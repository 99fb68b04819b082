"""What every regression asks of a sample before it uses it: values held, samples counted, scale followed.

The estimators that use it have ``layout`` (names of input, output and scales) and ``speed`` (the
measured scale), and in their structs the fields named here.

Invariant: after the gates ``u_now``, ``y_now`` and the last scale are believable numbers.
"""

from __future__ import annotations

from typing import Protocol

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.program.ir import Assign, Field, Statement, When
from similitude.status import STATUS

HALF = sp.Rational(1, 2)


class Regressed(Protocol):
    """A model as a regression takes it."""

    @property
    def layout(self) -> ff.Layout:
        """Names of input, output and scales."""

    @property
    def speed(self) -> str:
        """The scale that is measured along."""


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def set_status(name: str) -> Assign:
    """``status`` becomes the code of that name."""
    return Assign("status", sp.Integer(STATUS[name]))


def at_now(r: Regressed, expression: sp.Expr) -> sp.Expr:
    """An expression in the scales as they are used now."""
    return sp.sympify(expression).xreplace({S(r.speed): S(f"last_{r.speed}")})


def gates(r: Regressed, another_scale: tuple[Statement, ...]) -> list[Statement]:
    """All that precedes the first use of the sample; a later status replaces an earlier one.

    ``another_scale`` is what to do where the measured scale differs from the last usable one.
    """
    even = sp.And(S("dt") > S("dt_low"), S("dt") < S("dt_high"))
    again = (Assign("fresh", sp.Integer(0)), set_status("restarted"))
    counted = sp.Min(S("fresh"), S("settle_samples")) + 1
    missing = (Assign("fresh", sp.Integer(0)), set_status("no_measurement"))
    return [
        set_status("not_excited"),
        *_hold(r),
        *_follow_scale(r, another_scale),
        When(sp.And(sp.Not(even), S("fresh") > HALF), again, (), "the sample before is elsewhere"),
        When(S("usable") > HALF, (Assign("fresh", counted),), missing, "usable samples in a row"),
    ]


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.And(x > -S(limit), x < S(limit))


def _hold(r: Regressed) -> list[Statement]:
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


def _follow_scale(r: Regressed, another_scale: tuple[Statement, ...]) -> list[Statement]:
    """Slower than the least scale nothing moves."""
    old, now = f"last_{r.speed}", S("scale_now")
    follow = (
        When(sp.Or(now > S(old), now < S(old)), another_scale, (), "another scale"),
        Assign("live", sp.Integer(1)),
        Assign("started", sp.Integer(1)),
    )
    too_slow = (Assign("live", sp.Integer(0)), set_status("too_slow"))
    return [When(now > S(f"{r.speed}_least"), follow, too_slow, "fast enough to see the dynamics")]


def remember() -> list[Statement]:
    """The sample becomes the last one."""
    return [Assign("last_input", S("u_now")), Assign("last_measured", S("y_now"))]


def gate_variables(r: Regressed) -> tuple[Field, ...]:
    """Working values that the gates leave behind."""
    layout = r.layout
    return (
        Field("status", "-", "status code"),
        Field("u_now", layout.input.unit, "input used now"),
        Field("y_now", layout.output.unit, "measurement used now"),
        Field("scale_now", layout.signals[0].unit, "scale used now"),
        Field("usable", "-", "1 where input, scale and measurement can be used"),
        Field("live", "-", "1 where the scale is fast enough to learn at"),
    )


def gate_config(r: Regressed) -> tuple[Field, ...]:
    """What is believable, and which steps and samples count."""
    i, o, signal = r.layout.input, r.layout.output, r.layout.signals[0]
    return (
        Field("settle_samples", "-", "whole samples in a row before an update, 3 or more"),
        Field("dt_low", "s", "shortest step that counts as one sample"),
        Field("dt_high", "s", "longest step that counts as one sample"),
        Field(f"{signal.name}_least", signal.unit, f"least {signal.meaning} to learn at, > 0"),
        Field("input_limit", i.unit, f"greatest believable {i.name}"),
        Field("output_limit", o.unit, f"greatest believable {o.name}"),
        Field("output_jump", o.unit, f"greatest believable change of {o.name} in one sample"),
        Field("signal_limit", signal.unit, "greatest believable scale"),
    )


def gate_state(r: Regressed) -> tuple[Field, ...]:
    """What the gates remember between samples."""
    i, o, signal = r.layout.input, r.layout.output, r.layout.signals[0]
    return (
        Field("last_input", i.unit, "last usable input"),
        Field("last_measured", o.unit, "last usable measurement"),
        Field(f"last_{signal.name}", signal.unit, f"last {signal.meaning} fast enough to learn"),
        Field("fresh", "-", "usable samples in a row"),
        Field("started", "-", "0 before the first usable scale, 1 after"),
    )
