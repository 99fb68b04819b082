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

from collections.abc import Callable

import sympy as sp

from similitude.estimators import least_squares as ls
from similitude.estimators.elimination import eliminated
from similitude.estimators.held_sample import HALF, S
from similitude.estimators.ladder_fields import learnt_status
from similitude.estimators.ladder_program import ladder_program
from similitude.estimators.second_order import SecondOrder, second_order
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.program.symmetric import Symmetric
from similitude.reduction import Reduction

STAGES = 4
ORDER = (2, 3, 4, 1)  # of the regressors in the normal equations: what is asked for last
PLACES = tuple(sp.Rational(*p) for p in ((1, 2), (7, 10), (1, 1), (7, 5), (2, 1)))  # of where K started
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
            _A().field("-", "normal matrix, unknowns 2, 3, 4, 1, upper triangle by rows"),
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


def _A() -> Symmetric:
    return Symmetric("A", STAGES)


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
    learn = sp.And(S("live") > HALF, S("fresh") > S("settle_samples"), S("excited") > HALF)
    K = S(model.target)
    together = sp.Add(*(g * S(f"psi_{i}") for i, g in zip((1, 2, 3, 4), _car(model), strict=True)))
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
        When(learn, tuple(_learn(model)), (), "the steer moves, the filters have settled"),
        Assign("innovation", sp.Piecewise((S("residual") / S("corner"), S("usable") > HALF), (0, True))),
        Assign("predicted", S("y_now") - S("innovation")),
        ls.age(learn, S("forgetting")),
    ]


def _car(model: SecondOrder) -> tuple[sp.Expr, ...]:
    """a1 … a4 of the car that the frozen unknowns and K describe."""
    K = S(model.target)
    return K, K, K * S("stiffness"), K**2


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


def _noise(i: int, j: int) -> sp.Expr:
    """What noise of the output adds to the mean of psi_i psi_j, per variance."""
    to = {2: S("to_rate"), 3: S("to_output"), 4: S("to_pair")}
    rates = (i == 2) + (j == 2)
    moment = ("value", "value_rate", "rate")[rates]
    return to[i] * to[j] * S(f"noise_{moment}")


def _learn(model: SecondOrder) -> list[Statement]:
    """Sums with forgetting; four unknowns where the sums carry them, else one, else none."""
    A, keep, variance = _A(), S("forgetting"), S("noise_variance")
    lines: list[Statement] = [Assign("weight", keep * S("weight") + 1)]
    for a, i in enumerate(ORDER):
        for b, j in enumerate(ORDER[a:], start=a):
            own = S(f"psi_{i}") * S(f"psi_{j}")
            if 1 not in (i, j):
                own = own - variance * _noise(i, j)
            lines.append(Assign(A.target(a, b), keep * A[a, b] + own))
    for a, i in enumerate(ORDER):
        moment = "noise_rate_change" if i == 2 else "noise_value_change"
        own = {2: S("to_rate"), 3: S("to_output"), 4: S("to_pair")}.get(i, 0) * S(moment) * variance
        lines.append(Assign(f"q_{a}", keep * S(f"q_{a}") + (S(f"psi_{i}") * S("y") + own)))
    yy = S("y") ** 2 - variance * S("noise_change")
    lines.append(Assign("yy", keep * S("yy") + yy))
    lines.append(Assign("noise_sum", variance * S("weight"), "the noise's share of the sums"))
    return [*lines, *_four(model), When(S("carried") < HALF, tuple(_one(model)), (), "the steer says less")]


def _four(model: SecondOrder) -> list[Statement]:
    """The unknown of the steer's rate of change, whatever the other three are."""
    K, A = S(model.target), _A()
    least = [
        sp.Max(S("pivot_least") * A[a, a], S("signal_least") * S("noise_sum") * _noise(i, i) if i != 1 else 0)
        for a, i in enumerate(ORDER)
    ]
    residual = S("y") - sp.Add(*(S(f"part_{a}") for a in range(STAGES)))
    then = (
        Assign(K.name, S("z_3") * S("inv_d_3")),
        *ls.keep_within(K.name),
        Assign("carried", sp.Integer(4)),
        Assign("unknowns", sp.Integer(4)),
        Assign("residual", residual),
        *ls.score(S("w_3"), S("residual")),
        *ls.scatter(S("w_3"), S("d_3"), K**2),
        *learnt_status(model),
    )
    q = [S(f"q_{a}") for a in range(STAGES)]
    return list(eliminated(A, q, [S(f"psi_{i}") for i in ORDER], least, then))


def _one(model: SecondOrder) -> list[Statement]:
    """One Gauss-Newton step along a(K) = e K + f K^2 of the car that the frozen unknowns describe.

    The cost is a quartic of K and may have two valleys, one of them next to nothing: where K stands in a
    worse place than one of `PLACES`, it goes on from there.
    """
    K, start, A = S(model.target), S(f"{model.target}_start"), _A()
    e = [{1: 1, 2: 1, 3: S("stiffness"), 4: 0}[i] for i in ORDER]
    f = [int(i == 4) for i in ORDER]

    def form(x: list, y: list) -> sp.Expr:
        return sp.Add(*(A[a, b] * x[a] * y[b] for a in range(STAGES) for b in range(STAGES)))

    q = [S(f"q_{a}") for a in range(STAGES)]
    sums = {"c2": form(e, e), "c3": form(e, f), "c4": form(f, f)}
    sums |= {"d1": sp.Add(*map(sp.Mul, e, q)), "d2": sp.Add(*map(sp.Mul, f, q))}
    c2, c3, c4, d1, d2 = map(S, sums)

    def cost(x: sp.Symbol) -> sp.Expr:
        return S("yy") + x * (x * (c2 - 2 * d2 + x * (2 * c3 + x * c4)) - 2 * d1)

    slow = S("to_output") * S("stiffness") + 2 * K * S("to_pair")
    noise = S("to_rate") * (S("to_rate") * S("noise_rate") + 2 * S("slow") * S("noise_value_rate"))
    psi = S("psi_1") + S("psi_2") + S("stiffness") * S("psi_3") + 2 * K * S("psi_4")
    enough = S("signal_least_one") * S("noise_sum") * S("noise_along")
    return [
        *(Assign(name, value) for name, value in sums.items()),
        Assign("lowest", cost(K)),
        *[line for i, place in enumerate(PLACES) for line in _look(i, K, place * start, cost)],
        Assign("slow", slow),
        Assign("noise_along", noise + S("slow") ** 2 * S("noise_value")),
        Assign("psi", psi),
        Assign("normal", c2 + 4 * K * (c3 + K * c4)),
        Assign("wanted", d1 - K * (c2 - 2 * d2 + K * (3 * c3 + 2 * K * c4))),
        When(sp.And(S("normal") > 0, S("normal") > enough), tuple(_step_one(model)), (), "more than noise"),
    ]


def _look(i: int, K: sp.Symbol, place: sp.Expr, cost: Callable[[sp.Symbol], sp.Expr]) -> list[Statement]:
    """Go to a place where the cost is lower, as an error of the input: K near nothing explains nothing."""
    there, value = S(f"place_{i}"), S(f"cost_{i}")
    go = (Assign(K.name, there), Assign("lowest", value))
    return [
        Assign(there.name, place),
        Assign(value.name, cost(there)),
        When(value * K**2 < S("lowest") * there**2, go, (), "another valley" if i == 0 else ""),
    ]


def _step_one(model: SecondOrder) -> list[Statement]:
    K = S(model.target)
    limit = S("move_limit") * K
    move = sp.Max(-limit, sp.Min(limit, S("wanted") / S("normal")))
    return [
        Assign(K.name, K + move),
        *ls.keep_within(K.name),
        Assign("unknowns", sp.Integer(1)),
        *ls.score(S("psi"), S("residual")),
        *ls.scatter(S("psi"), S("normal"), K**2),
        *learnt_status(model),
    ]
