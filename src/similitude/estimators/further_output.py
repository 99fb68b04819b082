"""A further measured output of the population filter: a second update after that by the first output.

    measured = h(x, u) + bias        h of the model, the bias a slow state of its own

The first output decides what is excited, what is a jump, and how large noise and disturbance are; a
further one corrects by its own innovation, under the same leave to learn. Its noise is taken as alike for
``time``, so that an error of the model or of the mounting does not count once a sample.

Invariant: a sample without the further measurement moves no state that it would not move without the output.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from similitude.estimators.filter_adapt import LARGEST_STEP, exponential, keep_within, move_log
from similitude.estimators.filter_covariance import ORDER
from similitude.estimators.filter_fields import DISTURBANCE, INPUT_SCALE, OFFSET, Layout
from similitude.estimators.filter_jump import share
from similitude.model import Quantity
from similitude.program.ir import Assign, Statement, When, shared
from similitude.program.parts import as_part
from similitude.program.symmetric import column, reduce_by

HALF = sp.Rational(1, 2)
LEAVES = ORDER[1:]  # as the first output gave them, each a part of the one before


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def further_updates(layout: Layout) -> list[Statement]:
    """The statements for every output after the first, where the sample holds it."""
    lines: list[Statement] = []
    for q in layout.further:
        measured, limit = S(f"{q.name}_measured"), S(f"{q.name}_limit")
        body = (*_predict(layout, q), *_correct(layout, q), *_adapt(q))
        lines.append(When(sp.Abs(measured) < limit, body, (), f"{q.name} is measured too"))
    return lines


def _gradient_names(layout: Layout, q: Quantity) -> dict[str, sp.Symbol]:
    """Coordinate -> slope of the output by it."""
    response = layout.reduction.output_map[q.name]
    by = {f"{q.name}_bias": sp.Integer(1)}
    states = dict(zip(layout.reduction.groups.model.states, layout.fast, strict=True))
    by |= {name: S(f"{q.name}_by_{name}") for s, name in states.items() if response.has(s.symbol)}
    by |= {u.name: S(f"{q.name}_by_{u.name}") for u in layout.reduction.unknowns if response.has(u.symbol)}
    if response.has(layout.input.symbol):
        by |= {DISTURBANCE: S(f"{q.name}_by_u"), OFFSET: S(f"{q.name}_by_u")}
        by[INPUT_SCALE] = S(f"{q.name}_by_u") * S(INPUT_SCALE) * S("u_now")
    return by


def _predict(layout: Layout, q: Quantity) -> list[Statement]:
    """The model's output at the end of the step, its slopes, and the variance of what is measured."""
    n, reduction = q.name, layout.reduction
    unit = layout.inverted(1 / reduction.groups.scale[layout.input.name])
    acting = S(INPUT_SCALE) * S("u_now")
    u, u_plain = S(f"{n}_u"), S(f"{n}_u_plain")
    states = {s.symbol: S(f) for s, f in zip(reduction.groups.model.states, layout.fast, strict=True)}
    response = layout.inverted(reduction.output_map[n].xreplace({**states, layout.input.symbol: u}))
    plain = {S(f): S(p) for f, p in zip(layout.fast, layout.companion or layout.fast, strict=True)} | {
        u: u_plain
    }
    scale = S(f"{n}_scale")
    slopes = {f"{n}_by_{name}": response.diff(S(name)) for name in layout.fast}
    slopes |= {
        # along the companion, as for the first output
        f"{n}_by_{one.name}": response.diff(one.symbol).xreplace(plain) * one.jacobian
        for one in reduction.unknowns
    }
    slopes[f"{n}_by_u"] = response.diff(u) * unit
    named = {f"{n}_response": response} | {name: e for name, e in slopes.items() if e != 0}
    alike = sp.Max(1, 2 * S(f"{n}_time") * S("inv_dt"))
    size = S(f"{n}_variance") + S(f"{n}_share") ** 2 * S(f"{n}_activity")
    return [
        Assign(scale.name, layout.inverted(reduction.groups.scale[n]), f"{n} = scale x dimensionless"),
        Assign(u.name, (acting + S(OFFSET) + S(DISTURBANCE)) * unit, "effective input at the end [-]"),
        Assign(u_plain.name, acting * unit),
        *shared(f"{n}_s", {name: sp.factor_terms(scale * e.doit()) for name, e in named.items()}),
        Assign(
            f"{n}_activity",
            S(f"{n}_activity") + share("activity_rate") * (S(f"{n}_response") ** 2 - S(f"{n}_activity")),
        ),
        Assign(f"{n}_noise", S(f"{n}_noise_scale") * size * alike, f"variance of {n}"),
    ]


def _correct(layout: Layout, q: Quantity) -> list[Statement]:
    """Kalman update with a bounded innovation."""
    n, P, names = q.name, layout.covariance, layout.coordinates
    t, nu, spread = names.index(layout.target), S(f"{n}_innovation"), S(f"{n}_inv_spread")
    H = {names.index(name): slope for name, slope in _gradient_names(layout, q).items()}
    total = sp.Add(*(slope * S(f"{n}_c_{k}") for k, slope in H.items())) + S(f"{n}_noise")
    away = S(f"{n}_response") + S(f"{n}_bias") + H.get(t, 0) * S("move")  # the target moves at the end
    bounded = Assign(spread.name, spread * S("outlier_ratio") / S(f"{n}_nis"))
    leave, leaves = _leave(layout, n), LEAVES if layout.beyond else LEAVES[1:]
    gains = {i: S(f"{n}_gain_{i}") for i, name in enumerate(names) if name not in layout.considered}
    rank = {spread.name: 0} | {f"{n}_{kind}": k for k, kind in enumerate(leaves, start=1)}
    gained = S(f"{n}_gained")
    early = sorted({*H, t})
    corrected = column(P, H, f"{n}_c", (i for i in range(P.n) if i not in early))
    corrected += [
        Assign(g.name, S(f"{n}_c_{i}") * S(leave.get(names[i], spread.name)))
        for i, g in gains.items()
        if i != t
    ]
    ranks = {i: rank[leave.get(names[i], spread.name)] for i in gains}
    corrected += reduce_by(P, gains, ranks, f"{n}_c")
    corrected += _moves(layout, n, {i: g for i, g in gains.items() if i != t})
    return [
        *column(P, H, f"{n}_c", early),
        Assign(nu.name, S(f"{n}_measured") - away),
        Assign(spread.name, 1 / total),
        Assign(f"{n}_nis", nu * nu * spread, "normalised innovation squared"),
        When(S(f"{n}_nis") > S("outlier_ratio"), (bounded,), (), "an outlier counts for less"),
        *(
            Assign(f"{n}_{kind}", sp.Piecewise((spread, S(kind) > 0), (0, True)), "where the first may learn")
            for kind in leaves
        ),
        Assign(gains[t].name, S(f"{n}_c_{t}") * S(leave.get(layout.target, spread.name))),
        Assign(f"{n}_inv_P", 1 / P[t, t]),
        Assign(gained.name, gains[t] * S(f"{n}_c_{t}") * S(f"{n}_inv_P"), "share of the variance removed"),
        Assign("information", S("information") + gained * (1 + gained) * S(f"{n}_inv_P")),
        Assign("move", S("move") + gains[t] * nu),
        *as_part(f"correct_by_{n}", corrected),
    ]


def _leave(layout: Layout, n: str) -> dict[str, str]:
    """Coordinate -> the weight its gain is taken with, where it is not that of every sample."""
    leave = dict.fromkeys((*layout.unknowns, INPUT_SCALE), f"{n}_learn_slow")
    leave |= dict.fromkeys(layout.seldom, f"{n}_learn_seldom") | {layout.target: f"{n}_learn"}
    return leave | dict.fromkeys(layout.beyond, f"{n}_learn_beyond")


def _moves(layout: Layout, n: str, gains: Mapping[int, sp.Symbol]) -> list[Assign]:
    """Every coordinate but the first unknown, which moves at the end of the step."""
    nu, lines = S(f"{n}_innovation"), []
    logs = {u.name for u in layout.reduction.unknowns if u.kind == "log"} | {INPUT_SCALE}
    for i, gain in gains.items():
        name = layout.coordinates[i]
        if name in logs:
            lines += [Assign(f"{n}_move_{name}", gain * nu), *move_log(name, f"{n}_move_{name}")]
        else:
            lines.append(Assign(name, S(name) + gain * nu))
    return lines


def _adapt(q: Quantity) -> list[Statement]:
    """The size of its noise follows its own innovations."""
    n = q.name
    change = sp.Min(S("dt") * S("settling"), LARGEST_STEP) * (sp.Min(S(f"{n}_nis"), 9) - 1)
    return [
        Assign(f"{n}_noise_change", change),
        Assign(f"{n}_noise_scale", S(f"{n}_noise_scale") * exponential(S(f"{n}_noise_change"))),
        *keep_within(f"{n}_noise_scale"),
    ]
