"""The frame of the ladder's step programs: gates before, status and outputs after, the same for all.

Invariant: ``innovation`` is what is left unexplained behind the estimator's own filters, zero without a
usable sample; with one, ``predicted`` is the measurement less that rest.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.estimators import ladder_fields as lf
from similitude.estimators.held_sample import HALF, S, at_now, gate_variables, gates, remember, set_status
from similitude.estimators.least_squares import scatter_variables, started_at
from similitude.estimators.second_order import SecondOrder
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.status import STATUS


def ladder_program(
    model: SecondOrder,
    *,
    name: str,
    title: str,
    config: tuple[Field, ...],
    state: tuple[Field, ...],
    variables: tuple[Field, ...],
    start: dict[str, sp.Expr],
    middle: list[Statement],
    provenance: tuple[str, ...],
) -> Program:
    """Compose a step program around what is the estimator's own.

    Parameters
    ----------
    model : SecondOrder    coefficients of the reduced model.
    name, title : ``<model>_<name>``, and its first words in the C file.
    config, state, variables : the estimator's own fields.
    start : values of the state before the first sample that are not zero.
    middle : statements between the gates and the memory of the sample; they see ``usable``, ``live``,
        ``fresh``, ``u_now``, ``y_now``, and assign ``predicted``, ``innovation``, ``unknowns``, ``status``.
    provenance : lines for the head of the C file.
    """
    layout, groups = model.layout, model.reduction.groups
    fields = lf.state_fields(model, state)
    start = {
        model.target: S(f"{model.target}_start"),
        "log_variance": S("variance_limit"),
        "blocks": sp.Integer(-1),
        f"last_{model.speed}": S(f"{model.speed}_least"),
        **start,
    }
    return Program(
        name=f"{groups.model.name}_{name}",
        title=f"{title} of the {groups.model.name}",
        provenance=(
            f"model: {groups.model.name}, {groups.model.source}",
            f"base: {', '.join(groups.base)}",
            f"unknown: {model.target}; frozen: {', '.join(model.frozen)}",
            *provenance,
        ),
        config=lf.config_fields(model, config),
        state=fields,
        sample=ff.sample_fields(layout),
        output=lf.output_fields(model),
        variables=(*gate_variables(model), *scatter_variables(), *variables),
        init=tuple(started_at(start, fields)),
        step=tuple(_step(model, middle)),
        status=STATUS,
    )


def scales_now(model: SecondOrder) -> list[Assign]:
    """Scales as they are used now, with their reciprocals taken once."""
    layout = model.layout
    lines = [Assign(layout.at(q.name).name, at_now(model, q.symbol)) for q in layout.signals]
    names = [q.name for q in (*layout.signals, *layout.scales)]
    return [*lines, *(Assign(layout.inverse(n).name, 1 / layout.at(n)) for n in names)]


def _step(model: SecondOrder, middle: list[Statement]) -> list[Statement]:
    dt = S("dt")
    another = (Assign(f"last_{model.speed}", S("scale_now")),)
    return [
        Assign("predicted", S("last_measured")),
        *(Assign(name, sp.Integer(0)) for name in ("innovation", "unknowns")),
        When(
            sp.And(dt > 0, dt < 1e6),
            (
                *gates(model, another),
                *scales_now(model),
                *middle,
                _seen(),
                *remember(),
            ),
            (set_status("bad_sample"),),
            "time must advance",
        ),
        Assign("innovation_variance", sp.Max(S("mean_square"), S("scatter_low"))),
        *lf.hand_out(model),
    ]


def _seen() -> When:
    """Follow the size of the innovations."""
    change = sp.Min(1, S("dt") * S("excitation_rate")) * (S("innovation") ** 2 - S("mean_square"))
    return When(S("usable") > HALF, (Assign("mean_square", S("mean_square") + change),))
