"""First-order regression in a band: the paper's regression with its common factor cancelled.

Eq 23 of the paper has the factor (1 - 1/z) above and below. Without it there is no second difference to
raise the noise:

    y = r(q) - r(q-1),    psi = T [B1 s1 u(q-1) - M2 s2 r(q-1)],    y = K psi + e

The form leaves out what the car does slowly (K1, K2 of ``second_order``), so a high-pass must take the
slow part away, and a low-pass the noise above: a fourth-order Bessel filter each, two sections each.

    K   = Q/A     Q = sum of psi y - n_y,   A = sum of psi^2 - n_A,   both with forgetting

n_y, n_A are the sensor noise's own part of the sums (psi and y hold the same noisy output), known from
the filter; without taking them out K reads low.

Invariant: whatever the sample holds, every state stays finite and the next usable samples count.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import least_squares as ls
from similitude.estimators.biquad_section import biquad_fields, cascade
from similitude.estimators.held_sample import HALF, S
from similitude.estimators.ladder_fields import learnt_status
from similitude.estimators.ladder_program import ladder_program
from similitude.estimators.second_order import SecondOrder, second_order
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction

SECTIONS = 4  # two of the high-pass, two of the low-pass


def band_regression(reduction: Reduction, *, unknown: str = "pi3") -> Program:
    """Derive the step program of the band-limited first-order regression from a reduced model.

    Parameters
    ----------
    reduction : Reduction    as `second_order` takes it.
    unknown : the group that carries the unknown.

    Returns
    -------
    Program    ``<model>_band``; sample and output begin as those of the population filter.

    Raises
    ------
    ModelError    the model is not one the regression holds for.

    References
    ----------
    Brennan & Alleyne 2004, eq 23, with its common factor cancelled.
    """
    model = second_order(reduction, unknown=unknown)
    i, o = model.layout.input, model.layout.output
    halves = ("high-pass", "high-pass", "low-pass", "low-pass")
    return ladder_program(
        model,
        name="band",
        title="First-order regression in a band",
        config=(
            Field("sample_time", "s", "sample time the filters are designed for"),
            *biquad_fields(halves),
            Field("forgetting", "-", "share of the past kept at each update"),
            Field("noise_variance", f"({o.unit})^2", f"variance of {o.name} a sample that is taken out"),
            Field("noise_zero", "-", "autocorrelation of the band-pass at lag 0"),
            Field("noise_one", "-", "the same at lag 1"),
            Field("signal_least", "-", "least share of A that is signal"),
        ),
        state=(
            Field("input_gain", "s", "B1 times the sample time"),
            Field("damping", "s", "M2 times the sample time"),
            Field("Q", f"({o.unit})^2", "sum of regressor times change"),
            Field("A", f"({o.unit})^2", "sum of squared regressor"),
            Field("input_memory", i.unit, f"memory of the sections for {i.name}", 2 * SECTIONS),
            Field("output_memory", o.unit, f"memory of the sections for {o.name}", 2 * SECTIONS),
            Field("input_before", i.unit, f"filtered {i.name} of the sample before"),
            Field("output_before", o.unit, f"filtered {o.name} of the sample before"),
        ),
        variables=(),
        start={
            "input_gain": S("sample_time") * model.input_gain,
            "damping": S("sample_time") * model.damping,
        },
        middle=_middle(model),
        provenance=(f"B1 = {sp.sstr(model.input_gain)}", f"M2 = {sp.sstr(model.damping)}"),
    )


def _middle(model: SecondOrder) -> list[Statement]:
    inverted = model.layout.inverted
    K = S(model.target)
    learn = sp.And(S("live") > HALF, S("fresh") > S("settle_samples"), S("excited") > HALF)
    return [
        *cascade(S("u_now"), SECTIONS, "input", "input_filtered"),
        *cascade(S("y_now"), SECTIONS, "output", "output_filtered"),
        Assign("from_input", S("input_gain") * inverted(model.per_input_rate), "psi per input"),
        Assign("from_output", S("damping") * inverted(model.per_rate), "-psi per output"),
        Assign("driven", S("from_input") * S("input_before")),
        Assign("psi", S("driven") - S("from_output") * S("output_before")),
        Assign("y", S("output_filtered") - S("output_before")),
        Assign("residual", S("y") - K * S("psi")),
        Assign("innovation", sp.Piecewise((S("residual"), S("usable") > HALF), (0, True))),
        Assign("predicted", S("y_now") - S("innovation")),
        *ls.excite(K * S("driven")),
        When(learn, tuple(_learn(model)), (), "the band is excited, the filters settled"),
        ls.age(learn, S("forgetting")),
        Assign("input_before", S("input_filtered")),
        Assign("output_before", S("output_filtered")),
    ]


def _learn(model: SecondOrder) -> list[Statement]:
    """Two sums with forgetting, and their ratio where enough of A is signal."""
    K, A, Q, noise = S(model.target), S("A"), S("Q"), S("noise_variance")
    own = S("from_output") ** 2 * S("noise_zero") * noise
    with_y = S("from_output") * (S("noise_zero") - S("noise_one")) * noise
    solve = (
        Assign(K.name, Q / A),
        *ls.keep_within(K.name),
        Assign("unknowns", sp.Integer(1)),
        *ls.score(S("psi"), S("residual")),
        *ls.scatter(S("psi"), A, K**2),
        *learnt_status(model),
    )
    return [
        Assign("Q", S("forgetting") * Q + (S("psi") * S("y") - with_y)),
        Assign("A", S("forgetting") * A + (S("psi") ** 2 - own)),
        Assign("noise_sum", own / (1 - S("forgetting")), "what noise alone would sum to"),
        When(A > S("signal_least") * S("noise_sum"), solve, (), "more than noise"),
    ]
