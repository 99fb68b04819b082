"""When the first unknown is taken to have jumped: by surprise, by doubt, or because it could not have shown.

Surprise is the mean of the normalised innovation squared over half a second; it is quick, and blind where a
jump is small against noise and disturbance. Doubt is the score, the slope of the log likelihood along the
unknown over some seconds, against its variance. Where the information of those seconds could not have
shown a jump, the unknown diffuses faster all the time.

Invariant: what is added to the unknown's variance is never negative.
"""

from __future__ import annotations

import sympy as sp

from similitude.program.ir import Assign


def S(name: str) -> sp.Symbol:
    """The real symbol of that name."""
    return sp.Symbol(name, real=True)


def share(rate: str) -> sp.Expr:
    """Weight of the newest value in an average of the given rate."""
    return sp.Min(1, S("dt") * S(rate))


def quiet_drift() -> sp.Expr:
    """Diffusion of the first unknown without a jump [1/s], faster where one could not have shown."""
    return S("drift") + S("faint_drift") * sp.Max(0, 1 - S("heard") * S("inv_telling"))


def surprise() -> Assign:
    """Recent surprise; beyond the linear range an innovation counts as usual."""
    told = 1 + S("linear") * S("odd")
    mean = S("surprise") + share("surprise_rate") * (told - S("surprise"))
    return Assign("surprise", mean, "recent mean of the normalised innovation squared")


def doubt(variance: sp.Expr) -> list[Assign]:
    """What the innovations of late say against the first unknown as it is now.

    With an information J of late and a variance P of the unknown, the score has variance J (1 + J P) while
    the filter is right; a jump by d moves it by J d. J and P are those with everything else unknown.
    Outside the linear range (``linear`` is 1 in it, else 0) the score waits, and nothing is doubted.
    """
    told, keep, linear = S("told"), S("keep_score"), S("linear")
    return [
        Assign("keep_score", 1 - linear * share("score_rate")),
        Assign("told", linear * S("sensitivity") * S("inv_spread")),
        Assign("heard", keep * S("heard") + told * S("sensitivity"), "information of late"),
        Assign("score", keep * S("score") + told * S("innovation")),
        Assign(
            "score_variance",
            S("heard") * (1 + S("heard") * variance) + S("prior_information"),
            "little is no evidence",
        ),
        Assign(
            "doubt",
            linear * sp.Min(S("score") ** 2 / S("score_variance") - S("score_enough"), S("score_most")),
        ),
    ]


def jump() -> list[Assign]:
    """Surprise beyond its limit, where it also stands out from what this vehicle usually does, or doubt."""
    above = S("surprise") - 1
    stands_out = S("above") * S("above") > S("jump_ratio") * S("restlessness")
    beyond = S("surprise") - S("surprise_limit")
    return [
        Assign("above", above),
        Assign(
            "restlessness",
            S("restlessness") + share("noise_adapt") * (S("above") * S("above") - S("restlessness")),
        ),
        Assign("rise", sp.Piecewise((beyond, stands_out), (0, True))),
        Assign("either", sp.Max(S("rise"), S("doubt"))),
        Assign("jump", sp.Max(S("either"), 0)),
    ]


def moved_score(by: sp.Expr) -> Assign:
    """The score at the estimate as it is after the unknown has moved."""
    return Assign("score", S("score") - S("heard") * by, "at the estimate as it is now")
