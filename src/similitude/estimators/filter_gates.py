"""What the population filter asks of a sample before it uses it, and when it starts its dynamic state anew.

Invariant: after the gates ``u_now`` and the scales of now are believable numbers, whatever the sample held.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.filter_fields import DISTURBANCE, Layout
from similitude.program.ir import Assign, Statement, When
from similitude.status import STATUS


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.Abs(x) < S(limit)


def gates(layout: Layout) -> list[Statement]:
    """Hold the last input over a missing one; decide what the sample can be used for."""
    signals = layout.signals
    read = [("u_now", S("input"), "last_input", "input_limit")]
    read += [(f"{q.name}_now", q.symbol, f"last_{q.name}", "signal_limit") for q in signals]
    none = (Assign("usable", sp.Integer(0)), Assign("status", sp.Integer(STATUS["no_measurement"])))
    return [
        Assign("usable", sp.Integer(1)),
        Assign("anew", sp.Integer(0), "1 where the dynamic state starts anew"),
        Assign("age", S("age") + S("dt")),
        *(
            When(
                _within(given, limit),
                (Assign(now, given),),
                (Assign(now, S(last)), *none),
                "a missing one is held",
            )
            for now, given, last, limit in read
        ),
        When(_within(S("measured"), "output_limit"), (), none, "no measurement"),
        When(
            S("started") < 0.5,
            (
                Assign("anew", sp.Integer(1)),
                Assign("last_input", S("u_now")),
                *(Assign(f"last_{q.name}", S(f"{q.name}_now")) for q in signals),
            ),
            (),
            "no sample before it could be used",
        ),
    ]


def restart(layout: Layout) -> list[Statement]:
    """After a gap, or while the scales hide the dynamics, nothing is known of the dynamic state."""
    half = sp.Rational(1, 2)
    gap = S("age") > S("gap")
    told = Assign("status", sp.Integer(STATUS["restarted"]))
    again = (told, Assign("anew", sp.Integer(1)))
    if layout.lean:
        late = (Assign("anew", sp.Integer(1)), When(S("usable") > half, (told,)))
        return [When(gap, late, (), "nothing was heard for long"), *_hidden(layout)]
    return [
        When(sp.And(gap, S("usable") > half), again, (), "the first sample after a gap"),
        *_hidden(layout),
        When(sp.Or(gap, S("anew") > half), tuple(_unheard()), (), "nothing was heard for long"),
        When(S("anew") > half, tuple(_unknown(layout)), (), "nothing is known of them"),
    ]


def anew_lines(layout: Layout) -> list[Assign]:
    """Nothing is known of the dynamic state, and nothing was heard of late."""
    return [*_unheard(), *_unknown(layout)]


def _unheard() -> list[Assign]:
    unheard = [Assign(name, sp.Integer(0)) for name in ("excitation", "excited", "jump", "heard")]
    return [*unheard, Assign("surprise", sp.Integer(1))]


def _unknown(layout: Layout) -> list[Assign]:
    P = layout.covariance
    dynamic = range(len(layout.fast) + 1)
    lines = [Assign(P.target(i, j), sp.Integer(0)) for i in dynamic for j in range(i, P.n)]
    lines += [Assign(P.target(i, i), S(f"{name}_sd") ** 2) for i, name in enumerate(layout.fast)]
    w = len(layout.fast)
    lines.append(Assign(P.target(w, w), S("disturbance_scale") * S("disturbance_floor") ** 2))
    return lines + [Assign(name, sp.Integer(0)) for name in (*layout.fast, *layout.companion, DISTURBANCE)]


def _hidden(layout: Layout) -> list[Statement]:
    """Nothing is measured while the scales hide the dynamics."""
    replace = {q.symbol: S(f"{q.name}_now") for q in layout.signals}
    live = sp.sympify(layout.reduction.live).xreplace(replace)
    if live is sp.true:
        return []
    nothing = (
        Assign("anew", sp.Integer(1)),
        Assign("started", sp.Integer(0)),
        Assign("usable", sp.Integer(0)),
        Assign("status", sp.Integer(STATUS["too_slow"])),
    )
    return [When(live, (), nothing, "the dynamics cannot be seen")]
