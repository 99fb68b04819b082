"""How sizes follow the innovations: noise and disturbance of the population filter, bounded on both sides.

Invariant: a size stays positive and between its configured limits.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.filter_fields import DISTURBANCE, Layout
from similitude.estimators.filter_jump import share
from similitude.program.ir import Assign, Statement, When
from similitude.status import STATUS

LARGEST_STEP = sp.Rational(1, 20)  # of ln noise from one sample, however long it took


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


dt = S("dt")


def move_log(name: str, by: str) -> list[Assign]:
    """Move a positive state by so much of its logarithm, at most one at a time."""
    bounded = S(f"bounded_{by}")
    return [
        Assign(f"above_{by}", sp.Max(S(by), -1)),
        Assign(bounded.name, sp.Min(S(f"above_{by}"), 1)),
        Assign(name, S(name) * exponential(bounded)),
    ]


def exponential(x: sp.Symbol) -> sp.Expr:
    """exp to third order, without a division; positive for |x| <= 1."""
    return 1 + x * (1 + x * (sp.Rational(1, 2) + x / 6))


def keep_within(name: str) -> list[Assign]:
    """Keep a state between its configured limits."""
    return [
        Assign(name, sp.Max(S(name), S(f"{name}_low"))),
        Assign(name, sp.Min(S(name), S(f"{name}_high"))),
    ]


def adapt(layout: Layout) -> list[Statement]:
    """The sizes of noise and disturbance follow the innovations; the status says how it went."""
    lines: list[Statement] = [
        *adapt_noise(layout),
        *adapt_disturbance(layout),
        When(
            sp.And(S("excited") < sp.Rational(1, 2), S("status") < sp.Rational(1, 2)),
            (Assign("status", sp.Integer(STATUS["not_excited"])),),
        ),
    ]
    if layout.reduction.groups.model.validity is not None:
        outside = sp.And(S("validity") > S("validity_limit") ** 2, S("status") < sp.Rational(3, 2))
        lines.append(When(outside, (Assign("status", sp.Integer(STATUS["outside_linear"])),)))
    return lines


def set_lower_status(name: str) -> When:
    """``status`` becomes the code of that name where it is a lesser one."""
    return When(S("status") < STATUS[name] - sp.Rational(1, 2), (Assign("status", sp.Integer(STATUS[name])),))


def _calm(layout: Layout) -> sp.Expr:
    return 1 / (1 + S("heat")) if layout.warming else sp.Integer(1)  # wrong unknowns are no noise


def adapt_noise(layout: Layout, times: int = 1) -> list[Assign]:
    """The size of the noise, by a sample that stands for so many."""
    change, settling, calm = S("noise_change"), S("settling"), _calm(layout)
    grown = 1 + change * (1 + change / 2) if layout.lean else exponential(change)
    return [
        Assign(
            "settling",
            sp.Max(S("noise_adapt"), settling - times * dt * settling * settling * calm),
            "1/time at first",
        ),
        Assign(
            "noise_change",
            sp.Min(times * dt * S("settling"), LARGEST_STEP) * S("odd") * calm,
        ),
        Assign("noise_scale", S("noise_scale") * grown),
        *keep_within("noise_scale"),
    ]


def adapt_disturbance(layout: Layout, times: int = 1) -> list[Assign]:
    """The size of the disturbance, by a sample that stands for so many."""
    P = layout.covariance
    w = layout.coordinates.index(DISTURBANCE)
    at, expected, seen = S("disturbance_scale"), S("expected"), S("seen")
    unseen = sp.Max(expected - P[w, w], S("observed_least") * expected)
    weight = times * share("disturbance_adapt")
    return [
        Assign("expected", at * S("w_nominal"), "disturbance variance expected"),
        Assign("seen", sp.Min(S(DISTURBANCE) ** 2 + P[w, w], 9 * expected), "and seen"),
        Assign("unseen", unseen),
        Assign(
            "disturbance_scale",
            at + weight * (seen - expected) * at / S("unseen") * _calm(layout),
        ),
        *keep_within("disturbance_scale"),
    ]
