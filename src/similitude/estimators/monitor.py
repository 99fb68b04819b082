"""The change alarm of the first unknown, as a step program beside the population filter's.

The filter learns; the monitor remembers. It keeps the unknowns as they were (a reference that follows
the filter's estimate slowly), filters the same drive with them held, and asks of the innovations whether
they look like what the steer alone would have caused had the first unknown changed. Without steering
there is no such signature, and a straight road is silent by construction.

Invariant: whatever the sample holds, every state stays finite.
"""

from __future__ import annotations

import sympy as sp

from similitude.errors import ProgramError
from similitude.estimators import monitor_fields as mf
from similitude.estimators.filter_fields import Layout
from similitude.estimators.monitor_evidence import armed, begin_anew, dt, hears, judge, share, sizes, told
from similitude.estimators.monitor_track import KINDS, S, Tracks
from similitude.estimators.population_filter import LEAST_SHARE, LEAST_STEP, LONGEST_STEP
from similitude.program.ir import Assign, Field, Program, Statement, When
from similitude.reduction import Reduction
from similitude.status import STATUS

HALF = sp.Rational(1, 2)
LONGEST_SPAN = 1  # s: a filter starts anew after less


def monitor(reduction: Reduction) -> Program:
    """Derive the monitor's step program from a reduced model.

    Parameters
    ----------
    reduction : Reduction    one input, one output; the first unknown a logarithm.

    Returns
    -------
    Program    ``<model>_monitor``; its sample is that of the population filter with what it handed out.

    Raises
    ------
    ProgramError    the first unknown is not a logarithm: a change is a factor.

    References
    ----------
    docs/monitor.md for the test, its false alarms and its delays.
    """
    layout, model = Layout(reduction), reduction.groups.model
    first = reduction.unknowns[0]
    if first.kind != "log":
        raise ProgramError(
            f"the monitor of {model.name!r} cannot follow {first.name}: it is not a logarithm",
            usually="The unknown may be zero or negative; a change is told as a factor.",
            paste=f"Unknown({first.name!r}, {first.unit!r}, 'log', 'identify', ...)",
            read="docs/monitor.md",
        )
    return Program(
        name=f"{model.name}_monitor",
        title=f"Change alarm of the {model.name}",
        provenance=(
            f"model: {model.name}, {model.source}",
            f"base: {', '.join(reduction.groups.base)}",
            f"follows: {first.name}; held: {', '.join(layout.unknowns)}",
        ),
        config=mf.config_fields(layout),
        state=mf.state_fields(layout),
        sample=mf.sample_fields(layout),
        output=mf.output_fields(layout),
        variables=(
            Field("status", "-", "status code"),
            Field("u_now", layout.input.unit, "input used now"),
            *(Field(f"{q.name}_used", q.unit, "scale used now") for q in layout.signals),
            Field("usable", "-", "1 where the measurement can be used"),
            Field("anew", "-", "1 where the dynamic state starts anew"),
        ),
        init=tuple(_init(layout)),
        step=tuple(_step(layout, Tracks(layout))),
        status=STATUS,
    )


def _init(layout: Layout) -> list[Statement]:
    ones = {"distrust", *(f"rough_{x}" for x in mf.RESTS)}
    names = [s.name for f in mf.state_fields(layout) for s in f.symbols]
    return [Assign(name, sp.Integer(name in ones)) for name in names]


def _step(layout: Layout, tracks: Tracks) -> list[Statement]:
    ringing = ("alarm", "onset_age", "change", "change_variance")
    usable_time = sp.And(dt > LEAST_STEP, dt < LONGEST_STEP)
    bad = (Assign("status", sp.Integer(STATUS["bad_sample"])),)
    measured = When(S("usable") > HALF, tuple(judge(layout, tracks)), (), "measurement")
    work = (
        *_gates(layout),
        *_restart(layout, tracks),
        *_reference(layout),
        *sizes(layout),
        *_scales(layout),
        *tracks.advance(),
        *_validity(layout, tracks),
        measured,
        Assign("last_input", S("u_now")),
        *(Assign(f"last_{q.name}", S(f"{q.name}_used")) for q in layout.signals),
    )
    return [
        Assign("status", sp.Integer(STATUS["ok"])),
        *(Assign(name, sp.Integer(0)) for name in ringing),
        When(usable_time, work, bad, "time must advance"),
        Assign("reference", S(f"{layout.target}_held")),
        *(Assign(f"evidence_of_{k}", told(k)) for k in KINDS),
        Assign("armed", sp.Piecewise((1, sp.And(armed(), hears())), (0, True))),
        Assign("information_rate", S("hearing")),
    ]


def _within(x: sp.Symbol, limit: str) -> sp.Basic:
    return sp.And(x > -S(limit), x < S(limit))


def _is(*names: str) -> sp.Basic:
    """Whether the filter's status is one of these."""
    codes = [STATUS[name] for name in names]
    return sp.Or(*(sp.And(S("code") > c - HALF, S("code") < c + HALF) for c in codes))


def _gates(layout: Layout) -> list[Statement]:
    """Hold what is missing, as the filter does; decide what the sample can be used for."""
    read = [("u_now", S("input"), "last_input", "input_limit")]
    read += [(f"{q.name}_used", q.symbol, f"last_{q.name}", "signal_limit") for q in layout.signals]
    measured = sp.And(S("code") < STATUS["no_measurement"] - HALF, _within(S("measured"), "output_limit"))
    lost = sp.Or(S("started") < HALF, _is("restarted", "too_slow"))
    return [
        *(
            When(_within(given, limit), (Assign(now, given),), (Assign(now, S(last)),), "missing: held")
            for now, given, last, limit in read
        ),
        Assign("usable", sp.Piecewise((1, measured), (0, True))),
        Assign("anew", sp.Piecewise((1, lost), (0, True))),
        Assign("started", sp.Integer(1)),
    ]


def _restart(layout: Layout, tracks: Tracks) -> list[Statement]:
    clear = [*tracks.anew(), Assign("last_input", S("u_now"))]
    clear += [Assign(f"last_{q.name}", S(f"{q.name}_used")) for q in layout.signals]
    clear += [line for k in KINDS for line in begin_anew(tracks, k)]
    return [When(S("anew") > HALF, tuple(clear), (), "nothing is known of the dynamics")]


def _reference(layout: Layout) -> list[Statement]:
    """The unknowns as they were: the estimate itself until armed, then slowly after it."""
    now = {f"{layout.target}_held": S("estimate")}
    now |= {f"{name}_held": S(f"{name}_now") for name in layout.unknowns[1:]}
    now |= {"input_offset_held": S("offset_now"), "output_bias_held": S("bias_now")}
    now["variance_held"] = S("own_variance")
    slowly = sp.And(_is("ok"), hears())
    follow = sp.Piecewise((1, sp.Not(armed())), (share("reference_rate"), slowly), (0, True))
    return [
        Assign("follow", follow),
        *(Assign(name, S(name) + S("follow") * (x - S(name))) for name, x in now.items()),
    ]


def _scales(layout: Layout) -> list[Statement]:
    """Scales used now and before, kept off zero, and what follows from them."""
    groups = layout.reduction.groups
    lines: list[Statement] = []
    if layout.signals:
        lines.append(Assign("least_scale", S("signal_limit") * LEAST_SHARE))
    for q in layout.signals:
        lines.append(Assign(f"at_{q.name}", sp.Max(S(f"{q.name}_used"), S("least_scale")), "kept off zero"))
        lines.append(Assign(f"was_{q.name}", sp.Max(S(f"last_{q.name}"), S("least_scale"))))
    for q in (*layout.signals, *layout.scales):
        lines.append(Assign(layout.inverse(q.name).name, 1 / layout.at(q.name)))
    lines += [
        Assign("output_scale", layout.inverted(groups.scale[layout.output.name])),
        Assign("h", sp.Min(dt, LONGEST_SPAN) * layout.inverted(1 / groups.time_scale), "dimensionless step"),
        Assign("steer", (S("last_input") + S("u_now")) / 2, "mean of the sample's two ends"),
        Assign("steer_change", S("u_now") - S("last_input")),
        Assign("keep_w", sp.Max(0, 1 - dt * S("disturbance_rate"))),
    ]
    before = {q.symbol: S(f"was_{q.name}") for q in layout.signals}
    for name, q in zip(layout.fast, groups.model.states, strict=True):
        ratio = layout.inverted(groups.scale[q.name].xreplace(before) / groups.scale[q.name])
        lines.append(Assign(f"ratio_{name}", ratio, "same physical state in the new scales"))
    return lines


def _validity(layout: Layout, tracks: Tracks) -> list[Statement]:
    groups = layout.reduction.groups
    if groups.model.validity is None:
        return []
    states = zip(groups.model.states, tracks.of("held"), strict=True)
    physical = {q.symbol: groups.scale[q.name] * S(x) for q, x in states}
    signal = layout.inverted(groups.model.validity[0].subs(physical, simultaneous=True))
    return [
        Assign("validity_now", signal, groups.model.validity[1].meaning),
        Assign("validity_then", S("validity") * (1 - share("validity_rate"))),
        Assign("validity", sp.Max(S("validity_now") ** 2, S("validity_then"))),
    ]
