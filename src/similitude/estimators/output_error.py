"""Recursive prediction error method: the model runs along the input, its sensitivity says which way to move.

    x' = f(x, K, u) + g (measured - r)      the model, started at rest; r = its output
    s' = df/dx s + df/dK K - g s_r          its sensitivity to ln K
    e  = measured - r,  both e and s_r high-passed against offsets of input and output
    A  = sum of s^2 with forgetting,        ln K <- ln K + s e/A

The model takes one implicit step a sample, stable at any speed and rate; the ratio of the old to the new
scale carries its state over a change of speed. g is a slow pull towards the measurement, raised by what an
unstable car needs; without it the model would run away from such a car.

Invariant: the model's state stays within ``state_limit``; beyond it starts anew at rest.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import least_squares as ls
from similitude.estimators.held_sample import HALF, S, set_status
from similitude.estimators.ladder_fields import learnt_status
from similitude.estimators.ladder_program import ladder_program
from similitude.estimators.second_order import SecondOrder, second_order
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction
from similitude.sampling import ImplicitStep, implicit_step


def output_error_method(reduction: Reduction, *, unknown: str = "pi3") -> Program:
    """Derive the step program of the recursive prediction error method from a reduced model.

    Parameters
    ----------
    reduction : Reduction    as `second_order` takes it; one of its states is the output.
    unknown : the group that carries the unknown.

    Returns
    -------
    Program    ``<model>_output_error``; sample and output begin as those of the population filter.

    Raises
    ------
    ModelError    the model is not one the method is built for here.

    References
    ----------
    L. Ljung, T. Soderstrom, Theory and Practice of Recursive Identification (1983), chapter 3.
    """
    model = second_order(reduction, unknown=unknown)
    o = model.layout.output
    states = [Field(name, "-", "dimensionless state of the model") for name in model.layout.fast]
    states += [Field(f"{name}_slope", "-", "its sensitivity to the logarithm") for name in model.layout.fast]
    return ladder_program(
        model,
        name="output_error",
        title="Recursive prediction error method",
        config=(
            Field("forgetting_rate", "1/s", "rate at which the past is forgotten"),
            Field("noise_variance", f"({o.unit})^2", f"variance of {o.name} a sample, > 0"),
            Field("start_variance", "-", f"variance of ln {model.target} before the first update, > 0"),
            Field("observer_rate", "1/s", "pull of the model towards the measurement"),
            Field("observer_margin", "1/s^2", "stiffness of the motion below which the pull is raised"),
            Field("offset_rate", "1/s", "rate at which offsets are followed and taken out"),
            Field("state_limit", "-", "greatest dimensionless state"),
            Field("move_limit", "-", f"greatest move of ln {model.target} in one sample"),
        ),
        state=(
            *states,
            Field("damping", "-", "M2"),
            Field("stiffness", "-", "K1"),
            Field("pair_output", "-", "K2"),
            Field("scale_before", model.layout.signals[0].unit, "scale of the sample before"),
            Field("A", f"({o.unit})^2", "sum of squared sensitivity"),
            Field("error_offset", o.unit, "slow part of the error"),
            Field("slope_offset", o.unit, "slow part of the sensitivity"),
        ),
        variables=(Field("anew", "-", "1 where the model starts anew"),),
        start={
            "A": S("noise_variance") / S("start_variance"),
            "damping": model.damping,
            "stiffness": model.stiffness,
            "pair_output": model.pair_output,
            "scale_before": S(f"{model.speed}_least"),
        },
        middle=_middle(model),
        provenance=("one implicit step a sample: similitude.sampling",),
    )


def _middle(model: SecondOrder) -> list[Statement]:
    layout, groups = model.layout, model.reduction.groups
    learn = sp.And(S("live") > HALF, S("fresh") > S("settle_samples"), S("excited") > HALF)
    output = layout.inverted(groups.scale[layout.output.name])
    e, s, follow = S("error"), S("slope"), S("follow")
    return [
        *_model_step(model),
        Assign("output_scale", output),
        Assign("inv_output_scale", layout.inverted(1 / groups.scale[layout.output.name])),
        Assign("follow", sp.Min(1, S("dt") * S("offset_rate")) * S("usable")),
        Assign("slope", S(f"{layout.output.name}_star_slope") * S("output_scale")),
        Assign("error", S("y_now") - S(f"{layout.output.name}_star") * S("output_scale")),
        Assign("error_offset", S("error_offset") + follow * (e - S("error_offset"))),
        Assign("slope_offset", S("slope_offset") + follow * (s - S("slope_offset"))),
        Assign("psi", s - S("slope_offset"), "sensitivity without its slow part"),
        Assign("residual", e - S("error_offset"), "error without its slow part"),
        Assign("innovation", sp.Piecewise((S("residual"), S("usable") > HALF), (0, True))),
        Assign("predicted", S("y_now") - e + S("error_offset"), "the model and its offset"),
        *ls.excite(S("psi")),
        Assign("keep", 1 - sp.Min(HALF, S("dt") * S("forgetting_rate"))),
        When(learn, tuple(_learn(model)), (), "the input excites the unknown"),
        ls.age(learn, S("keep")),
        *_observe(model),
    ]


def _model_step(model: SecondOrder) -> list[Statement]:
    """Carry the state into the scale of now and step the model and its sensitivity."""
    layout, reduction = model.layout, model.reduction
    groups, K = reduction.groups, S(model.target)
    start = sp.Or(S("live") < HALF, S("dt") > S("dt_high"), S("anew") > HALF)
    old = {layout.signals[0].symbol: S("scale_before")}
    fast = [S(name) for name in layout.fast]
    lines: list[Statement] = [Assign("anew", sp.Integer(0))]
    beyond = [sp.Or(x > S("state_limit"), x < -S("state_limit")) for x in fast]
    lines.append(When(sp.Or(*beyond), (Assign("anew", sp.Integer(1)), set_status("restarted"))))
    rest = (*layout.fast, *(f"{n}_slope" for n in layout.fast), "error_offset", "slope_offset")
    fresh = (*(Assign(n, sp.Integer(0)) for n in rest), Assign("fresh", sp.Integer(0)))
    lines.append(When(start, fresh, (), "nothing is known of the state"))
    for x, q in zip(fast, groups.model.states, strict=True):
        unit = groups.scale[q.name]
        ratio = layout.inverted(unit.xreplace(old) / unit)
        lines.append(Assign(f"ratio_{x.name}", ratio, "same physical state in the new scale"))
        lines += [Assign(n, S(n) * S(f"ratio_{x.name}")) for n in (x.name, f"{x.name}_slope")]
    into = layout.inverted(1 / groups.scale[layout.input.name])
    lines.append(Assign("u", (S("last_input") + S("u_now")) / 2 * into, "mean of the sample's two ends"))
    lines.append(Assign("u_change", (S("u_now") - S("last_input")) * into))
    span = sp.Piecewise((S("dt"), S("dt") < S("dt_high")), (0, True))
    lines.append(Assign("h", span * layout.inverted(1 / groups.time_scale), "dimensionless time step"))
    step = _implicit(model, fast)
    lines += step.statements
    slopes = sp.Matrix([S(f"{x.name}_slope") for x in fast])
    moved = step.by_state * slopes + step.by_parameter[K.name]
    lines += [Assign(f"after_{x.name}", step.after[i]) for i, x in enumerate(fast)]
    lines += [Assign(f"after_{x.name}_slope", moved[i]) for i, x in enumerate(fast)]
    return lines + [Assign(n, S(f"after_{n}")) for x in fast for n in (x.name, f"{x.name}_slope")]


def _implicit(model: SecondOrder, fast: list[sp.Symbol]) -> ImplicitStep:
    layout, reduction = model.layout, model.reduction
    states = reduction.groups.model.states
    replace = {q.symbol: x for q, x in zip(states, fast, strict=True)} | {layout.input.symbol: S("u")}
    rates = [layout.inverted(reduction.rates[q.name].xreplace(replace)) for q in states]
    chain = {model.target: reduction.unknowns[0].jacobian, "u": sp.Integer(1)}
    return implicit_step(rates, fast, parameters=chain, ramp=("u", S("u_change")))


def _learn(model: SecondOrder) -> list[Statement]:
    """Move the logarithm along the sensitivity; exp to third order keeps the unknown positive."""
    K, A, psi, move = S(model.target), S("A"), S("psi"), S("move")
    exp = 1 + move * (1 + move * (HALF + move / 6))
    return [
        Assign("A", S("keep") * A + psi**2),
        Assign("wanted", psi * S("residual") / A),
        Assign("move", sp.Max(-S("move_limit"), sp.Min(S("move_limit"), S("wanted")))),
        Assign(K.name, K * exp),
        *ls.keep_within(K.name),
        Assign("unknowns", sp.Integer(1)),
        *ls.score(psi, S("residual")),
        *ls.scatter(psi, A, sp.Integer(1)),
        *learnt_status(model),
    ]


def _observe(model: SecondOrder) -> list[Statement]:
    """Pull the model towards the measurement, harder where the car is unstable.

    An unstable car has a negative stiffness c of y'' + d y' + c y; a pull g makes it c + g d_other, with
    d_other, the other state's own decay, about half of d. The pull is twice what brings c up to
    a margin, so that it is there before the model, whose K is still on its way, is as unstable as the car.
    """
    layout, K = model.layout, S(model.target)
    name, into = f"{layout.output.name}_star", S("inv_output_scale")
    pull = S("observer_rate") + 4 * sp.Max(0, S("observer_margin") - S("held")) / S("damped")
    return [
        Assign("damped", K * S("damping") * layout.inverted(model.per_rate)),
        Assign(
            "held",
            K * S("stiffness") * layout.inverted(model.per_output)
            + K**2 * S("pair_output") * layout.inverted(model.per_pair_output),
            "y'' = -held y",
        ),
        Assign("pull", sp.Min(1, S("dt") * pull) * S("usable") * into),
        Assign(name, S(name) + S("pull") * S("residual")),
        Assign(f"{name}_slope", S(f"{name}_slope") - S("pull") * S("psi")),
        Assign("scale_before", S(f"last_{model.speed}")),
    ]
