"""The structs of a monitor: what it is told, what it remembers, what it hands out.

Invariant: a sample begins like a sample of the population filter and goes on with what that filter
handed out for it, so a monitor can follow any filter that hands out the same.
"""

from __future__ import annotations

from similitude.estimators import filter_fields as ff
from similitude.estimators.filter_fields import Layout
from similitude.estimators.monitor_track import KINDS, Tracks
from similitude.program.ir import Field

RESTS = ("same", *KINDS)  # what is left of the innovation under each hypothesis


def config_fields(layout: Layout) -> tuple[Field, ...]:
    """What the monitor is told once: scales, thresholds and design constants."""
    i, o, t = layout.input, layout.output, layout.target
    validity = layout.reduction.groups.model.validity
    return (
        *(Field(q.name, q.unit, q.meaning) for q in layout.scales),
        *(Field(f"{name}_sd", "-", "sd after a restart") for name in layout.fast),
        Field("disturbance_rate", "1/s", "1/correlation time of the disturbance"),
        Field("companion_rate", "1/s", "rate at which the drives along the input follow the held filter"),
        *(Field(f"threshold_{k}", "-", f"evidence that rings for a {k}") for k in KINDS),
        Field("evidence_floor", "-", "evidence against a change at which it is supposed to begin anew"),
        Field("evidence_leak", "1/s", "rate at which evidence is forgotten"),
        Field("age_most", "s", "longest time one supposed change is followed"),
        Field("gain_rate", "1/s", "averaging rate of the evidence gained"),
        Field("gain_most", "1/s", "most evidence gained in a second"),
        Field("piece_most", "-", "evidence from one half-wave of the signature that counts in full"),
        Field("piece_share", "-", "what counts of the rest where the change explains the drive"),
        Field("piece_fit", "-", "most of what the reference leaves that a change may leave, for that"),
        Field("size_least", "-", f"least change of ln {t} that is looked for"),
        Field("size_most", "-", f"greatest change of ln {t} that is looked for"),
        Field("size_large", "-", f"change of ln {t} that needs no more evidence than the threshold"),
        Field("small_price", "-", "further evidence a smaller one needs, for each unit of the difference"),
        Field("size_guess", "-", f"change of ln {t} supposed at first"),
        Field("size_weight", "-", "information the first guess is worth"),
        Field("outlier_ratio", "-", "squared innovation over its variance beyond which it is bounded"),
        Field("smooth_rate", "1/s", "averaging rate of the innovations' slow part"),
        Field("rough_rate", "1/s", "averaging rate of that part's mean square"),
        Field("rough_free", "-", "mean square against white noise up to which evidence comes fast"),
        Field("rough_share", "-", "most of what the reference leaves that a change may leave"),
        Field("score_rate", "1/s", "averaging rate of the score"),
        Field("distrust_rate", "1/s", "averaging rate of the squared score against its variance"),
        Field("distrust_share", "-", "how much of that is held against the evidence"),
        Field("sizes_squared", "-", "least squared size of a change over the reference's variance"),
        Field("reference_rate", "1/s", "rate at which the reference follows the estimate"),
        Field("known_least", "-", f"information about ln {t} before the monitor is armed"),
        Field("variance_most", "-", f"variance of ln {t} with which the monitor can be armed"),
        Field("heard_least", "s", "time of sure listening before the monitor is armed"),
        Field("heard_spare", "s", "most such time kept beyond that"),
        Field("heard_again", "s", "such time after an alarm before the next"),
        Field("hearing_rate", "1/s", "averaging rate of the information heard a second"),
        Field("hearing_least", "1/s", f"information about ln {t} a second below which nothing is judged"),
        Field("input_limit", i.unit, f"greatest believable {i.name}"),
        Field("output_limit", o.unit, f"greatest believable {o.name}"),
        Field("signal_limit", layout.signals[0].unit if layout.signals else "-", "greatest believable scale"),
        Field("validity_limit", validity[1].unit if validity else "-", "beyond it nothing is judged"),
        Field("validity_rate", "1/s", "decay rate of the memory of a visit beyond it"),
    )


def state_fields(layout: Layout) -> tuple[Field, ...]:
    """What the monitor remembers between samples."""
    i, o = layout.input, layout.output
    validity = layout.reduction.groups.model.validity
    per_kind = (
        ("size", "-", "logarithm of the supposed change"),
        ("evidence", "-", "log likelihood for it over the reference"),
        ("age", "s", "time since it is supposed"),
        ("weight_sum", "-", "information about its size"),
        ("score_sum", "-", "information times size"),
        ("lately", "-", "recent mean of the evidence gained"),
        ("side", o.unit, "signature's side of zero"),
        ("piece", "-", "evidence from this half-wave"),
    )
    return (
        *Tracks(layout).fields,
        *(Field(f"{u.name}_held", u.unit, f"reference of {u.meaning}") for u in layout.reduction.unknowns),
        Field("input_offset_held", i.unit, f"reference of the offset of {i.name}"),
        Field("output_bias_held", o.unit, f"reference of the bias of {o.name}"),
        Field("variance_held", "-", f"variance that ln {layout.target} has in the reference"),
        *(Field(f"{name}_{k}", unit, f"{k}: {text}") for k in KINDS for name, unit, text in per_kind),
        *(Field(f"smooth_{x}", o.unit, f"slow part of what is left, {x}") for x in RESTS),
        *(Field(f"rough_{x}", "-", f"its mean square against white noise, {x}") for x in RESTS),
        Field("score", "-", "recent score of the reference"),
        Field("score_variance", "-", "its variance were the innovations white"),
        Field("distrust", "-", "long-run mean of the squared score over that variance"),
        Field("known", "-", "information about the first unknown, the others given"),
        Field("hearing", "1/s", "the same a second"),
        Field("heard", "s", "time of sure listening"),
        Field("validity", f"({validity[1].unit if validity else '-'})^2", "recent peak, squared"),
        Field("last_input", i.unit, "input of the sample before"),
        *(Field(f"last_{q.name}", q.unit, f"{q.meaning} of the sample before") for q in layout.signals),
        Field("started", "-", "1 once a sample was seen"),
    )


def sample_fields(layout: Layout) -> tuple[Field, ...]:
    """The filter's sample, its status, and what it handed out for it."""
    u = layout.reduction.unknowns[0]
    return (
        *ff.sample_fields(layout),
        Field("code", "-", "status of the filter's step"),
        Field("estimate", u.unit, u.meaning),
        *ff.monitored_fields(layout),
    )


def output_fields(layout: Layout) -> tuple[Field, ...]:
    """What each step hands out; always finite."""
    u = layout.reduction.unknowns[0]
    return (
        Field("alarm", "-", "0, or 1 where a fall and 2 where a rise is found at this sample"),
        Field("onset_age", "s", "how long ago it began"),
        Field("change", "-", f"change of ln {u.name}"),
        Field("change_variance", "-", "its variance"),
        Field("reference", u.unit, f"what {u.name} was before, as the monitor follows it"),
        *(
            Field(f"evidence_of_{k}", "-", f"log likelihood of a {k}, less what its smallness costs")
            for k in KINDS
        ),
        Field("armed", "-", "1 where a change would be found now"),
        Field("information_rate", "1/s", f"information about ln {u.name} a second, the others given"),
    )
