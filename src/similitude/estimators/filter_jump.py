"""When the first unknown is taken to have jumped: by surprise, or because it could not have shown.

Surprise is the mean of the normalised innovation squared over half a second; it is quick, and blind where a
jump is small against noise and disturbance. Where the information of the last seconds could not have shown
a jump, the unknown diffuses faster all the time.

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


def heard() -> Assign:
    """What the last seconds told about the first unknown, with everything else unknown."""
    told = S("inv_spread") * S("sensitivity") ** 2
    return Assign("heard", (1 - share("heard_rate")) * S("heard") + told, "information of late")


def jump() -> list[Assign]:
    """Surprise beyond its limit, where it also stands out from what this vehicle usually does."""
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
        Assign("jump", sp.Max(S("rise"), 0)),
    ]
