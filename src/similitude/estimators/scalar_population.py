"""A Kalman filter of one unknown: the population's averages stand for everything else.

    y' = w - a y + c u       a = K M2 s2,  c = K B1 s1        y the output, w what the other state adds
    w' =   - b y + d u       b = K K1 s3 + K^2 K2 s4,  d = K^2 G2 s4'        (coefficients of `second_order`)

One trapezoidal step a sample carries y, w and their sensitivity to ln K; its determinant 1 + q a + q^2 b,
q half the time step, is above one for a model that is stable at its averages. With p the variance of ln K,

    g = p s/(s^2 p + R),    ln K <- ln K + g e,    p <- (1 - g s) p + drift dt
    R = noise + (mean square of e - noise) 2 structure_time/dt

What the noise does not explain in e is error of the model and lasts ``structure_time``, so its samples count
for less. Offsets of input and output are taken out of e and s alike; a slow pull keeps the model with the
car. What the frozen unknowns' spread over the population does to K is no noise and does not average out: the
variance handed out is p plus ``frozen_variance``.

Invariant: whatever the sample holds, the next usable samples count; p never exceeds where it started.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.estimators import least_squares as ls
from similitude.estimators.held_sample import (
    HALF,
    S,
    gate_config,
    gate_state,
    gate_variables,
    gates,
    remember,
)
from similitude.estimators.ladder_fields import learnt_status
from similitude.estimators.second_order import SecondOrder, second_order
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction
from similitude.status import STATUS

STATES = ("y", "w", "y_slope", "w_slope", "error_offset", "slope_offset")
GAINS = ("input_gain", "damping", "stiffness", "pair_output", "pair_input")


def scalar_population_filter(reduction: Reduction, *, unknown: str = "pi3") -> Program:
    """Derive the step program of the one-unknown filter from a reduced model.

    Parameters
    ----------
    reduction : Reduction    as `second_order` takes it.
    unknown : the group that carries the unknown.

    Returns
    -------
    Program    ``<model>_scalar_population``; sample and output begin as those of the population filter.

    Raises
    ------
    ModelError    the model is not one `second_order` holds for.
    """
    model = second_order(reduction, unknown=unknown)
    groups, layout = reduction.groups, model.layout
    fields = _state(model)
    names = [s.name for f in fields for s in f.symbols]
    start = {name: getattr(model, name) for name in GAINS} | {
        model.target: S(f"{model.target}_start"),
        "p": S("start_variance"),
        f"last_{model.speed}": S(f"{model.speed}_least"),
        "slowness": 1 / S(f"{model.speed}_least"),
        "inv_interval": 1 / S("sample_time"),
    }
    return Program(
        name=f"{groups.model.name}_scalar_population",
        title=f"Kalman filter of one unknown for the {groups.model.name}",
        provenance=(
            f"model: {groups.model.name}, {groups.model.source}",
            f"base: {', '.join(groups.base)}",
            f"unknown: {model.target}; frozen: {', '.join(model.frozen)}",
        ),
        config=_config(model),
        state=fields,
        sample=ff.sample_fields(layout),
        output=ff.estimate_fields(layout),
        variables=(
            *gate_variables(model),
            Field("excited", "-", "1 where the input says enough"),
            Field("edge", "-", "1 where the estimate sits at the edge of the population"),
        ),
        init=tuple(Assign(name, sp.sympify(start.get(name, 0))) for name in names),
        step=tuple(_step(model)),
        status=STATUS,
    )


def _config(model: SecondOrder) -> tuple[Field, ...]:
    layout, target = model.layout, model.reduction.unknowns[0]
    o = layout.output
    validity = model.reduction.groups.model.validity
    frozen = [u for u in model.reduction.unknowns if u.name in model.frozen]
    return (
        *(Field(q.name, q.unit, q.meaning) for q in layout.scales),
        *(Field(u.name, u.unit, f"frozen {u.meaning}") for u in frozen),
        Field("sample_time", "s", "time between samples"),
        Field(f"{target.name}_start", target.unit, f"{target.name} before the first update"),
        Field(f"{target.name}_low", target.unit, f"least {target.name} of the population"),
        Field(f"{target.name}_high", target.unit, f"greatest {target.name} of the population"),
        Field("start_variance", "-", f"variance of ln {target.name} of the population"),
        Field("frozen_variance", "-", "what the frozen unknowns' spread adds to it"),
        Field("noise_variance", f"({o.unit})^2", f"white noise of {o.name} a sample, > 0"),
        Field("drift", "1/s", f"diffusion of ln {target.name}"),
        Field("structure_time", "s", "how long an error of the model lasts"),
        Field("scatter_rate", "1/s", "averaging rate of the error's mean square"),
        Field("offset_rate", "1/s", "rate at which offsets are followed and taken out"),
        Field("observer_rate", "1/s", "pull of the model towards the measurement"),
        Field("move_limit", "-", f"greatest move of ln {target.name} in one sample"),
        Field("excitation_least", "-", "least mean square of the sensitivity to learn from, in its units"),
        Field("excitation_rate", "1/s", "averaging rate of that mean square"),
        Field("variance_limit", "-", "greatest variance that is reported"),
        *gate_config(model),
        Field("validity_limit", validity[1].unit if validity else "-", "edge of the model's linear range"),
    )


def _state(model: SecondOrder) -> tuple[Field, ...]:
    o, target = model.layout.output, model.reduction.unknowns[0]
    return (
        Field(target.name, target.unit, target.meaning),
        Field("p", "-", f"variance of ln {target.name}"),
        *(Field(name, "-", f"{name.replace('_', ' ')} of the model") for name in GAINS),
        Field("inv_interval", "1/s", "1/sample time"),
        Field("y", o.unit, f"{o.name} of the model"),
        Field("w", f"{o.unit}/s", "what the other state adds to its rate"),
        Field("y_slope", o.unit, f"sensitivity of y to ln {target.name}"),
        Field("w_slope", f"{o.unit}/s", "the same of w"),
        Field("error_offset", o.unit, "slow part of the error"),
        Field("slope_offset", o.unit, "slow part of the sensitivity"),
        Field("mean_square", f"({o.unit})^2", "mean square of the error"),
        Field("excitation", f"({o.unit})^2", "mean square of the sensitivity"),
        Field("slowness", f"1/({model.layout.signals[0].unit})", f"1/last {model.speed}"),
        *gate_state(model),
    )


def _step(model: SecondOrder) -> list[Statement]:
    dt = S("dt")
    another = (
        Assign(f"last_{model.speed}", S("scale_now")),
        Assign("slowness", 1 / S(f"last_{model.speed}")),
    )
    moving = sp.And(S("live") > HALF, dt > S("dt_low"), dt < S("dt_high"))
    return [
        Assign("predicted", S("last_measured")),
        Assign("innovation", sp.Integer(0)),
        When(
            sp.And(dt > 0, dt < 1e6),
            (
                *gates(model, another),
                Assign("u", (S("last_input") + S("u_now")) / 2, "mean of the sample's two ends"),
                *_coefficients(model),
                When(moving, (*_move(), *_compare(model)), _anew(), "the step is one sample long"),
                *remember(),
            ),
            (Assign("status", sp.Integer(STATUS["bad_sample"])),),
            "time must advance",
        ),
        Assign("estimate", S(model.target)),
        Assign("innovation_variance", sp.Max(S("mean_square"), S("noise_variance"))),
        Assign("variance", sp.Min(S("p") + S("frozen_variance"), S("variance_limit"))),
    ]


def _coefficients(model: SecondOrder) -> list[Statement]:
    """a, b, c, d of the head, and b's own sensitivity, at the scale and unknown of now."""
    K, by = S(model.target), _scaled(model)
    return [
        Assign("a", K * S("damping") * by(model.per_rate)),
        Assign("b_1", K * S("stiffness") * by(model.per_output)),
        Assign("b_2", K**2 * S("pair_output") * by(model.per_pair_output)),
        Assign("b", S("b_1") + S("b_2")),
        Assign("b_slope", S("b_1") + 2 * S("b_2")),
        Assign("c", K * S("input_gain") * by(model.per_input_rate)),
        Assign("d", K**2 * S("pair_input") * by(model.per_pair_input)),
    ]


def _scaled(model: SecondOrder):
    """Expressions of the scales with the measured one's reciprocal from the state."""
    layout, speed = model.layout, model.speed
    known = {layout.inverse(speed): S("slowness"), layout.at(speed): S(f"last_{speed}")}
    known |= {layout.inverse(q.name): 1 / q.symbol for q in layout.scales}
    return lambda expression: layout.inverted(expression).xreplace(known)


def _move() -> list[Statement]:
    """The trapezoidal step of the model, and of its sensitivity along the mean of its ends."""
    q, y, w, u = S("q"), S("y"), S("w"), S("u")
    middle, after = S("y_middle"), S("y_after")

    def step(y: sp.Symbol, w: sp.Symbol, into_y: sp.Expr, into_w: sp.Expr, name: str) -> list[Statement]:
        forced = S(f"{name}_forced")
        return [
            Assign(f"{name}_forced", w - q * S("b") * y + 2 * q * into_w),
            Assign(f"{name}_after", S("inv_det") * ((1 - S("qa")) * y + q * (w + 2 * into_y + forced))),
        ]

    return [
        Assign("q", S("dt") / 2),
        Assign("qa", q * S("a")),
        Assign("inv_det", 1 / (1 + S("qa") + q * (q * S("b")))),
        *step(y, w, S("c") * u, S("d") * u, "y"),
        Assign("y_middle", (y + after) / 2),
        Assign("w", S("y_forced") - q * S("b") * after),
        *step(
            S("y_slope"),
            S("w_slope"),
            S("c") * u - S("a") * middle,
            2 * S("d") * u - S("b_slope") * middle,
            "y_slope",
        ),
        Assign("w_slope", S("y_slope_forced") - q * S("b") * S("y_slope_after")),
        Assign("y", after),
        Assign("y_slope", S("y_slope_after")),
    ]


def _anew() -> tuple[Statement, ...]:
    """The model at rest where the car is."""
    rest = {"y": S("y_now"), "w": S("a") * S("y_now") - S("c") * S("u")}
    return tuple(Assign(name, sp.sympify(rest.get(name, 0))) for name in STATES)


def _compare(model: SecondOrder) -> list[Statement]:
    """Error and sensitivity without their slow parts; what is learnt; the pull."""
    e, s, dt = S("error"), S("y_slope"), S("dt")
    follow = S("usable") * sp.Min(1, dt * S("offset_rate"))
    pull = S("usable") * sp.Min(1, dt * S("observer_rate"))
    learn = sp.And(S("fresh") > S("settle_samples"), S("excited") > HALF)
    seen = sp.Min(1, dt * S("scatter_rate")) * (S("residual") ** 2 - S("mean_square"))
    aged = S("p") + dt * S("drift")
    return [
        Assign("error", S("y_now") - S("y")),
        Assign("follow", follow),
        Assign("error_offset", S("error_offset") + S("follow") * (e - S("error_offset"))),
        Assign("slope_offset", S("slope_offset") + S("follow") * (s - S("slope_offset"))),
        Assign("psi", s - S("slope_offset"), "sensitivity without its slow part"),
        Assign("residual", e - S("error_offset"), "error without its slow part"),
        Assign("predicted", S("y_now") - S("residual")),
        When(
            S("usable") > HALF,
            (
                Assign("innovation", S("residual")),
                Assign("mean_square", S("mean_square") + seen),
                *ls.excite(S("psi")),
                When(learn, tuple(_learn(model)), (), "the input says something of the unknown"),
            ),
        ),
        Assign("p", sp.Min(aged, S("start_variance")), "unseen, K may change"),
        Assign("pull", pull),
        Assign("y", S("y") + S("pull") * S("residual")),
        Assign("y_slope", S("y_slope") - S("pull") * S("psi")),
    ]


def _learn(model: SecondOrder) -> list[Statement]:
    """One scalar update; exp to third order keeps the unknown positive."""
    K, p, psi, move = S(model.target), S("p"), S("psi"), S("move")
    lasting = 2 * S("structure_time") * S("inv_interval")
    rest = sp.Max(0, S("mean_square") - S("noise_variance"))
    return [
        Assign("weighed", S("noise_variance") + lasting * rest),
        Assign("gain", p * psi / (psi**2 * p + S("weighed"))),
        Assign("wanted", S("gain") * S("residual")),
        Assign("move", sp.Max(-S("move_limit"), sp.Min(S("move_limit"), S("wanted")))),
        Assign("p", p - S("gain") * psi * p),
        Assign(K.name, K * (1 + move * (1 + move * (HALF + move / 6)))),
        *ls.keep_within(K.name),
        *learnt_status(model),
    ]
