"""A further measured output for small parts: one that is a sum of rates and states, as an accelerometer's.

    y = scale (sum_i a_i d_i/h + b_i (x_i + x_i')/2) + bias     x before, x' = x + d after a step h

Such an output needs no slopes of its own: the time update has all that its covariance is made of, since what
x' and x vary with is known there. It is the mean over the sample, and is compared with the mean of what was
measured at the sample's two ends. What it says besides the first output is the part of its innovation that
does not go with the first one's; the two then correct in one pass (`lean_correction`).

Invariant: a sample without the further measurement moves no state that it would not move without the output.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache

import sympy as sp

from similitude.errors import ProgramError
from similitude.estimators.filter_adapt import LARGEST_STEP, keep_within
from similitude.estimators.filter_fields import DISTURBANCE, Layout
from similitude.estimators.filter_jump import share
from similitude.model import Quantity
from similitude.program.ir import Assign, Statement, When

HALF = sp.Rational(1, 2)


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def by_rates(layout: Layout, q: Quantity) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """Weights a of the rates and b of the states whose sum the output is, all dimensionless.

    Raises
    ------
    ProgramError    it is none, its weights depend on positive unknowns, or there are several such outputs.
    """
    reduction, states = layout.reduction, layout.reduction.groups.model.states
    x = tuple(s.symbol for s in states)
    free = (*x, layout.input.symbol, *(u.symbol for u in reduction.unknowns if u.kind == "log"))
    found = _sum_of(reduction.output_map[q.name], tuple(reduction.rates[s.name] for s in states), x, free)
    if found is None or len(layout.further) > 1:
        raise ProgramError(
            f"a small filter of {reduction.groups.model.name!r} has no place for its output {q.name}",
            usually="It takes one further output, a sum of states and of their rates, as an accelerometer's.",
            paste="similitude export SYSTEM --estimator population",
            read='docs/embedded.md, "A small filter"',
        )
    return found


@lru_cache
def _sum_of(
    output: sp.Expr, rates: tuple[sp.Expr, ...], x: tuple[sp.Symbol, ...], free: tuple[sp.Symbol, ...]
) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]] | None:
    """Weights of rates and states that hold for all values of the free symbols."""
    a, b = (sp.symbols(f"{letter}0:{len(x)}") for letter in "ab")
    terms = sum(ai * f + bi * xi for ai, f, bi, xi in zip(a, rates, b, x, strict=True))
    left = sp.numer(sp.together(output - terms))
    if not left.is_polynomial(*free):
        return None
    found = sp.solve(sp.Poly(left, *free).coeffs(), [*a, *b], dict=True)
    return tuple(tuple(found[0].get(s, sp.Integer(0)) for s in part) for part in (a, b)) if found else None


def slopes(layout: Layout, ratios: Sequence[sp.Expr]) -> list[Assign]:
    """``NAME_to_i`` by the states after the step, ``NAME_from_i`` before it, ``NAME_by_i`` by an unknown."""
    lines: list[Assign] = []
    for q in layout.further:
        n, (a, b) = q.name, by_rates(layout, q)
        scale, per = S(f"{n}_scale"), S(f"{n}_per_step")
        lines += [
            Assign(
                scale.name, layout.inverted(layout.reduction.groups.scale[n]), f"{n} = scale x dimensionless"
            ),
            Assign(per.name, scale / S("h")),
        ]
        for i, ratio in enumerate(ratios):
            rate, state = layout.inverted(a[i]) * per, HALF * layout.inverted(b[i]) * scale
            lines += [Assign(f"{n}_to_{i}", rate + state), Assign(f"{n}_from_{i}", (state - rate) * ratio)]
        for k, u in _direct(layout, q).items():
            lines.append(Assign(f"{n}_by_{k}", u))
    return lines


def _direct(layout: Layout, q: Quantity) -> dict[int, sp.Expr]:
    """Index -> slope by an unknown that the weights of the rates depend on."""
    n, (a, _) = q.name, by_rates(layout, q)
    found: dict[int, sp.Expr] = {}
    for u in layout.reduction.unknowns:
        by = [layout.inverted(ai.diff(u.symbol)) * S(f"d_{x}") for ai, x in zip(a, layout.fast, strict=True)]
        if slope := sp.Add(*by) * S(f"{n}_per_step") * u.jacobian:
            found[layout.coordinates.index(u.name)] = slope
    return found


def covariance_with(layout: Layout, j: int, FP: Mapping[int, sp.Symbol]) -> list[Assign]:
    """Covariance of coordinate ``j`` with the output, from columns of F P and P, both before the step."""
    P, fast, lines = layout.covariance, range(len(layout.fast)), []
    for q in layout.further:
        n = q.name
        bias = layout.coordinates.index(f"{n}_bias")
        total = sp.Add(*(S(f"{n}_to_{i}") * FP[i] + S(f"{n}_from_{i}") * P[i, j] for i in fast))
        total += sp.Add(*(S(f"{n}_by_{k}") * P[k, j] for k in _direct(layout, q)), P[bias, j])
        keep = S("keep_w") if layout.coordinates[j] == DISTURBANCE else 1
        lines.append(Assign(f"{n}_before_{j}" if j in fast else f"{n}_with_{j}", keep * total))
    return lines


def after_step(layout: Layout) -> list[Assign]:
    """The same of the states after the step, and the variance of the output."""
    P, fast, lines = layout.covariance, range(len(layout.fast)), []
    for q in layout.further:
        n, direct = q.name, _direct(layout, q)
        bias = layout.coordinates.index(f"{n}_bias")
        for j in fast:
            total = sp.Add(
                *(S(f"{n}_to_{i}") * P[i, j] + S(f"{n}_from_{i}") * S(f"FP_{j}_{i}") for i in fast)
            )
            total += sp.Add(*(S(f"{n}_by_{k}") * P[j, k] for k in direct), P[j, bias])
            lines.append(Assign(f"{n}_with_{j}", total))
        total = sp.Add(*(S(f"{n}_to_{i}") * S(f"{n}_with_{i}") for i in fast))
        total += sp.Add(*(S(f"{n}_from_{i}") * S(f"{n}_before_{i}") for i in fast))
        total += sp.Add(*(S(f"{n}_by_{k}") * S(f"{n}_with_{k}") for k in direct), S(f"{n}_with_{bias}"))
        lines.append(Assign(f"{n}_spread", total))
    return lines


def further_innovation(layout: Layout, H: Mapping[int, sp.Expr]) -> list[Statement]:
    """What the second output says besides the first, with slopes ``H``; nothing where it is missing."""
    lines: list[Statement] = []
    for q in layout.further:
        n = q.name
        now, last, limit = S(f"{n}_measured"), S(f"last_{n}"), S(f"{n}_limit")
        parts = ("innovation", "inv_spread", "after", "odd")
        nothing = tuple(Assign(f"{n}_{part}", sp.Integer(0)) for part in parts)
        whole = sp.And(sp.Abs(last) < limit, S("dt") <= S("longest"), S("anew") < HALF)
        heard = When(whole, tuple(_weigh(layout, q, H)), nothing, "and was, a sample before")
        missing = (*nothing, *forget(layout))
        there = (heard, Assign(last.name, now))
        lines.append(When(sp.Abs(now) < limit, there, missing, f"{n} is measured too"))
    return lines


def forget(layout: Layout) -> list[Assign]:
    """No further output was measured: what is remembered of it is beyond belief."""
    return [Assign(f"last_{q.name}", 2 * S(f"{q.name}_limit")) for q in layout.further]


def _weigh(layout: Layout, q: Quantity, H: Mapping[int, sp.Expr]) -> list[Statement]:
    n, (a, b) = q.name, by_rates(layout, q)
    nu, spread, nis, response = (S(f"{n}_{k}") for k in ("innovation", "inv_spread", "nis", "response"))
    both, after, activity = (S(f"{n}_{k}") for k in ("both", "after", "activity"))
    parts = [
        layout.inverted(ai) * S(f"d_{x}") / S("h") + layout.inverted(bi) * (S(x) - HALF * S(f"d_{x}"))
        for ai, bi, x in zip(a, b, layout.fast, strict=True)
    ]
    scale = layout.inverted(layout.reduction.groups.scale[n])
    size = S(f"{n}_variance") + S(f"{n}_share") ** 2 * activity
    alike = 2 * S(f"{n}_time") * S("inv_dt")
    measured = HALF * (S(f"{n}_measured") + S(f"last_{n}"))
    return [
        Assign(response.name, scale * sp.Add(*parts), f"mean {n} of the model over the sample"),
        Assign(activity.name, activity + share("activity_rate") * (response**2 - activity)),
        Assign(both.name, sp.Add(*(slope * S(f"{n}_with_{i}") for i, slope in H.items()))),
        Assign(after.name, S("inv_spread") * both, "what the first output has said of it"),
        Assign(nu.name, measured - S(f"{n}_bias") - response - after * S("innovation")),
        Assign(
            f"{n}_left", sp.Max(S(f"{n}_spread") - both * after, 0), "rounding may leave less than nothing"
        ),
        Assign(spread.name, 1 / (S(f"{n}_left") + S(f"{n}_noise_scale") * size * alike)),
        Assign(nis.name, nu * nu * spread, "normalised innovation squared"),
        Assign(f"{n}_odd", sp.Min(nis, 9) - 1, "by how much it is not as expected"),
        When(
            nis > S("outlier_ratio"),
            (Assign(spread.name, spread * S("outlier_ratio") / nis),),
            (),
            "an outlier counts for less",
        ),
    ]


def adapt_further(layout: Layout, times: int) -> list[Statement]:
    """The size of a further output's noise follows its innovations, by a sample that stands for so many."""
    lines: list[Statement] = []
    for q in layout.further:
        scale, change = S(f"{q.name}_noise_scale"), S(f"{q.name}_noise_change")
        pace = sp.Min(times * S("dt") * S("settling"), LARGEST_STEP)
        lines += [
            Assign(change.name, pace * S(f"{q.name}_odd")),
            Assign(scale.name, scale * (1 + change * (1 + change / 2))),
            *keep_within(scale.name),
        ]
    return lines
