"""The population filter's step for small parts: what excludes one another shares a sample's time.

restart    on a sample that starts the dynamic state anew nothing is propagated
pull       to the prior while nothing is heard; learning while something is (of the sample before, so that
           no sample does both), and limits are looked at where an unknown has moved
sizes      of noise and disturbance adapt by turns, every other sample for two
time       is bounded once by the shortest memory, in place of every average's weight

Invariant: the arithmetic of covariance, gains and dynamics is the population filter's own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from similitude.estimators import filter_covariance as cov
from similitude.estimators.filter_adapt import adapt_disturbance, adapt_noise, set_lower_status
from similitude.estimators.filter_fields import DISTURBANCE, INPUT_SCALE, Layout
from similitude.estimators.filter_gates import anew_lines
from similitude.estimators.filter_jump import heard, jump, quiet_drift, share, surprise
from similitude.program.ir import Assign, Program, Statement, When
from similitude.program.parts import as_part
from similitude.program.symmetric import column, reduce_by
from similitude.sampling import ImplicitStep
from similitude.status import STATUS

HALF = sp.Rational(1, 2)


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


dt = S("dt")


def lean_dynamics(
    layout: Layout, before: Sequence[Statement], step: ImplicitStep, ratios: Sequence[sp.Expr]
) -> list[Statement]:
    """Start anew, or step and propagate; then what time does to the slow coordinates.

    ``before`` are the statements that lead to the step's results.
    """
    slow = cov.slow_noise(layout)
    entries, propagated = cov.propagation(layout, step, ratios, {})
    decayed = [
        Assign("keep_w", 1 - S("held") * S("disturbance_rate")),
        *propagated,
        Assign(DISTURBANCE, S("keep_w") * S(DISTURBANCE)),
    ]
    moved = [Assign(name, step.after[i]) for i, name in enumerate(layout.fast)]
    still = [Assign(f"d_{name}", sp.Integer(0)) for name in layout.fast]
    P = layout.covariance
    quiet = (Assign("diffusion", quiet_drift(), "a jump that could not have shown may have come"),)
    return [
        Assign("w_nominal", cov.disturbance_variance(layout), "nominal variance of the disturbance"),
        When(
            S("anew") > HALF,
            (*anew_lines(layout), *still),
            (*before, *entries, *as_part("propagate", decayed), *moved),
            "nothing is known of the dynamic state",
        ),
        Assign("move", sp.Integer(0)),
        When(S("excited") < HALF, tuple(cov.pull(layout)), quiet, "nothing heard: it may have changed"),
        *(Assign(P.target(i, i), P[i, i] + added) for i, added in slow.items()),
    ]


def lean_update(layout: Layout, H: Mapping[int, sp.Expr]) -> list[Statement]:
    """Kalman update with a bounded innovation, as the population filter's."""
    P, names, nu = layout.covariance, layout.coordinates, S("innovation")
    t = names.index(layout.target)
    slow = {i for i, name in enumerate(names) if name in (*layout.unknowns, INPUT_SCALE)}
    early = sorted(range(P.n) if slow & H.keys() else {*H, t})  # read before they change
    total = sp.Add(*(entry * S(f"c_{k}") for k, entry in H.items())) + S("noise")
    return [
        *column(P, H, "c", early),
        Assign("innovation", S("measured") - S("predicted")),
        Assign("innovation_variance", total),
        Assign("inv_spread", 1 / S("innovation_variance")),
        Assign("nis", nu * nu * S("inv_spread"), "normalised innovation squared"),
        When(
            S("nis") > S("outlier_ratio"),
            (Assign("inv_spread", S("inv_spread") * S("outlier_ratio") / S("nis")),),
            (),
            "an outlier counts for less",
        ),
        Assign("odd", sp.Min(S("nis"), 9) - 1, "by how much it is not as expected"),
        *_surprise(layout),
        Assign("inv_P", 1 / P[t, t]),
        Assign("sensitivity", S(f"c_{t}") * S("inv_P"), f"of the output to ln {layout.target}"),
        heard(),
        *_correct(layout, H, early),
        Assign(
            "excitation",
            S("excitation") + share("excitation_rate") * (S("sensitivity") ** 2 - S("excitation")),
        ),
        When(
            S("excitation") > S("excitation_ratio") * S("noise"),
            (Assign("excited", sp.Integer(1)),),
            (Assign("excited", sp.Integer(0)), set_lower_status("not_excited")),
        ),
        When(
            S("turn") < HALF,
            (*adapt_noise(layout, 2), Assign("turn", sp.Integer(1))),
            (*adapt_disturbance(layout, 2), Assign("turn", sp.Integer(0))),
            "one for two samples",
        ),
    ]


def _surprise(layout: Layout) -> list[Statement]:
    """Recent surprise and jump; beyond the linear range an innovation counts as usual."""
    beyond = (Assign("linear", sp.Integer(0)), set_lower_status("outside_linear"))
    inside = sp.Not(cov.linear_range(layout))
    lines: list[Statement] = [Assign("linear", sp.Integer(1), "1 in the model's linear range")]
    if inside is not sp.false:
        lines.append(When(inside, beyond))
    return [*lines, surprise(), *jump()]


def _correct(layout: Layout, H: Mapping[int, sp.Expr], early: Sequence[int]) -> list[Statement]:
    """Every coordinate by its gain; the unknowns' own block only while something is heard."""
    P, names, target, nu = layout.covariance, layout.coordinates, layout.target, S("innovation")
    t = names.index(target)
    gains = {i: S(f"gain_{i}") for i, name in enumerate(names) if name not in layout.considered}
    weights = cov.weights(layout, gains, learn="inv_spread")
    rank = {i: cov.ORDER.index(w) for i, w in weights.items()}
    rank |= {t: 1}

    def corrected(rows: Sequence[int], columns: Sequence[int], always: bool) -> list[Assign]:
        own = {i: gains[i] for i in rows if i in gains and i != t}
        lines = column(P, H, "c", (i for i in columns if i not in early))
        lines += [Assign(gain.name, S(f"c_{i}") * S(weights[i])) for i, gain in own.items()]
        lines += reduce_by(P, gains, rank, "c", lambda order: (order == 0) == always)
        return [*lines, *cov.state_update(layout, own)]

    held = [i for i in range(P.n) if i not in rank or rank[i] > 0]
    learnt = as_part("learn", corrected(held, held, always=False))
    fast = [i for i in range(P.n) if i not in held]
    gained = S("gained")
    body = (
        *cov.slow_weights("inv_spread"),
        Assign(gains[t].name, S(f"c_{t}") * S("inv_spread")),
        Assign("gained", gains[t] * S(f"c_{t}") * S("inv_P"), "share of the variance removed"),
        Assign("information", S("information") + gained * (1 + gained) * S("inv_P"), "1/variance gained"),
        Assign("move", S("move") + gains[t] * nu),
        *learnt,
        keep_all_within([n for n in layout.moving if n != target]),
    )
    always = as_part("correct", corrected(fast, range(P.n), always=True))
    return [When(S("excited") > HALF, body, (), "heard of the sample before"), *always]


def bounded_once(program: Program) -> Program:
    """The same step with ``held = Min(dt, longest)`` in averages, in place of a bound on each one's weight.

    Min(1, rate dt) becomes rate held, Max(0, 1 - rate dt) becomes 1 - rate held: the same for every sample
    that lasts no longer than the shortest memory, which is what `filter_config.longest` configures.
    """
    rates = {S(f.name) for f in program.config if f.name.endswith(("_rate", "_adapt"))}
    place = {sp.Min(1, dt * rate): S("held") * rate for rate in rates}
    place |= {sp.Max(0, 1 - dt * rate): 1 - S("held") * rate for rate in rates}

    def bounded(body: Sequence[Statement]) -> tuple[Statement, ...]:
        return tuple(
            replace(
                s, condition=s.condition.xreplace(place), body=bounded(s.body), otherwise=bounded(s.otherwise)
            )
            if isinstance(s, When)
            else replace(s, expression=s.expression.xreplace(place))
            for s in body
        )

    return replace(program, step=bounded(program.step))


def keep_all_within(names: Sequence[str]) -> When:
    """Unknowns inside what the population allows; the status says where one was not."""
    hit = [r for n in names for r in (S(n) < S(f"{n}_low"), S(n) > S(f"{n}_high"))]
    clip = [Assign(n, sp.Min(sp.Max(S(n), S(f"{n}_low")), S(f"{n}_high"))) for n in names]
    at_limit = When(S("usable") > HALF, (Assign("status", sp.Integer(STATUS["at_limit"])),), ())
    return When(sp.Or(*hit), (*clip, at_limit), (), "prior +- its allowed range")
