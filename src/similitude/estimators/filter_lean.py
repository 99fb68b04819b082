"""The population filter's step for small parts: what excludes one another shares a sample's time.

restart    on a sample that starts the dynamic state anew nothing is propagated
pull       to the prior while nothing is heard; learning while something is (of the samples before, so that
           no sample does both), and limits are looked at where an unknown has moved
sizes      of disturbance and noise and the excitation adapt by turns, every third sample for three
time       is bounded once by the shortest memory, in place of every average's weight

Invariant: the arithmetic of covariance, gains and dynamics is the population filter's own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp

from similitude.estimators import filter_covariance as cov
from similitude.estimators.filter_adapt import adapt_disturbance, adapt_noise, set_lower_status
from similitude.estimators.filter_fields import DISTURBANCE, INPUT_SCALE, Layout
from similitude.estimators.filter_gates import anew_lines
from similitude.estimators.filter_jump import heard, quiet_drift, share, surprise
from similitude.estimators.further_lean import (
    adapt_further,
    after_step,
    covariance_with,
    further_innovation,
    slopes,
)
from similitude.estimators.lean_correction import correction, learning
from similitude.program.ir import Assign, Program, Statement, When
from similitude.program.parts import as_part
from similitude.program.symmetric import column
from similitude.sampling import ImplicitStep

HALF = sp.Rational(1, 2)
TURNS = 3  # samples that one adaptation of a slow size stands for


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
    entries, propagated = cov.propagation(layout, step, ratios, {}, partial(covariance_with, layout))
    decayed = [
        Assign("keep_w", 1 - S("held") * S("disturbance_rate")),
        *propagated,
        *after_step(layout),
        Assign(DISTURBANCE, S("keep_w") * S(DISTURBANCE)),
    ]
    moved = [Assign(name, step.after[i]) for i, name in enumerate(layout.fast)]
    still = [Assign(f"d_{name}", sp.Integer(0)) for name in layout.fast]
    P, t = layout.covariance, layout.coordinates.index(layout.target)
    pulled = [Assign(f"{q.name}_with_{t}", S(f"{q.name}_with_{t}") * S("keep")) for q in layout.further]
    quiet = (Assign("diffusion", quiet_drift(), "a jump that could not have shown may have come"),)
    return [
        Assign("w_nominal", cov.disturbance_variance(layout), "nominal variance of the disturbance"),
        When(
            S("anew") > HALF,
            (*anew_lines(layout), *still),
            (*before, *slopes(layout, ratios), *entries, *as_part("propagate", decayed), *moved),
            "nothing is known of the dynamic state",
        ),
        Assign("move", sp.Integer(0)),
        When(S("excited") <= 0, (*cov.pull(layout), *pulled), quiet, "nothing heard: it may have changed"),
        *(Assign(P.target(i, i), P[i, i] + added) for i, added in slow.items()),
    ]


def lean_update(layout: Layout, H: Mapping[int, sp.Expr]) -> list[Statement]:
    """Kalman update with a bounded innovation, as the population filter's."""
    P, names = layout.covariance, layout.coordinates
    t = names.index(layout.target)
    slow = {i for i, name in enumerate(names) if name in (*layout.unknowns, INPUT_SCALE)}
    early = sorted(range(P.n) if slow & H.keys() else {*H, t})  # read before they change
    total = sp.Add(*(entry * S(f"c_{k}") for k, entry in H.items())) + S("noise")
    return [
        *column(P, H, "c", early),
        *cov.innovate(total),
        Assign("odd", sp.Min(S("nis"), 9) - 1, "by how much it is not as expected"),
        *_surprise(layout),
        Assign("inv_P", 1 / P[t, t]),
        Assign("sensitivity", S(f"c_{t}") * S("inv_P"), f"of the output to ln {layout.target}"),
        heard(),
        *further_innovation(layout, H),
        *learning(layout, H, early),
        *correction(layout, H, early),
        *_turns(layout),
    ]


def _turns(layout: Layout) -> list[Statement]:
    """What changes slowly: one of three a sample, for three samples."""
    above, heard = S("above") * S("above"), S("sensitivity") * S("sensitivity")
    enough = S("excitation") > S("excitation_ratio") * S("noise")
    thirds: tuple[list[Statement], ...] = (
        [*adapt_disturbance(layout, TURNS), Assign("turn", sp.Integer(1))],
        [*adapt_noise(layout, TURNS), Assign("turn", sp.Integer(2))],
        [
            _average("restlessness", "noise_adapt", above),
            _average("excitation", "excitation_rate", heard),
            Assign("excited", sp.Piecewise((1, enough), (0, True))),
            *adapt_further(layout, TURNS),
            Assign("turn", sp.Integer(0)),
        ],
    )
    later = When(S("turn") < 1 + HALF, tuple(thirds[1]), tuple(thirds[2]))
    return [When(S("turn") <= 0, tuple(thirds[0]), (later,), "one for three samples")]


def _average(name: str, rate: str, now: sp.Expr) -> Assign:
    return Assign(name, S(name) + TURNS * share(rate) * (now - S(name)))


def _surprise(layout: Layout) -> list[Statement]:
    """Recent surprise and jump; beyond the linear range an innovation counts as usual."""
    beyond = (Assign("linear", sp.Integer(0)), set_lower_status("outside_linear"))
    inside = sp.Not(cov.linear_range(layout))
    lines: list[Statement] = [Assign("linear", sp.Integer(1), "1 in the model's linear range")]
    if inside is not sp.false:
        lines.append(When(inside, beyond))
    beyond = S("surprise") - S("surprise_limit")
    stands_out = S("above") * S("above") > S("jump_ratio") * S("restlessness")
    rises = When(stands_out, (Assign("jump", sp.Max(beyond, 0)),), (Assign("jump", sp.Integer(0)),))
    return [*lines, surprise(), Assign("above", S("surprise") - 1), rises]


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
