"""Recursive regression of one unknown of a linear model of any order, where its sampled form is linear in it.

    A(z) y = B(z) u,   A = A0 + d A1,  B = B0 + d B1,   d = unknown/median - 1
    e = y - y0         y0 = (B0/A0) u, the median's output
    e = phi d + b      phi = (B1 u - A1 y)/A0 = zeta - (A1/A0) e,    b the sensor's bias
    zeta               slope of y0 by d, from the input alone: the instrument

With zeta as the instrument the sensor's noise in phi is no bias (the paper's regression has that bias), and
1/A0 before everything leaves the noise white near the median. Unknown are d and b, hence two by two:

    R <- f R + [zeta; 1] [phi, 1]/noise,   q <- f q + [zeta; 1] e/noise,   [d; b] = R^-1 q

Invariant: whatever the sample holds, every state stays finite; the variance is never below what frozen
unknowns leave open.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction
from similitude.status import STATUS

HALF = sp.Rational(1, 2)
SUMS = ("R11", "R12", "R21", "R22", "q1", "q2")


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def sampled_regression(reduction: Reduction) -> Program:
    """Derive the step program of the instrumental regression.

    Parameters
    ----------
    reduction : Reduction    of a linear model without signals; its first unknown is identified, the others
                             are frozen in the numbers of the configuration.

    Returns
    -------
    Program    ``<model>_regression``; sample and output begin as those of the population filter.
    """
    layout, model = ff.Layout(reduction), reduction.groups.model
    n = len(model.states)
    config, state = _config(layout, n), _state(layout, n)
    arrays = {f.name: f.symbols for f in (*config, *state)}
    return Program(
        name=f"{model.name}_regression",
        title=f"Regression for the {model.name}",
        provenance=(
            f"model: {model.name}, {model.source}",
            f"unknown: {layout.target}; frozen: {', '.join(layout.unknowns[1:]) or 'none'}",
        ),
        config=config,
        state=state,
        sample=ff.sample_fields(layout),
        output=ff.output_fields(layout),
        variables=(
            Field("status", "-", "status code"),
            Field("u_now", layout.input.unit, "input used now"),
            Field("usable", "-", "1 where the measurement can be used"),
        ),
        init=tuple(_init(state)),
        step=tuple(_step(layout, arrays, n)),
        status=STATUS,
    )


def _config(layout: ff.Layout, n: int) -> tuple[Field, ...]:
    i, o, t = layout.input, layout.output, layout.reduction.unknowns[0]
    return (
        Field("sample_time", "s", "time between samples that the numbers below are for"),
        Field("F", "-", "transition of the states over a sample, by rows", n * n),
        Field("G_then", "-", "weight of the input at the sample before", n),
        Field("G_now", "-", "weight of the input now", n),
        Field("C", "-", "output by state", n),
        Field("D", "-", "output by input"),
        Field("F_slope", "-", "slope of F by d", n * n),
        Field("G_then_slope", "-", "slope of G_then", n),
        Field("G_now_slope", "-", "slope of G_now", n),
        Field("C_slope", "-", "slope of C", n),
        Field("D_slope", "-", "slope of D"),
        Field("A_into", "-", "A1/A0 as a filter with transition F: what the residual adds", n),
        Field("A_out", "-", "the same: what is read off", n),
        Field(f"{t.name}_prior", t.unit, f"median of {t.meaning}"),
        Field("prior_information", "-", "1/variance of d beforehand"),
        Field("bias_information", f"1/({o.unit})^2", f"1/variance of the bias of {o.name} beforehand"),
        Field("frozen_variance", "-", "variance of d that frozen unknowns leave open"),
        Field("bend", "-", "how far coefficients leave their straight line, as a share of d"),
        Field("d_low", "-", "least d the population allows"),
        Field("d_high", "-", "greatest d the population allows"),
        Field("noise_variance", f"({o.unit})^2", f"white noise of {o.name} a sample"),
        Field("forgetting", "-", "share of the past kept at each sample"),
        Field("settle", "-", "samples after a gap before learning"),
        Field("input_limit", i.unit, f"greatest believable {i.name}"),
        Field("output_limit", o.unit, f"greatest believable {o.name}"),
    )


def _state(layout: ff.Layout, n: int) -> tuple[Field, ...]:
    i, o = layout.input, layout.output
    return (
        Field("x", "-", "states of the median system", n),
        Field("s", "-", "their slopes by d", n),
        Field("w", "-", "memory of A1/A0", n),
        *(Field(name, "-", "sum of the regression") for name in SUMS),
        Field("d", "-", "unknown over its median, less one"),
        Field("bias", o.unit, f"bias of {o.name}"),
        Field("excess", "-", "mean square of the residual over the noise, one at first"),
        Field("count", "-", "samples it was averaged over"),
        Field("fresh", "-", "samples since the last gap"),
        Field("information", "-", "information gained"),
        Field("last_input", i.unit, "input of the sample before"),
        Field("started", "-", "1 once a sample was seen"),
    )


def _init(state: Sequence[Field]) -> list[Statement]:
    start = {
        "R11": S("prior_information"),
        "R22": S("bias_information"),
        "excess": sp.Integer(1),
        "fresh": S("settle"),
    }
    names = [s.name for f in state for s in f.symbols]
    return [Assign(name, start.get(name, sp.Integer(0))) for name in names]


def _step(layout: ff.Layout, a: dict[str, tuple[sp.Symbol, ...]], n: int) -> list[Statement]:
    dt, T = S("dt"), S("sample_time")
    in_time = sp.And(dt > T / 2, dt < 3 * T / 2)
    unknown, prior = layout.target, S(f"{layout.target}_prior")
    wide = S("determinant") > 0
    clear = [Assign(s.name, sp.Integer(0)) for name in "xsw" for s in a[name]]
    late = (
        *clear,
        Assign("fresh", sp.Integer(0)),
        Assign("started", sp.Integer(0)),
        Assign("status", sp.Integer(STATUS["restarted"])),
    )
    return [
        Assign("status", sp.Integer(STATUS["ok"])),
        Assign("predicted", S("bias")),
        Assign("innovation", sp.Integer(0)),
        When(
            dt > 0,
            (When(in_time, tuple(_sample(a, n)), late, "a step of another length starts anew"),),
            (Assign("status", sp.Integer(STATUS["bad_sample"])),),
            "time must advance",
        ),
        Assign("estimate", prior * (1 + S("d")), unknown),
        Assign("innovation_variance", S("noise_variance") * S("excess")),
        Assign("determinant", S("R11") * S("R22") - S("R12") * S("R21")),
        Assign(
            "spread", sp.Piecewise((S("R22") / S("determinant"), wide), (1 / S("prior_information"), True))
        ),
        Assign("own", sp.Min(S("spread") * S("excess"), 1 / S("prior_information"))),
        Assign("size", 1 + S("d")),
        Assign("bent", S("bend") * S("d"), "what the straight line leaves out"),
        Assign(
            "variance",
            (S("own") + S("frozen_variance") + S("bent") * S("bent")) / (S("size") * S("size")),
            f"of ln {unknown}",
        ),
        Assign("information_gained", S("information")),
    ]


def _dot(row: Sequence[sp.Symbol], column: Sequence[sp.Symbol]) -> sp.Expr:
    return sp.Add(*(r * c for r, c in zip(row, column, strict=True)))


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.And(x > -S(limit), x < S(limit))


def _sample(a: dict[str, tuple[sp.Symbol, ...]], n: int) -> list[Statement]:
    u, before = S("u_now"), S("last_input")
    rows = [a["F"][i * n : i * n + n] for i in range(n)]
    slopes = [a["F_slope"][i * n : i * n + n] for i in range(n)]
    none = (Assign("usable", sp.Integer(0)), Assign("status", sp.Integer(STATUS["no_measurement"])))
    held = (Assign("u_now", before), *none)
    moved = [
        *(Assign(f"s_new{i}", _dot(rows[i], a["s"]) + _dot(slopes[i], a["x"])
                 + a["G_then_slope"][i] * before + a["G_now_slope"][i] * u) for i in range(n)),
        *(Assign(f"x_new{i}", _dot(rows[i], a["x"]) + a["G_then"][i] * before + a["G_now"][i] * u)
          for i in range(n)),
    ]  # fmt: skip
    moved += [Assign(a[k][i].name, S(f"{k}_new{i}")) for k in "sx" for i in range(n)]
    return [
        Assign("usable", sp.Integer(1)),
        When(_within(S("input"), "input_limit"), (Assign("u_now", S("input")),), held, "held"),
        When(sp.Not(_within(S("measured"), "output_limit")), none, (), "no measurement"),
        Assign("fresh", sp.Min(S("fresh") + 1, S("settle") + 1)),
        When(S("started") > HALF, tuple(moved), (Assign("started", sp.Integer(1)),), "the median's states"),
        Assign("last_input", u),
        Assign("median_output", _dot(a["C"], a["x"]) + S("D") * u),
        Assign("zeta", _dot(a["C"], a["s"]) + _dot(a["C_slope"], a["x"]) + S("D_slope") * u, "instrument"),
        Assign("carried", _dot(a["A_out"], a["w"])),
        Assign("phi", S("zeta") - S("carried"), "regressor"),
        Assign("predicted", S("median_output") + S("phi") * S("d") + S("bias")),
        Assign("e", sp.Piecewise((S("measured") - S("median_output"), S("usable") > HALF),
                                 (S("predicted") - S("median_output"), True))),
        *(Assign(f"w_new{i}", _dot(rows[i], a["w"]) + a["A_into"][i] * S("e")) for i in range(n)),
        *(Assign(a["w"][i].name, S(f"w_new{i}")) for i in range(n)),
        When(sp.And(S("usable") > HALF, S("fresh") > S("settle")), tuple(_learn()), (), "usable and settled"),
    ]  # fmt: skip


def _learn() -> list[Statement]:
    f, zeta, phi, e = S("forgetting"), S("zeta"), S("phi"), S("e")
    inverse = S("inv_noise")
    added = {"R11": zeta * phi, "R12": zeta, "R21": phi, "R22": sp.Integer(1), "q1": zeta * e, "q2": e}
    residual = S("innovation") ** 2 / S("noise_variance")
    solved = (
        Assign("d", (S("q1") * S("R22") - S("q2") * S("R12")) / S("settled_det")),
        Assign("bias", (S("R11") * S("q2") - S("R21") * S("q1")) / S("settled_det")),
    )
    beyond = sp.Or(S("d") < S("d_low"), S("d") > S("d_high"))
    limit = (
        Assign("d", sp.Min(sp.Max(S("d"), S("d_low")), S("d_high"))),
        Assign("status", sp.Integer(STATUS["at_limit"])),
    )
    return [
        Assign("innovation", S("measured") - S("predicted")),
        Assign("inv_noise", 1 / S("noise_variance")),
        *(Assign(name, f * S(name) + inverse * more) for name, more in added.items()),
        Assign("information", f * S("information") + inverse * zeta * phi),
        Assign("count", sp.Min(S("count") + 1, 2000)),
        Assign(
            "excess", sp.Max(S("excess") + (sp.Min(residual, 16) - S("excess")) / (S("count") + 100), HALF)
        ),
        Assign("settled_det", S("R11") * S("R22") - S("R12") * S("R21")),
        When(S("settled_det") > 0, solved, (), "what is known of d and the bias together"),
        When(beyond, limit, (), "no system is so far off"),
        When(
            S("R11") < 4 * S("prior_information"),
            (Assign("status", sp.Integer(STATUS["not_excited"])),),
        ),
    ]
