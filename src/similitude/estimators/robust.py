"""State-variable filters and four unknowns: K from what a change of steer does at once.

Every signal passes the same high-pass, slow against steering, that takes the offsets of steer and gyro out,
and the same (corner/(s + corner))^4, whose stages give derivatives without differencing:

    y = r''_f = a1 psi1 + a2 psi2 + a3 psi3 + a4 psi4 + e
    psi1 = B1 s1 u'_f    psi2 = -M2 s2 r'_f    psi3 = -s3 r_f    psi4 = s4 (G2 u_f - K2 r_f)

with a1 = a2 = K, a3 = K K1, a4 = K^2 for the car the frozen unknowns describe. With four unknowns only a1
is read: a2 … a4 take up whatever rear axle, inertia and slow relation the car has, so K = a1 needs nothing
but B1. Where the drive does not carry four (a pivot of the normal equations is small), the car itself is
fitted, one unknown on the curve a(K); where it carries none, K is held.

The sums have forgetting, and the sensor noise's own share is taken out of them.

Invariant: nothing is divided by a pivot that noise alone could have made.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import least_squares as ls
from similitude.estimators.held_sample import HALF, S
from similitude.estimators.ladder_program import ladder_program
from similitude.estimators.robust_solve import STAGES, car_of, learn, normal_matrix
from similitude.estimators.second_order import SecondOrder, second_order
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction

MOMENTS = ("value", "rate", "change", "value_rate", "value_change", "rate_change")


def robust_regression(reduction: Reduction, *, unknown: str = "pi3") -> Program:
    """Derive the step program of the state-variable-filter regression from a reduced model.

    Parameters
    ----------
    reduction : Reduction    as `second_order` takes it.
    unknown : the group that carries the unknown.

    Returns
    -------
    Program    ``<model>_robust``; sample and output begin as those of the population filter.

    Raises
    ------
    ModelError    the model is not one the regression holds for.

    References
    ----------
    P. C. Young, Recursive Estimation and Time-Series Analysis (1984), chapter 6, for the filters.
    """
    model = second_order(reduction, unknown=unknown)
    i, o = model.layout.input, model.layout.output
    signal = model.layout.signals[0]
    return ladder_program(
        model,
        name="robust",
        title="Four-unknown regression behind state-variable filters",
        config=(
            Field("sample_time", "s", "sample time the filters are designed for"),
            Field("corner", "1/s", "corner of the four stages"),
            Field("offset_rate", "1/s", "rate at which offsets are followed and taken out"),
            Field("forgetting", "-", "share of the past kept at each update"),
            Field("noise_variance", f"({o.unit})^2", f"variance of {o.name} a sample that is taken out"),
            *(Field(f"noise_{m}", "-", f"moment of filtered unit noise: {m}") for m in MOMENTS),
            Field("signal_least", "-", "least pivot of four against the noise taken out of it"),
            Field("signal_least_one", "-", "the same of one unknown"),
            Field("pivot_least", "-", "least share of a regressor that the others must not explain"),
            Field("move_limit", "-", f"greatest move of ln {model.target} in one sample with one unknown"),
        ),
        state=(
            *(Field(n, "-", text) for n, text, _ in _gains(model)),
            Field("stage_keep", "-", "weight of a stage's own past"),
            Field("stage_share", "-", "weight of each end of what comes in"),
            Field("input_offset", i.unit, f"slow part of {i.name}"),
            Field("output_offset", o.unit, f"slow part of {o.name}"),
            Field("input_stage", i.unit, f"{i.name} and its four stages", STAGES + 1),
            Field("output_stage", o.unit, f"{o.name} and its four stages", STAGES + 1),
            Field("scale_stage", signal.unit, f"{signal.meaning} as late as the stages are"),
            normal_matrix().field("-", "normal matrix, unknowns 2, 3, 4, 1, upper triangle by rows"),
            Field("q", "-", "right-hand side, unknowns 2, 3, 4, 1", STAGES),
            Field("yy", "-", "sum of squares of the left side"),
            Field("weight", "-", "samples the sums rest on"),
        ),
        variables=(
            Field("lowest", "-", "cost of the best place with one unknown"),
            Field("carried", "-", "unknowns carried"),
            Field("residual", "-", "what is left of y"),
        ),
        start={n: value for n, _, value in _gains(model)} | _stage_weights(model),
        middle=_middle(model),
        provenance=(
            f"B1 = {sp.sstr(model.input_gain)}",
            f"M2 = {sp.sstr(model.damping)}",
            f"K1 = {sp.sstr(model.stiffness)}",
            f"K2 = {sp.sstr(model.pair_output)}, G2 = {sp.sstr(model.pair_input)}",
        ),
    )


def _gains(model: SecondOrder) -> tuple[tuple[str, str, sp.Expr], ...]:
    return (
        ("input_gain", "B1", model.input_gain),
        ("damping", "M2", model.damping),
        ("stiffness", "K1", model.stiffness),
        ("pair_output", "K2", model.pair_output),
        ("pair_input", "G2", model.pair_input),
    )


def _stage_weights(model: SecondOrder) -> dict[str, sp.Expr]:
    turn = S("corner") * S("sample_time")
    return {
        "stage_keep": (2 - turn) / (2 + turn),
        "stage_share": turn / (2 + turn),
        "scale_stage": S(f"{model.speed}_least"),
    }


def _middle(model: SecondOrder) -> list[Statement]:
    teaches = sp.And(S("live") > HALF, S("fresh") > S("settle_samples"), S("excited") > HALF)
    K = S(model.target)
    together = sp.Add(*(g * S(f"psi_{i}") for i, g in zip((1, 2, 3, 4), car_of(model), strict=True)))
    return [
        Assign("slowly", sp.Min(1, S("dt") * S("offset_rate"))),
        Assign("input_offset", S("input_offset") + S("slowly") * (S("u_now") - S("input_offset"))),
        Assign("output_offset", S("output_offset") + S("slowly") * (S("y_now") - S("output_offset"))),
        Assign("input_0", S("u_now") - S("input_offset")),
        Assign("output_0", S("y_now") - S("output_offset")),
        *_stages("input", S("input_0")),
        *_stages("output", S("output_0")),
        *_late_scale(model),
        *_regressors(model),
        Assign("carried", sp.Integer(0)),
        *ls.excite(K * S("psi_1")),
        Assign("together", together, "of the car with this K"),
        Assign("residual", S("y") - S("together")),
        When(teaches, tuple(learn(model)), (), "the steer moves, the filters have settled"),
        Assign("innovation", sp.Piecewise((S("residual") / S("corner"), S("usable") > HALF), (0, True))),
        Assign("predicted", S("y_now") - S("innovation")),
        ls.age(teaches, S("forgetting")),
    ]


def _stages(signal: str, x: sp.Symbol) -> list[Statement]:
    """Four stages by the trapezoidal rule, whose derivatives are then exact differences of stages."""
    keep, share = S("stage_keep"), S("stage_share")
    lines: list[Statement] = []
    before = x
    for k in range(1, STAGES + 1):
        old, stage = S(f"{signal}_stage_{k - 1}"), S(f"{signal}_stage_{k}")
        name = f"{signal}_{k}"
        lines.append(Assign(name, keep * stage + share * (before + old)))
        lines.append(Assign(old.name, before))
        before = S(name)
    return [*lines, Assign(f"{signal}_stage_{STAGES}", before)]


def _late_scale(model: SecondOrder) -> list[Statement]:
    """The scale is taken as late as the stages make the signals: four times 1/corner."""
    share = S("sample_time") * S("corner") / STAGES
    now = S(f"last_{model.speed}")
    new = sp.Piecewise(
        (S("scale_stage") + share * (now - S("scale_stage")), S("fresh") > S("settle_samples")), (now, True)
    )
    return [
        Assign("scale_stage", new, "as late as the filtered signals"),
        Assign("late", 1 / S("scale_stage")),
    ]


def _regressors(model: SecondOrder) -> list[Statement]:
    layout, w = model.layout, S("corner")
    late = {layout.inverse(model.speed): S("late")}

    def at(e: sp.Expr) -> sp.Expr:
        return layout.inverted(e).xreplace(late)

    r4, r3, r2 = S("output_4"), S("output_3"), S("output_2")
    return [
        Assign("to_input", S("input_gain") * at(model.per_input_rate)),
        Assign("to_rate", S("damping") * at(model.per_rate)),
        Assign("to_output", at(model.per_output)),
        Assign("to_pair", S("pair_output") * at(model.per_pair_output)),
        Assign("psi_1", S("to_input") * (w * (S("input_3") - S("input_4")))),
        Assign("psi_2", -S("to_rate") * (w * (r3 - r4))),
        Assign("psi_3", -S("to_output") * r4),
        Assign("psi_4", S("pair_input") * at(model.per_pair_input) * S("input_4") - S("to_pair") * r4),
        Assign("y", w**2 * ((r2 - r3) - (r3 - r4)), "second derivative"),
    ]
