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


def surprise(linear: sp.Basic) -> Assign:
    """Recent surprise; beyond the linear range an innovation counts as usual."""
    told = sp.Piecewise((sp.Min(S("nis"), 9), linear), (1, True))
    mean = S("surprise") + share("surprise_rate") * (told - S("surprise"))
    return Assign("surprise", mean, "recent mean of the normalised innovation squared")


def doubt(variance: sp.Expr, linear: sp.Basic = sp.true) -> list[Assign]:
    """What the innovations of late say against the first unknown as it is now.

    With an information J of late and a variance P of the unknown, the score has variance J (1 + J P) while
    the filter is right; a jump by d moves it by J d. J and P are those with everything else unknown.
    Outside the ``linear`` range the score waits, and nothing is doubted.
    """
    told, keep = S("told"), S("keep_score")
    return [
        Assign("keep_score", sp.Piecewise((1 - share("score_rate"), linear), (1, True))),
        Assign("told", sp.Piecewise((S("sensitivity") * S("inv_spread"), linear), (0, True))),
        Assign("heard", keep * S("heard") + told * S("sensitivity"), "information of late"),
        Assign("score", keep * S("score") + told * S("innovation")),
        Assign(
            "score_variance",
            S("heard") * (1 + S("heard") * variance) + S("prior_information"),
            "little is no evidence",
        ),
        Assign(
            "doubt",
            sp.Piecewise(
                (sp.Min(S("score") ** 2 / S("score_variance") - S("score_enough"), S("score_most")), linear),
                (0, True),
            ),
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
        Assign(
            "jump",
            sp.Max(sp.Piecewise((beyond, sp.And(beyond > 0, stands_out)), (0, True)), S("doubt")),
        ),
    ]


def moved_score(by: sp.Expr) -> Assign:
    """The score at the estimate as it is after the unknown has moved."""
    return Assign("score", S("score") - S("heard") * by, "at the estimate as it is now")
