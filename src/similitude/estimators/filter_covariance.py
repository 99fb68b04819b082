"""Time update and measurement update of the population filter, on the covariance of its coordinates.

Invariant: an unknown that is held or only considered keeps its variance (its gain is zero), while
what it does to the others is still accounted for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

import sympy as sp

from similitude.elementary import spelt_functions
from similitude.estimators.filter_adapt import adapt, move_log
from similitude.estimators.filter_fields import BIAS, DISTURBANCE, INPUT_SCALE, OFFSET, Layout
from similitude.estimators.filter_jump import heard, jump, quiet_drift, share, surprise
from similitude.program.ir import Assign, Statement, When
from similitude.program.parts import as_part
from similitude.program.symmetric import Shared, column, predict, reduce_by
from similitude.reduction import Unknown
from similitude.sampling import ImplicitStep

ORDER = (  # of weights: each is zero where one before is
    "inv_spread",
    "learn_beyond",
    "learn",
    "learn_slow",
    "learn_seldom",
)

Beside = Callable[[int, Mapping[int, sp.Symbol]], list[Assign]]  # as of `program.symmetric.predict`
Move = Callable[[str, str], list[Assign]]  # name of a positive state, and of the change of its logarithm


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


dt = S("dt")


def time_update(layout: Layout, step: ImplicitStep, ratios: Sequence[sp.Expr]) -> list[Statement]:
    """Covariance over one step, and the pull of the first unknown towards its prior."""
    entries, propagated = propagation(layout, step, ratios, slow_noise(layout))
    return [
        Assign("keep_w", sp.Max(0, 1 - dt * S("disturbance_rate"))),
        Assign("w_nominal", disturbance_variance(layout), "nominal variance of the disturbance"),
        Assign("move", sp.Integer(0)),
        Assign("diffusion", quiet_drift(), "a jump that could not have shown may have come"),
        When(
            S("excited") < sp.Rational(1, 2),
            tuple(pull(layout)),
            (),
            "nothing heard: it may have changed, and the population is the best guess",
        ),
        *entries,
        *as_part("propagate", propagated),
        Assign(DISTURBANCE, S("keep_w") * S(DISTURBANCE)),
    ]


def propagation(
    layout: Layout,
    step: ImplicitStep,
    ratios: Sequence[sp.Expr],
    slow: Mapping[int, sp.Expr],
    beside: Beside = lambda j, FP: [],
) -> tuple[list[Assign], list[Assign]]:
    """Entries of F that are no working value yet, and P <- F P F' + Q.

    ``slow`` index -> variance added to a slow coordinate; ``beside`` is worked out with it.
    """
    at = {name: i for i, name in enumerate(layout.coordinates)}
    entries: list[Assign] = []
    rows: dict[int, dict[int, sp.Expr]] = {}
    for i, name in enumerate(layout.fast):
        row = {at[k]: S(f"F_{name}_{k}") for k in layout.fast}
        entries += [
            Assign(f"F_{name}_{k}", step.by_state[i, j] * ratios[j]) for j, k in enumerate(layout.fast)
        ]
        row |= {at[u]: step.by_parameter[u][i] for u in layout.unknowns}
        rows[at[name]] = row
    added = S("disturbance_scale") * S("w_nominal") * (1 - S("keep_w") * S("keep_w"))
    weights = ((DISTURBANCE, sp.Integer(1)), (OFFSET, sp.Integer(1)), (INPUT_SCALE, S("steer")))
    shared = Shared(
        {at[name]: weight for name, weight in weights if name in at},
        {at[name]: step.by_parameter["u"][i] for i, name in enumerate(layout.fast)},
    )
    noise = {at[DISTURBANCE]: added, **slow}
    decay = {at[DISTURBANCE]: S("keep_w")}
    return entries, predict(layout.covariance, rows, shared, decay=decay, noise=noise, beside=beside)


def slow_noise(layout: Layout) -> dict[int, sp.Expr]:
    """Index -> variance that a sample adds to a coordinate that no dynamics move."""
    at = {name: i for i, name in enumerate(layout.coordinates)}
    return {
        at[layout.target]: dt * (S("diffusion") + S("jump_drift") * S("jump")),
        **{at[f"{q.name}_bias"]: S(f"{q.name}_bias_drift") * dt for q in layout.further},
        **({at[BIAS]: S("bias_drift") * dt} if BIAS in at else {}),
    }


def pull(layout: Layout) -> list[Statement]:
    """Pull of the first unknown's coordinate towards its prior, without a logarithm.

    ln x = 2 artanh z with z = (x - 1)/(x + 1) = p/q; the Pade form of artanh is good to 0.3 % for x
    between 1/4 and 4.
    """
    unknown, P = layout.reduction.unknowns[0], layout.covariance
    t = layout.coordinates.index(unknown.name)
    x, x0 = unknown.symbol, S(f"{unknown.name}_prior")
    p, q, pp, qq = S("p"), S("q"), S("pp"), S("qq")
    logarithm = [
        Assign("p", x - x0),
        Assign("q", x + x0),
        Assign("pp", p * p),
        Assign("qq", q * q),
        Assign("away", 2 * p * (15 * qq - 4 * pp) / (q * (15 * qq - 9 * pp)), f"ln({x}/{x0})"),
    ]
    return [
        Assign("lost", sp.Min(1, dt * S("idle_drift") * S("prior_information") / 2)),
        Assign("keep", 1 - S("lost")),
        Assign(
            "diffusion",
            S("lost") * (1 + S("keep")) / (dt * S("prior_information")),
            "for long: the prior variance",
        ),
        *(Assign(P.target(t, j), P[t, j] * S("keep")) for j in range(P.n)),
        Assign(P.target(t, t), P[t, t] * S("keep")),
        *(logarithm if unknown.kind == "log" else [Assign("away", x - x0)]),
        Assign("move", -S("lost") * S("away")),
    ]


def disturbance_variance(layout: Layout) -> sp.Expr:
    """Nominal variance of the disturbance [input^2]: a floor, and a share of what is driven."""
    floor, share = S("disturbance_floor"), S("disturbance_share")
    relative = share * S("inv_output_scale")
    return floor * floor + relative * relative * S("activity")


def measurement(
    layout: Layout,
    further: Sequence[Statement] = (),
    *,
    update: Callable[[Layout, Mapping[int, sp.Expr]], list[Statement]] | None = None,
    unheard: Sequence[Statement] = (),
    move: Move = move_log,
) -> list[Statement]:
    """Predict the output and, where the sample is usable, update everything by the innovation.

    ``further`` is what the other outputs of the sample correct after that; ``update`` what the innovation
    does in place of this filter's own, ``unheard`` what is done without one; ``move`` how a logarithm moves.
    """
    groups = layout.reduction.groups
    states = {q.symbol: S(n) for q, n in zip(groups.model.states, layout.fast, strict=True)}
    states |= {layout.input.symbol: S("u_end")}
    output = layout.inverted(layout.reduction.output_map[layout.output.name].xreplace(states))
    at = {name: i for i, name in enumerate(layout.coordinates)}
    plain = {S(n): S(p) for n, p in zip(layout.fast, layout.companion or layout.fast, strict=True)}
    H: dict[int, sp.Expr] = {}
    for name in layout.fast:
        slope = S("output_scale") * output.diff(S(name))
        if slope != 0:
            H[at[name]] = slope
    for u in layout.reduction.unknowns:
        # along the companion: a corrected state holds noise of the measurement it would be
        # weighed against, and the unknown would be drawn away by their product
        slope = S("output_scale") * output.diff(u.symbol).xreplace(plain) * u.jacobian
        if slope != 0:
            H[at[u.name]] = slope
    direct, slopes = _feedthrough(layout, output)
    H |= {at[name]: slope for name, slope in slopes.items() if name in at}
    functions, spelled = spelt_functions({"": output, **{f"{i}": e for i, e in H.items()}}, "out")
    output = spelled.pop("")
    H = {i: spelled[f"{i}"] for i in H}
    if BIAS in at:
        H[at[BIAS]] = sp.Integer(1)
    speed = sp.Add(*(H[at[n]] * S(f"d_{n}") for n in layout.fast if at[n] in H)) * S("inv_dt")
    model_part = S("output_scale") * output
    structural = S("structure_share") * S("structure_share")
    dependent = 2 * S("structure_time") * S("inv_dt")
    dependent = dependent if layout.lean else sp.Max(1, dependent)
    timing = S("timing_error") * S("output_rate")
    lines: list[Statement] = [
        *direct,
        *functions,
        Assign("response", model_part, "output of the model"),
        Assign("predicted", S("response") + (S(BIAS) if BIAS in at else 0)),
        Assign("output_rate", speed),
        Assign(
            "activity",
            S("activity") + share("activity_rate") * (S("response") ** 2 - S("activity")),
        ),
        Assign(
            "noise",
            S("noise_scale") * (S("noise_variance") + timing**2 + structural * S("activity") * dependent),
            "variance of the measurement",
        ),
        *_validity(layout, states),
    ]
    own = (update or _update)(layout, H)
    unused = (*unmeasured(layout), *unheard) if layout.lean else ()
    lines.append(When(S("usable") > sp.Rational(1, 2), (*own, *further), unused, "measurement"))
    return [*lines, *move_unknown(layout.reduction.unknowns[0], "move", move)]


def unmeasured(layout: Layout) -> tuple[Assign, ...]:
    """What goes out for a sample without a measurement."""
    return (
        Assign("innovation", sp.Integer(0)),
        Assign("innovation_variance", S("noise_scale") * S("noise_variance")),
    )


def _feedthrough(layout: Layout, output: sp.Expr) -> tuple[list[Assign], dict[str, sp.Expr]]:
    """The input at the end of the step where the output shows it at once, and what follows for its errors."""
    slope = S("output_scale") * output.diff(S("u_end"))
    if slope == 0:
        return [], {}
    unit = layout.inverted(1 / layout.reduction.groups.scale[layout.input.name])
    acting = (S(INPUT_SCALE) if INPUT_SCALE in layout.errors else 1) * S("u_now")
    offset = S(OFFSET) if OFFSET in layout.errors else 0
    line = Assign("u_end", (acting + offset + S(DISTURBANCE)) * unit, "input at the end of the step [-]")
    return [line], {DISTURBANCE: slope * unit, OFFSET: slope * unit, INPUT_SCALE: slope * unit * acting}


def _validity(layout: Layout, states: Mapping[sp.Symbol, sp.Symbol]) -> list[Statement]:
    groups = layout.reduction.groups
    if groups.model.validity is None:
        return []
    physical = {q.symbol: groups.scale[q.name] * states[q.symbol] for q in groups.model.states}
    signal = layout.inverted(groups.model.validity[0].subs(physical, simultaneous=True))
    return [
        Assign("validity_now", signal, groups.model.validity[1].meaning),
        Assign("validity_then", S("validity") * (1 - share("validity_rate"))),
        Assign("validity_square", S("validity_now") ** 2),
        Assign("validity", sp.Max(S("validity_square"), S("validity_then"))),
    ]


def innovate(variance: sp.Expr, seen: Sequence[Statement] = ()) -> list[Statement]:
    """Innovation, variance and weight; ``seen`` is done with its square before an outlier's is cut."""
    nu = S("innovation")
    return [
        Assign("innovation", S("measured") - S("predicted")),
        Assign("innovation_variance", variance),
        Assign("inv_spread", 1 / S("innovation_variance")),
        Assign("nis", nu * nu * S("inv_spread"), "normalised innovation squared"),
        *seen,
        When(
            S("nis") > S("outlier_ratio"),
            (Assign("inv_spread", S("inv_spread") * S("outlier_ratio") / S("nis")),),
            (),
            "an outlier counts for less",
        ),
    ]


def _update(layout: Layout, H: Mapping[int, sp.Expr]) -> list[Statement]:
    """Kalman update with a bounded innovation; unknowns are held while nothing excites them."""
    P = layout.covariance
    names = layout.coordinates
    t = names.index(layout.target)
    early = sorted({*H, t})
    lines: list[Statement] = list(column(P, H, "c", early))
    total = sp.Add(*(entry * S(f"c_{k}") for k, entry in H.items())) + S("noise")
    lines += [
        *innovate(total, _warm(layout)),
        Assign("inv_P", 1 / P[t, t]),
        Assign("sensitivity", S(f"c_{t}") * S("inv_P"), f"of the output to ln {layout.target}"),
        Assign(
            "excitation",
            S("excitation") + share("excitation_rate") * (S("sensitivity") ** 2 - S("excitation")),
        ),
        Assign(
            "excited",
            sp.Piecewise((1, S("excitation") > S("excitation_ratio") * S("noise")), (0, True)),
        ),
        Assign("linear", sp.Piecewise((1, linear_range(layout)), (0, True)), "1 in the model's linear range"),
        Assign("odd", sp.Min(S("nis"), 9) - 1, "by how much it is not as expected"),
        surprise(),
        *_leave(layout),
        heard(),
        *jump(),
        Assign(
            "learn_slow",
            sp.Piecewise((S("learn"), S("jump") <= 0), (0, True)),
            "a jump is not blamed on what cannot jump",
        ),
        Assign("unlearnt", S("unlearnt") + dt),
        Assign(
            "learn_seldom",
            sp.Piecewise((S("learn_slow"), S("unlearnt") >= S("seldom")), (0, True)),
            "the next sample tells little that this one does not",
        ),
        When(S("learn_seldom") > 0, (Assign("unlearnt", sp.Integer(0)),), ()),
    ]
    gains = {i: S(f"gain_{i}") for i, name in enumerate(names) if name not in layout.considered}
    weight = weights(layout, gains)
    gained, nu = S("gained"), S("innovation")
    lines += [
        Assign(gains[t].name, S(f"c_{t}") * S(weight[t])),
        Assign("gained", gains[t] * S(f"c_{t}") * S("inv_P"), "share of the variance removed"),
        Assign(
            "information",
            S("information") + gained * (1 + gained) * S("inv_P"),
            "1/variance gained",
        ),
        Assign("move", S("move") + gains[t] * nu),
    ]
    others = {i: gain for i, gain in gains.items() if i != t}
    ranks = {i: ORDER.index(weight[i]) for i in gains}
    corrected = column(P, H, "c", (i for i in range(P.n) if i not in early))
    corrected += [Assign(gain.name, S(f"c_{i}") * S(weight[i])) for i, gain in others.items()]
    corrected += [*reduce_by(P, gains, ranks, "c"), *state_update(layout, others)]
    lines += as_part("correct", corrected)
    lines += adapt(layout)
    return lines


def _leave(layout: Layout) -> list[Statement]:
    """What the innovation counts with for the first unknown.

    Beyond the linear range an innovation tells first how the model bends there, and what that misses stays
    for a while: what bends it learns from every sample, the rest from one in ``beyond_time``.
    """
    heard = S("excited") * S("inv_spread")
    if not layout.beyond:
        return [Assign("learn", heard)]
    teaches = sp.Or(S("linear") > sp.Rational(1, 2), S("untaught") >= S("beyond_time"))
    return [
        Assign("learn_beyond", heard),
        Assign("untaught", S("untaught") + dt),
        Assign("learn", sp.Piecewise((heard, teaches), (0, True)), "its error there lasts"),
        When(S("learn") > 0, (Assign("untaught", sp.Integer(0)),), ()),
    ]


def weights(layout: Layout, rows: Iterable[int], learn: str = "learn") -> dict[int, str]:
    """Index -> name of what the innovation counts with for that coordinate."""
    names = layout.coordinates
    weight = {n: "learn_slow" for n in (*layout.unknowns, INPUT_SCALE)} | {layout.target: learn}
    weight |= dict.fromkeys(layout.seldom, "learn_seldom") | dict.fromkeys(layout.beyond, "learn_beyond")
    return {i: weight.get(names[i], "inv_spread") for i in rows}


def _warm(layout: Layout) -> list[Statement]:
    """Let the first samples count for less."""
    if not layout.warming:
        return []
    wide = S("innovation_variance") + S("heat") * S("noise")
    return [
        Assign("inv_spread", 1 / wide, "the first samples count for less"),
        Assign("heat", S("heat") * (1 - share("heat_rate"))),
    ]


def linear_range(layout: Layout) -> sp.Basic:
    """Whether the model is in its linear range; beyond it an innovation tells of the tyre law."""
    if layout.reduction.groups.model.validity is None:
        return sp.true
    return S("validity") < S("validity_limit") ** 2


def state_update(layout: Layout, gains: Mapping[int, sp.Symbol]) -> list[Assign]:
    """Every coordinate but the first unknown, which moves at the end of the step."""
    nu = S("innovation")
    lines: list[Assign] = []
    kinds = {u.name: u for u in layout.reduction.unknowns}
    for i, gain in gains.items():
        name = layout.coordinates[i]
        if name == INPUT_SCALE or (name in kinds and kinds[name].kind == "log"):
            lines.append(Assign(f"move_{name}", gain * nu))
            lines += move_log(name, f"move_{name}")
        else:
            lines.append(Assign(name, S(name) + gain * nu))
    return lines


def move_unknown(unknown: Unknown, by: str, move: Move = move_log) -> list[Assign]:
    """Move an unknown's coordinate; a logarithm as ``move`` says."""
    if unknown.kind == "linear":
        return [Assign(unknown.name, unknown.symbol + S(by))]
    return move(unknown.name, by)
