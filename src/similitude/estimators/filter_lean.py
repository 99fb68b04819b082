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

import sympy as sp

from similitude.estimators import filter_covariance as cov
from similitude.estimators.filter_adapt import adapt_disturbance, adapt_noise, set_lower_status
from similitude.estimators.filter_fields import DISTURBANCE, INPUT_SCALE, Layout
from similitude.estimators.filter_gates import anew_lines
from similitude.estimators.filter_jump import heard, quiet_drift, share, surprise
from similitude.program.ir import Assign, Program, Statement, When
from similitude.program.parts import as_part
from similitude.program.symmetric import column, reduce_by
from similitude.sampling import ImplicitStep
from similitude.status import STATUS

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
        When(S("excited") <= 0, tuple(cov.pull(layout)), quiet, "nothing heard: it may have changed"),
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
        *_correct(layout, H, early),
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
        return [*lines, *cov.state_update(layout, own, move_square)]

    held = [i for i in range(P.n) if i not in rank or rank[i] > 0]
    learnt = as_part("learn", corrected(held, held, always=False))
    fast = [i for i in range(P.n) if i not in held]
    gained = S("gained")
    body = (
        *_slow_weights(layout),
        Assign(gains[t].name, S(f"c_{t}") * S("inv_spread")),
        Assign("gained", gains[t] * S(f"c_{t}") * S("inv_P"), "share of the variance removed"),
        Assign("information", S("information") + gained * (1 + gained) * S("inv_P"), "1/variance gained"),
        Assign("move", S("move") + gains[t] * nu),
        *learnt,
        *keep_each_within([n for n in layout.moving if n != target]),
    )
    always = as_part("correct", corrected(fast, range(P.n), always=True))
    unheard = (set_lower_status("not_excited"),)
    return [When(S("excited") > 0, body, unheard, "heard of the samples before"), *always]


def _slow_weights(layout: Layout) -> list[Statement]:
    """What the innovation counts with for unknowns that cannot jump, and for those learnt now and then."""
    slow = sp.Piecewise((S("inv_spread"), S("jump") <= 0), (0, True))
    lines: list[Statement] = [Assign("learn_slow", slow, "a jump is not blamed on what cannot jump")]
    if not layout.seldom:
        return lines
    return [
        *lines,
        Assign("unlearnt", S("unlearnt") + dt),
        Assign("learn_seldom", sp.Integer(0)),
        When(
            S("unlearnt") >= S("seldom"),
            (Assign("learn_seldom", S("learn_slow")), Assign("unlearnt", sp.Integer(0))),
            (),
            "the next sample tells little that this one does not",
        ),
    ]


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


def move_square(name: str, by: str) -> list[Assign]:
    """Move a positive state by so much of its logarithm: by the square of exp's series over half of it.

    Positive for any move and off by m^3/24, so no move has to be bounded; the least it leaves is a quarter.
    """
    half, m = S(f"half_{by}"), S(by)
    eighth = sp.Rational(1, 8)
    return [Assign(half.name, 1 + m * (HALF + eighth * m)), Assign(name, S(name) * (half * half))]


def keep_each_within(names: Sequence[str]) -> list[Statement]:
    """Unknowns inside what the population allows, after a measurement; the status says where one was not."""
    told = Assign("status", sp.Integer(STATUS["at_limit"]))
    sides = [(n, S(f"{n}_low"), S(n) < S(f"{n}_low")) for n in names]
    sides += [(n, S(f"{n}_high"), S(n) > S(f"{n}_high")) for n in names]
    return [When(beyond, (Assign(n, limit), told), (), "its allowed range") for n, limit, beyond in sides]
