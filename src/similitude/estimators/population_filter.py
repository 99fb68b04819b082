"""The population filter: an extended Kalman filter in log groups with the population as prior.

State: dimensionless dynamics, a disturbance (equivalent input), the slow unknowns of a Reduction,
an input offset and an output bias. Positive unknowns are stored themselves, their covariance is
that of the logarithm, and they move by K <- K (2 + d)/(2 - d), |d| <= 1.

Rules the noise follows: no floor in the process noise of the dynamics; model error goes into the
measurement variance and into the disturbance, whose sizes adapt to the innovations; the unknowns
are held while their sensitivity is below the noise it is weighed against.

Invariant: whatever the sample holds, every state stays finite and the variances positive.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.errors import ProgramError
from similitude.estimators import filter_covariance as cov
from similitude.estimators import filter_fields as ff
from similitude.estimators.filter_fields import (
    BIAS,
    DISTURBANCE,
    INPUT_SCALE,
    OFFSET,
    PLAIN_OFFSET,
    Layout,
)
from similitude.estimators.filter_gates import gates, restart
from similitude.estimators.filter_interval import interval
from similitude.estimators.filter_lean import lean_dynamics, lean_update
from similitude.estimators.further_fields import further_variables
from similitude.estimators.further_lean import forget
from similitude.estimators.further_output import further_updates
from similitude.estimators.lean_correction import keep_each_within, move_square
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction
from similitude.sampling import implicit_step
from similitude.status import STATUS

LEAST_STEP = sp.Float(1e-6)  # s: below it 1/dt says nothing any more, and overflows in the end
LONGEST_STEP = sp.Float(1e6)  # s
LEAST_SHARE = sp.Rational(1, 3000)  # of the greatest scale: keeps the step finite; 0.05 m/s of a car


# Working values of the step whose names do not follow from the model; no unknown may be called so.
WORKING = frozenset(
    "above above_move away cold bounded_move doubt expected follow gained h i_det inv_P inv_det "
    "inv_dt inv_output_scale keep keep_w leant learn learn_beyond learn_seldom learn_slow least_scale "
    "linear lost nis noise noise_change odd output_rate output_scale p pp q qq ramp response rise "
    "seen sensitivity span steer steer_change told u u_end u_plain unseen validity_now "
    "validity_square validity_then w_nominal".split()
)


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def population_filter(reduction: Reduction, *, warming: bool = False) -> Program:
    """Derive the filter's step program from a reduced model: every unknown and sensor error carried.

    Parameters
    ----------
    reduction : Reduction    one input, one output, any number of states and unknowns.
    warming : whether the first samples count for less, falling off over a configured time.

    Returns
    -------
    Program    config, state, sample and output structs; ``init`` and ``step``.

    References
    ----------
    Brennan & Alleyne 2004, section 5, for the idea; the filter is this project's own.
    """
    return filter_program(Layout(reduction, warming=warming), "population", "Population filter")


def filter_program(layout: Layout, name: str, title: str) -> Program:
    """The step program of the filter that carries what the layout says."""
    reduction = layout.reduction
    model = reduction.groups.model
    taken = sorted(WORKING.intersection(layout.unknowns))
    if taken:
        raise ProgramError(
            f"the population filter of {model.name!r} uses {', '.join(taken)} for something else",
            usually="An unknown has the name of a working value of the filter's step.",
            paste=f"Unknown('{taken[0]}_group', ...)   # another name for the unknown",
            read="docs/architecture.md, 'Step programs'",
        )
    return Program(
        name=f"{model.name}_{name}",
        title=f"{title} of the {model.name}",
        provenance=(
            f"model: {model.name}, {model.source}",
            f"base: {', '.join(reduction.groups.base)}",
            f"unknowns: {', '.join(u.name for u in reduction.unknowns)}",
            f"coordinates: {', '.join(layout.coordinates)}",
        ),
        config=ff.config_fields(layout),
        state=ff.state_fields(layout),
        sample=ff.sample_fields(layout),
        output=(*ff.output_fields(layout), *ff.monitored_fields(layout)),
        variables=_variables(layout),
        init=tuple(_init(layout)),
        step=tuple(_step(layout)),
        status=STATUS,
        coordinates=layout.coordinates,
    )


def _variables(layout: Layout) -> tuple[Field, ...]:
    return (
        Field("status", "-", "status code"),
        Field("u_now", layout.input.unit, "input used now"),
        *(Field(f"{q.name}_now", q.unit, "scale used now") for q in layout.signals),
        Field("anew", "-", "1 where the dynamic state starts anew"),
        Field("usable", "-", "1 where input, scale and measurement can be used"),
        Field("diffusion", "1/s", "diffusion of the first unknown now"),
        Field("inv_spread", "-", "1/variance the innovation counts with"),
        Field("move", "-", "change of the first unknown's logarithm"),
        *(f for q in layout.further for f in further_variables(q, lean=layout.lean)),
        *(Field(f"d_{name}", "-", "change over the step") for name in layout.fast if layout.lean),
        *([Field("linear", "-", "1 in the model's linear range")] if layout.lean else []),
        *(
            Field(f"{n}learn_seldom", "-", "1/variance for what is learnt now and then")
            for n in ("", *(f"{q.name}_" for q in layout.further))
            if layout.lean and layout.seldom
        ),
    )


def _init(layout: Layout) -> list[Statement]:
    """The state before the first sample: the prior."""
    P, prior = layout.covariance, layout.prior
    at = {name: i for i, name in enumerate(layout.coordinates)}
    lines: list[Statement] = [
        Assign(name, sp.Integer(0)) for name in (*layout.fast, *layout.companion, DISTURBANCE)
    ]
    lines += [Assign(name, S(f"{name}_prior")) for name in layout.unknowns]
    lines += [Assign(name, sp.Integer(name == INPUT_SCALE)) for name in layout.errors]
    lines += [Assign(P.target(i, j), sp.Integer(0)) for i in range(P.n) for j in range(i, P.n)]
    biases = tuple(f"{q.name}_bias" for q in layout.further)
    lines += [
        Assign(P.target(at[n], at[n]), S(f"{n}_sd") ** 2) for n in (*layout.fast, *layout.errors, *biases)
    ]
    lines += [
        Assign(P.target(at[a], at[b]), prior[i, j])
        for i, a in enumerate(layout.unknowns)
        for j, b in enumerate(layout.unknowns)
        if j >= i
    ]
    lines += [Assign(name, sp.Integer(1)) for name in ("noise_scale", "surprise", "settling")]
    lines.append(Assign("disturbance_scale", S("disturbance_scale_start")))
    names = [
        "restlessness",
        "jump",
        "heard",
        "activity",
        "excitation",
        "excited",
        "unlearnt",
        "validity",
        "information",
        "last_input",
        "age",
        "started",
    ]
    names += ["untaught"] if layout.beyond else []
    names += [f"last_{q.name}" for q in layout.signals if not layout.lean]
    least = S("signal_limit") * LEAST_SHARE
    lines += [Assign(f"last_{q.name}", least) for q in layout.signals if layout.lean]
    names += ["turn"] if layout.lean else []
    names += [f"{q.name}_{part}" for q in layout.further for part in ("bias", "activity")]
    if layout.lean:
        names += [f"{q.name}_with_{i}" for q in layout.further for i in range(P.n)]
        names += [f"{q.name}_spread" for q in layout.further]
        lines += forget(layout)
    lines += [Assign(f"{q.name}_noise_scale", sp.Integer(1)) for q in layout.further]
    if layout.leans_on_offset:
        names.append(PLAIN_OFFSET)
    if layout.warming:
        lines.append(Assign("heat", S("heat_start")))
    lines.append(
        Assign(
            P.target(at[DISTURBANCE], at[DISTURBANCE]),
            S("disturbance_scale") * S("disturbance_floor") ** 2,
        )
    )
    return lines + [Assign(name, sp.Integer(0)) for name in names]


def _step(layout: Layout) -> list[Statement]:
    dt = S("dt")
    usable_time = sp.And(dt > LEAST_STEP, dt < LONGEST_STEP)
    lost = sp.Piecewise((LONGEST_STEP, dt > 1), (S("age"), True))
    return [
        Assign("status", sp.Integer(STATUS["ok"])),
        Assign("predicted", S(BIAS) if BIAS in layout.errors else sp.Integer(0)),
        *(() if layout.lean else cov.unmeasured(layout)),
        *_handed_out(
            layout,
            Assign("noise_now", S("innovation_variance")),
            Assign("disturbance_now", S("disturbance_scale") * S("disturbance_floor") ** 2),
        ),
        When(
            usable_time,
            (
                *gates(layout),
                *restart(layout),
                *_dynamics(layout),
                *_measurement(layout),
                *_after(layout),
            ),
            (
                Assign("status", sp.Integer(STATUS["bad_sample"])),
                Assign("age", lost, "an endless pause is a gap for the next sample"),
                *(cov.unmeasured(layout) if layout.lean else ()),
            ),
            "time must advance",
        ),
        Assign("estimate", S(layout.target)),
        *interval(layout),
        Assign("information_gained", S("information")),
        *_handed_out(
            layout,
            *(Assign(f"{name}_now", S(name)) for name in layout.unknowns[1:]),
            Assign("offset_now", S(OFFSET)),
            Assign("bias_now", S(BIAS)),
        ),
    ]


def _handed_out(layout: Layout, *lines: Assign) -> tuple[Assign, ...]:
    """The lines, where a monitor may follow beside the filter."""
    return lines if layout.monitored else ()


def _dynamics(layout: Layout) -> list[Statement]:
    """Rescale by the changed scales, step, propagate the covariance."""
    reduction, groups = layout.reduction, layout.reduction.groups
    always, lines = _scales(layout), []
    for name, q in zip(layout.fast, groups.model.states, strict=True):
        ratio = layout.inverted(groups.scale[q.name].xreplace(_before(layout)) / groups.scale[q.name])
        lines.append(Assign(f"ratio_{name}", ratio, "same physical state in the new scales"))
        lines.append(Assign(name, S(name) * S(f"ratio_{name}")))
        if layout.companion:
            lines.append(Assign(f"{name}_plain", S(f"{name}_plain") * S(f"ratio_{name}")))
    scale = S(INPUT_SCALE) if INPUT_SCALE in layout.errors else sp.Integer(1)
    offset = S(OFFSET) if OFFSET in layout.errors else sp.Integer(0)
    lines.append(Assign("steer", scale * (S("last_input") + S("u_now")) / 2, "mean of the sample's two ends"))
    if layout.fine:
        lines.append(Assign("steer_change", scale * (S("u_now") - S("last_input"))))
    plain = S("steer") + (S(PLAIN_OFFSET) if layout.leans_on_offset else 0)
    unit = layout.inverted(1 / groups.scale[layout.input.name])
    lines.append(Assign("u_plain", plain * unit, "measured input less its offset [-]"))
    lines.append(Assign("u", (S("steer") + offset + S(DISTURBANCE)) * unit, "effective input [-]"))
    states = {q.symbol: S(n) for q, n in zip(groups.model.states, layout.fast, strict=True)}
    replace = {**states, layout.input.symbol: S("u")}
    rates = [layout.inverted(reduction.rates[q.name].xreplace(replace)) for q in groups.model.states]
    chain = {u.name: u.jacobian for u in layout.reduction.unknowns} | {"u": unit}
    companion = {S(n): S(f"{n}_plain") for n in (*layout.fast, "u")} if layout.companion else None
    fast = [S(n) for n in layout.fast]
    ramp = ("u", S("steer_change")) if layout.fine else None
    halves = 2 if layout.fine else 1
    step = implicit_step(rates, fast, parameters=chain, companion=companion, ramp=ramp, halves=halves)
    ratios = [S(f"ratio_{name}") for name in layout.fast]
    if layout.lean:
        return [*always, *lean_dynamics(layout, (*lines, *step.statements), step, ratios)]
    lines += step.statements
    lines += cov.time_update(layout, step, ratios)
    lines += [Assign(name, step.after[i]) for i, name in enumerate(layout.fast)]
    if layout.companion:
        lines.append(Assign("follow", sp.Min(1, S("dt") * S("companion_rate"))))
    if layout.leans_on_offset:
        lines.append(
            Assign(
                PLAIN_OFFSET,
                S(PLAIN_OFFSET) + sp.Min(1, S("dt") * S("offset_rate")) * (offset - S(PLAIN_OFFSET)),
            )
        )
    for i, name in enumerate(layout.fast if layout.companion else ()):
        own = step.companion_after[i]
        lines.append(Assign(f"{name}_plain", own + S("follow") * (S(name) - own)))
    return [*always, *lines]


def _measurement(layout: Layout) -> list[Statement]:
    if layout.lean:
        return cov.measurement(layout, update=lean_update, unheard=forget(layout), move=move_square)
    return cov.measurement(layout, further_updates(layout))


def _scales(layout: Layout) -> list[Statement]:
    """Scales used now and before, kept off zero, with their reciprocals taken once."""
    groups = layout.reduction.groups
    lines: list[Statement] = []
    if layout.signals:
        lines.append(Assign("least_scale", S("signal_limit") * LEAST_SHARE))
    least = S("least_scale")
    for q in layout.signals:
        lines.append(Assign(f"at_{q.name}", sp.Max(S(f"{q.name}_now"), least), "kept off zero"))
        if not layout.lean:
            lines.append(Assign(f"was_{q.name}", sp.Max(S(f"last_{q.name}"), least)))
    lines += [
        Assign(layout.inverse(q.name).name, 1 / layout.at(q.name)) for q in (*layout.signals, *layout.scales)
    ]
    output = layout.inverted(groups.scale[layout.output.name])
    span = sp.Piecewise((S("dt"), S("dt") < S("gap")), (0, True))
    step = S("dt" if layout.lean else "span")
    return [
        *lines,
        *([Assign("held", sp.Min(S("dt"), S("longest")))] if layout.lean else []),
        Assign("inv_dt", 1 / S("held" if layout.lean else "dt")),
        Assign("output_scale", output, f"{layout.output.name} = scale x dimensionless"),
        Assign("inv_output_scale", layout.inverted(1 / groups.scale[layout.output.name])),
        *([] if layout.lean else [Assign("span", span, "[s] the dynamics start anew at the end of a gap")]),
        Assign("h", step * layout.inverted(1 / groups.time_scale), "dimensionless time step"),
    ]


def _before(layout: Layout) -> dict[sp.Symbol, sp.Symbol]:
    was = "last" if layout.lean else "was"
    return {q.symbol: S(f"{was}_{q.name}") for q in layout.signals}


def _after(layout: Layout) -> list[Statement]:
    """Remember this sample; keep every unknown inside what the population allows."""
    lines: list[Statement] = [] if layout.lean else [_keep_within(layout.moving)]
    lines += _handed_out(
        layout,
        Assign("noise_now", S("noise")),
        Assign("disturbance_now", S("disturbance_scale") * S("w_nominal")),
    )
    lines.append(Assign("last_input", S("u_now")))
    used = "at_{}" if layout.lean else "{}_now"
    lines += [Assign(f"last_{q.name}", S(used.format(q.name))) for q in layout.signals]
    after = [Assign("age", sp.Integer(0)), Assign("started", sp.Integer(1))]
    after += keep_each_within([layout.target]) if layout.lean else []  # unmeasured it goes to its prior
    return [*lines, When(S("usable") > sp.Rational(1, 2), tuple(after))]


def _keep_within(names: Sequence[str]) -> When:
    """Unknowns inside what the population allows; the status says where one was not."""
    hit = [r for n in names for r in (S(n) < S(f"{n}_low"), S(n) > S(f"{n}_high"))]
    clip = [Assign(n, sp.Min(sp.Max(S(n), S(f"{n}_low")), S(f"{n}_high"))) for n in names]
    at_limit = When(S("usable") > sp.Rational(1, 2), (Assign("status", sp.Integer(STATUS["at_limit"])),), ())
    return When(sp.Or(*hit), (*clip, at_limit), (), "prior +- its allowed range")
