"""The statements of the paper's regression: filters, prediction, recursive least squares.

Invariant: the history the regressor is read from moves on once a sample, after its last use.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.biquad_section import section
from similitude.estimators.held_sample import HALF, S, at_now, set_status
from similitude.estimators.paper_fields import state_fields
from similitude.estimators.paper_gates import at_scale_of_now, gates
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When

R0, R1, R2 = S("output_filtered"), S("output_before_0"), S("output_before_1")
D1, D2 = S("input_before_0"), S("input_before_1")


def before_first(r: Regression) -> list[Statement]:
    """The statements of ``init``: all that follows from the configuration, the rest at rest."""
    direct = S("biquad_1_0") * S("biquad_2_0")
    start = {
        "m1_rate": r.numerator,
        "m2_rate": r.denominator,
        "theta": S(f"{r.unknown}_start"),
        "P": S("P_start"),
        "inv_direct": 1 / direct,
        "inv_forgetting": 1 / S("forgetting"),
        "least_spread": S("noise_variance") * direct**2,
        f"last_{r.speed}": S(f"{r.speed}_least"),
    }
    names = [s.name for f in state_fields(r) for s in f.symbols]
    at_scale = {line.target for line in at_scale_of_now(r)}
    plain = [Assign(name, sp.sympify(start.get(name, 0))) for name in names if name not in at_scale]
    return [*plain, *at_scale_of_now(r)]


def one_sample(r: Regression) -> list[Statement]:
    """The statements of ``step``."""
    dt = S("dt")
    return [
        Assign("predicted", S("last_measured")),
        Assign("innovation", sp.Integer(0)),
        When(
            sp.And(dt > 0, dt < 1e6),
            (*gates(r), *_predict(), *_filter(), *_learn(r), *_remember()),
            (set_status("bad_sample"),),
            "time must advance",
        ),
        *_outputs(r),
    ]


def _predict() -> list[Statement]:
    """The regressor and, from the past alone, the raw output whose filtered value it predicts."""
    phi = S("m2") * (R2 - R1) + S("m1") * (D1 - D2)
    filtered = 2 * R1 - R2 + S("phi") * S("theta") * S("unit")
    rest = S("biquad_2_0") * S("output_memory_0") + S("output_memory_2")
    return [
        Assign("phi", phi, "regressor, eqs 25-26"),
        Assign("filtered", filtered, "filtered output predicted"),
        Assign("rest", rest, "filtered output if the newest were zero"),
        Assign("predicted", (S("filtered") - S("rest")) * S("inv_direct")),
        When(S("usable") > HALF, (Assign("innovation", S("y_now") - S("predicted")),)),
    ]


def _filter() -> list[Statement]:
    return [
        *section(S("u_now"), 1, "input", "input_half"),
        *section(S("input_half"), 2, "input", "input_filtered"),
        *section(S("y_now"), 1, "output", "output_half"),
        *section(S("output_half"), 2, "output", "output_filtered"),
    ]


def _learn(r: Regression) -> list[Statement]:
    """Recursive least squares with forgetting where the raw output exceeds the dead zone."""
    phi, theta, P, forgetting = (S(n) for n in ("phi", "theta", "P", "forgetting"))
    y_now, dead, limit = S("y_now"), S("dead_zone"), S(f"{r.unknown}_limit")
    beyond = sp.Or(y_now > dead, y_now < -dead)
    used = sp.And(S("live") > HALF, S("fresh") > S("settle_samples"), beyond)
    least = S("least_spread") * S("star") ** 2
    step = (S("residual") ** 2 - S("mean_square")) / S("weight")
    body = (
        Assign("residual", S("y") - phi * theta),
        Assign("gain", P * phi / (forgetting + phi * P * phi)),
        Assign("weight", forgetting * S("weight") + 1),
        Assign("mean_square", S("mean_square") + step),
        Assign("spread", sp.Max(S("mean_square"), least), "never below the sensor's share"),
        Assign("information", S("information") + (phi * theta) ** 2 / S("spread")),
        Assign("theta", theta + S("gain") * S("residual")),
        Assign("theta", sp.Min(theta, limit)),
        Assign("theta", sp.Max(theta, -limit)),
        Assign("P", (1 - S("gain") * phi) * P * S("inv_forgetting")),
        Assign("P", sp.Min(P, S("P_high"))),
        Assign("P", sp.Max(P, S("P_low"))),
        *_verdict(r),
    )
    return [
        Assign("y", S("star") * (R0 - 2 * R1 + R2), "second difference, eq 24"),
        When(used, body, (), "outside the dead zone, filters settled"),
    ]


def _verdict(r: Regression) -> list[Statement]:
    """Status of a sample that was used."""
    lines: list[Statement] = [set_status("ok")]
    validity = r.reduction.groups.model.validity
    if validity is not None:
        square = at_now(r, validity[0]).xreplace({r.layout.output.symbol: S("y_now")}) ** 2
        lines.append(When(square > S("validity_limit") ** 2, (set_status("outside_linear"),)))
    low = S("theta") <= S(f"{r.unknown}_low")
    return [*lines, When(low, (set_status("at_limit"),), (), "no stiffness is zero or less")]


def _remember() -> list[Statement]:
    return [
        Assign(R2.name, R1),
        Assign(R1.name, R0),
        Assign(D2.name, D1),
        Assign(D1.name, S("input_filtered")),
        Assign("last_input", S("u_now")),
        Assign("last_measured", S("y_now")),
    ]


def _outputs(r: Regression) -> list[Statement]:
    """The constant for the group; scatter of the residual as variance, without the noise's bias."""
    pi, limit = S(r.unknown), S("variance_limit")
    scatter = S("P") * S("innovation_variance") / (pi * S("raw")) ** 2
    return [
        Assign(r.unknown, sp.Max(S("theta"), S(f"{r.unknown}_low"))),
        Assign("estimate", pi / at_now(r, r.per_target)),
        Assign("raw", S("unit") * S("inv_direct"), "raw output per dimensionless residual"),
        Assign("innovation_variance", sp.Max(S("mean_square") * S("raw") ** 2, S("noise_variance"))),
        Assign("variance", limit),
        When(
            S("weight") > HALF, (Assign("scatter", scatter), Assign("variance", sp.Min(S("scatter"), limit)))
        ),
        Assign("information_gained", S("information")),
    ]
