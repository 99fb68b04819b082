"""The test of a monitor: evidence for a change, as log likelihood ratio against the reference.

A change is supposed to begin now. While the innovations speak for it, its evidence grows and its size
is fitted; where they speak against it, it is supposed to begin anew. What gusts, kerbs and a model that
is a little wrong do to the innovations is measured as it comes, and the evidence is divided by it:

rough      mean square of the innovations' slow part against white noise, under the best hypothesis
distrust   the same of the score, over a minute
pieces     beyond so much, one half-wave of the signature counts little, and only where the change
           explains it: a gust has one hump, too

Invariant: evidence is only gathered while the monitor is armed, hears enough and is in the linear range.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.filter_fields import Layout
from similitude.estimators.monitor_fields import RESTS
from similitude.estimators.monitor_track import KINDS, S, Tracks
from similitude.program.ir import Assign, Statement, When
from similitude.status import STATUS

HALF = sp.Rational(1, 2)
LEAST = sp.Float(1e-9)  # keeps a quotient finite where nothing was heard yet
RATIO_MOST = 16  # squared score over its variance that one sample of the average may be
dt = S("dt")


def armed() -> sp.Basic:
    """Enough was heard for the reference to be trusted."""
    return sp.And(S("known") > S("known_least"), S("heard") > S("heard_least"))


def hears() -> sp.Basic:
    """The drive says enough now."""
    return S("hearing") > S("hearing_least")


def share(rate: str) -> sp.Expr:
    """Weight of the newest value in an average of the given rate."""
    return sp.Min(1, dt * S(rate))


def begin_anew(tracks: Tracks, k: str) -> list[Statement]:
    """Suppose that a change begins now: until now everything was as the reference has it."""
    names = ("evidence", "age", "weight_sum", "score_sum", "lately", "side", "piece")
    lines = [Assign(f"{name}_{k}", sp.Integer(0)) for name in names]
    lines += [Assign(a, S(b)) for a, b in zip(tracks.of(k), tracks.of("plain"), strict=True)]
    lines += [Assign(f"smooth_{k}", S("smooth_same")), Assign(f"rough_{k}", S("rough_same"))]
    return [*lines, *(Assign(x, sp.Integer(0)) for x in tracks.missing[k])]


def sizes(layout: Layout) -> list[Statement]:
    """Size of the supposed changes, from what was seen since, and the unknown after them."""
    lines: list[Statement] = []
    for k, sign in zip(KINDS, (-1, 1), strict=True):
        d = S(f"size_{k}")
        seen = sign * S(f"score_sum_{k}") + S("size_weight") * S("size_guess")
        guess = seen / (S(f"weight_sum_{k}") + S("size_weight"))
        lines += [
            Assign(f"size_{k}", sign * sp.Min(sp.Max(guess, S("size_least")), S("size_most"))),
            Assign(
                f"{layout.target}_{k}",
                S(f"{layout.target}_held") * (12 + d * (6 + d)) / (12 + d * (d - 6)),
                f"exp by its Pade approximant, good to 0.1 % for a {k} by a factor of three",
            ),
        ]
    return lines


def judge(layout: Layout, tracks: Tracks) -> list[Statement]:
    """Everything that is done with one measurement."""
    lines: list[Statement] = [*tracks.measure(), *_rests(), *tracks.correct(), *_roughness(), *_hearing()]
    test = [line for k in KINDS for line in _gather(tracks, k)]
    test += [line for code, k in enumerate(KINDS, 1) for line in _ring(k, code)]
    after = [line for k in KINDS for line in begin_anew(tracks, k)]
    after.append(Assign("heard", S("heard_least") - S("heard_again")))
    test.append(When(S("alarm") > HALF, tuple(after), (), "the reference is learnt anew"))
    live = sp.And(S("validity") < S("validity_limit") ** 2, armed(), hears())
    return [*lines, When(live, tuple(test), (), "in the linear range, with enough to hear")]


def _rests() -> list[Statement]:
    """What each hypothesis leaves of the innovation, and the weight of this sample."""
    rests = {"same": S("innovation"), **{k: S("innovation") - S(f"signature_{k}") for k in KINDS}}
    lines: list[Statement] = [Assign(f"rest_{x}", rest) for x, rest in rests.items()]
    least = S(f"rest_{RESTS[0]}") ** 2
    for x in RESTS[1:]:
        least = sp.Min(least, S(f"rest_{x}") ** 2)
    ratio = S("outlier_ratio")
    return [
        *lines,
        Assign("rest_least", least * S("inv_spread")),
        Assign(
            "weight",
            sp.Piecewise((ratio / S("rest_least"), S("rest_least") > ratio), (1, True)),
            "what no hypothesis explains counts for less",
        ),
    ]


def _roughness() -> list[Statement]:
    """The innovations' slow part against what it were in white noise."""
    new = S("smooth_share")
    lines: list[Statement] = [
        Assign("smooth_share", share("smooth_rate")),
        Assign("inv_white", (2 - new) / new * S("inv_spread"), "1/variance of the average of white noise"),
    ]
    for x in RESTS:
        lines += [
            Assign(f"smooth_{x}", S(f"smooth_{x}") + new * (S(f"rest_{x}") - S(f"smooth_{x}"))),
            Assign(
                f"rough_{x}",
                S(f"rough_{x}")
                + share("rough_rate") * (S(f"smooth_{x}") ** 2 * S("inv_white") - S(f"rough_{x}")),
            ),
        ]
    least = sp.Min(S("rough_same"), sp.Min(S("rough_fall"), S("rough_rise")))
    return [*lines, Assign("rough", sp.Max(1, least))]


def _hearing() -> list[Statement]:
    """How much the drive says, and how far what it says can be trusted."""
    surely = sp.And(S("code") < STATUS["ok"] + HALF, hears())
    heard = sp.Piecewise((-dt, S("own_variance") > S("variance_most")), (dt, surely), (0, True))
    keep = S("score_keep")
    ratio = sp.Min(S("score") ** 2 / (S("score_variance") + LEAST), RATIO_MOST)
    return [
        Assign("slope", HALF * (S("signature_fall") / S("size_fall") + S("signature_rise") / S("size_rise"))),
        Assign("fresh", S("slope") ** 2 * S("inv_spread"), "information"),
        Assign("known", S("known") + S("fresh")),
        Assign("hearing", S("hearing") + share("hearing_rate") * (S("fresh") / dt - S("hearing"))),
        Assign("heard", sp.Max(0, sp.Min(S("heard") + heard, S("heard_least") + S("heard_spare")))),
        Assign("score_keep", 1 - share("score_rate")),
        Assign("score", keep * S("score") + S("slope") * S("innovation") * S("inv_spread")),
        Assign("score_variance", keep * keep * S("score_variance") + S("fresh")),
        Assign("distrust", S("distrust") + share("distrust_rate") * (ratio - S("distrust"))),
        Assign("doubt", sp.Max(1, 1 + S("distrust_share") * (S("distrust") - 1)) * S("rough")),
        Assign("trust", S("weight") / S("doubt")),
        Assign("gain_bound", S("gain_most") * dt / sp.Max(1, S("rough") / S("rough_free"))),
    ]


def _gather(tracks: Tracks, k: str) -> list[Statement]:
    """Evidence for one kind of change and what it says of its size."""
    signature, slope = S(f"signature_{k}"), S(f"slope_{k}")
    gain = (S("innovation") - HALF * signature) * signature * S("inv_spread") * S("trust")
    lean = S(f"lean_{k}")
    explains = S(f"rough_{k}") < S("piece_fit") * S("rough_same")
    beyond = sp.Piecewise((S("piece_share") * S(f"lately_{k}"), explains), (0, True))
    other_side = (Assign(f"side_{k}", lean), Assign(f"piece_{k}", sp.Integer(0)))
    over = sp.Or(S(f"evidence_{k}") <= -S("evidence_floor"), S(f"age_{k}") > S("age_most"))
    return [
        Assign(f"lately_{k}", S(f"lately_{k}") + share("gain_rate") * (gain - S(f"lately_{k}"))),
        Assign(f"lean_{k}", S("smooth_same") - S(f"smooth_{k}"), "the signature's slow part"),
        When(lean * S(f"side_{k}") <= 0, other_side, (), "the next half-wave"),
        Assign(f"gained_{k}", sp.Max(sp.Min(S(f"lately_{k}"), S("gain_bound")), -S("gain_bound"))),
        Assign(f"beyond_{k}", beyond, "what a half-wave that is used up still counts for"),
        Assign(
            f"allowed_{k}",
            sp.Min(S(f"gained_{k}"), sp.Max(S("piece_most") - S(f"piece_{k}"), S(f"beyond_{k}"))),
        ),
        Assign(f"piece_{k}", S(f"piece_{k}") + S(f"allowed_{k}")),
        Assign(f"evidence_{k}", S(f"evidence_{k}") * (1 - share("evidence_leak")) + S(f"allowed_{k}")),
        Assign(f"age_{k}", S(f"age_{k}") + dt),
        Assign(f"slope_{k}", signature / S(f"size_{k}"), f"of the innovation to ln {tracks.layout.target}"),
        Assign(f"weight_sum_{k}", S(f"weight_sum_{k}") + S("weight") * slope**2 * S("inv_spread")),
        Assign(
            f"score_sum_{k}",
            S(f"score_sum_{k}") + S("weight") * slope * S("innovation") * S("inv_spread"),
        ),
        When(over, tuple(begin_anew(tracks, k)), (), "nothing speaks for it"),
    ]


def told(k: str) -> sp.Expr:
    """Evidence for a kind of change, less what its smallness costs."""
    # most of what rings for nothing is small
    size = S(f"size_{k}") * (-1 if k == KINDS[0] else 1)
    return S(f"evidence_{k}") - S("small_price") * sp.Max(0, S("size_large") - size)


def _ring(k: str, code: int) -> list[Statement]:
    explained = S(f"rough_{k}") < S("rough_free") + S("rough_share") * S("rough_same")
    large = S(f"size_{k}") ** 2 > S("sizes_squared") * S("variance_held")
    tell = (
        Assign("alarm", sp.Integer(code)),
        Assign("onset_age", S(f"age_{k}")),
        Assign("change", S(f"size_{k}")),
        Assign("change_variance", S("doubt") / (S(f"weight_sum_{k}") + S("size_weight"))),
    )
    return [When(sp.And(told(k) > S(f"threshold_{k}"), explained, large), tell, (), f"a {k}")]
