"""What the ladder's regressions do with a residual: excitation, forgetting, scatter, information.

    psi   regressor of the unknown, what the others explain taken out     e   residual
    A     sum of psi^2 with forgetting, sensor noise's own share taken out

The scatter of a least-squares estimate is S/A with S the variance of e, if e is white. It never is: it
comes through the filters, from gusts, and from a model that is a little wrong. So S is measured as the
estimate feels it: over stretches of ``block`` seconds, longer than any of these stay alike,
S = mean of (sum of psi e)^2 over the sum of psi^2; ten such stretches are remembered.

While nothing is learnt the unknown may change unseen: ``aged`` grows, and is forgotten as what is old is.

Invariant: the variance handed out is finite and positive, and is at its limit while nothing was learnt.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.held_sample import S
from similitude.program.ir import Assign, Field, Statement, When

FEWEST = sp.Rational(5, 2)  # blocks, and half of one, before a scatter is believed
BLOCKS_SHARE = sp.Rational(1, 64)  # of A that the blocks must hold: S is no quotient of next to nothing
SMALL_SAMPLE = 5  # variance x (1 + 5/n) for n blocks: within a fifth of Student's t for n >= 3


def excite(drive: sp.Expr) -> list[Statement]:
    """Follow the mean square of the noise-free drive of the regression.

    ``excited`` becomes 1 where that mean is enough to learn from.
    """
    follow = sp.Min(1, S("dt") * S("excitation_rate"))
    more = S("excitation") > S("excitation_least")
    return [
        Assign("drive", drive, "what the input alone does to the regression"),
        Assign("excitation", S("excitation") + follow * (S("drive") ** 2 - S("excitation"))),
        Assign("excited", sp.Piecewise((1, more), (0, True))),
    ]


def score(psi: sp.Expr, residual: sp.Expr) -> list[Statement]:
    """Add a sample to the block; close the block when it is long enough.

    The first block is not counted: in it the estimate is still on its way.
    """
    weight, square = S("block_weight"), S("block_score") ** 2
    kept, counted = S("block_keep"), S("counted")
    close = (
        Assign("counted", sp.Piecewise((1, S("blocks") > -sp.Rational(1, 2)), (0, True)), "not the first"),
        Assign("scatter_sum", counted * (kept * S("scatter_sum") + square)),
        Assign("scatter_weight", counted * (kept * S("scatter_weight") + weight)),
        Assign("blocks", sp.Min(S("blocks") + 1, S("blocks_most"))),
        *(Assign(name, sp.Integer(0)) for name in ("block_score", "block_weight", "block_age")),
    )
    return [
        Assign("block_score", S("block_score") + psi * residual),
        Assign("block_weight", weight + psi**2),
        Assign("block_age", S("block_age") + S("dt")),
        When(S("block_age") >= S("block"), close, (), "the block is full"),
    ]


def scatter(psi: sp.Expr, normal: sp.Expr, per: sp.Expr) -> list[Statement]:
    """Variance of the estimate's logarithm, and the information this sample added.

    ``normal`` = A, which the caller knows to be positive; ``per`` = d(estimate)/d(its logarithm), squared.
    """
    enough = sp.And(S("blocks") > FEWEST, S("scatter_weight") > BLOCKS_SHARE * normal)
    spread = S("scatter_sum") / S("scatter_weight")
    raised = S("spread") * (1 + SMALL_SAMPLE / S("blocks")) / (normal * per)
    return [
        When(
            enough,
            (
                Assign("spread", sp.Max(spread, S("scatter_low")), "variance of the residual as felt"),
                Assign("log_variance", sp.Min(raised, S("variance_limit"))),
                Assign("told", psi**2 * per / S("spread"), "by this sample"),
                Assign("information", S("information") + S("told")),
            ),
            (),
            "enough blocks",
        ),
    ]


def keep_within(target: str) -> list[Statement]:
    """Hold the estimate inside what the population allows; ``edge`` tells whether it had to be."""
    low, high = S(f"{target}_low"), S(f"{target}_high")
    beyond = sp.Or(S(target) < low, S(target) > high)
    return [
        Assign("edge", sp.Integer(0)),
        When(
            beyond,
            (
                Assign(target, sp.Max(S(target), low)),
                Assign(target, sp.Min(S(target), high)),
                Assign("edge", sp.Integer(1)),
            ),
            (),
            "no car is softer or stiffer",
        ),
    ]


def scatter_config() -> tuple[Field, ...]:
    """Configuration of excitation, blocks and the reported variance."""
    return (
        Field("excitation_least", "-", "least mean square of the drive to learn from, in its units"),
        Field("excitation_rate", "1/s", "averaging rate of that mean square"),
        Field("block", "s", "length of a block of the scatter"),
        Field("block_keep", "-", "share of the older blocks kept at each new one"),
        Field("blocks_most", "-", "blocks remembered"),
        Field("scatter_low", "-", "least variance of the residual, in its units, > 0"),
        Field("variance_limit", "-", "greatest variance that is reported"),
        Field("idle_drift", "1/s", "growth of the variance while nothing is learnt"),
    )


def scatter_state(target: str) -> tuple[Field, ...]:
    """State of excitation, blocks and the reported variance."""
    return (
        Field("excitation", "-", "mean square of the drive, in its units"),
        Field("mean_square", "-", "mean square of the innovation, in its units"),
        Field("block_score", "-", "sum of regressor times residual over this block"),
        Field("block_weight", "-", "sum of squared regressor over this block"),
        Field("block_age", "s", "age of this block"),
        Field("scatter_sum", "-", "squared scores of the blocks remembered"),
        Field("scatter_weight", "-", "their weights"),
        Field("blocks", "-", "how many there are"),
        Field("log_variance", "-", f"variance of ln {target} from the scatter"),
        Field("aged", "-", "variance grown while nothing was learnt"),
        Field("information", "-", f"information gained about ln {target}"),
    )


def scatter_variables() -> tuple[Field, ...]:
    """Working values that outlive the guards they are assigned in."""
    return (
        Field("excited", "-", "1 where the input says enough"),
        Field("edge", "-", "1 where the estimate sits at the edge of the population"),
        Field("spread", "-", "variance of the residual as the estimate feels it"),
    )


def started_at(values: dict[str, sp.Expr], fields: tuple[Field, ...]) -> list[Statement]:
    """Statements of ``init``: the named values, every other real of the state at zero."""
    names = [s.name for f in fields for s in f.symbols]
    return [Assign(name, sp.sympify(values.get(name, 0))) for name in names]


def age(learn: sp.Basic, keep: sp.Expr) -> When:
    """Forget the ageing while samples teach, let it grow while they do not."""
    grown = sp.Min(S("aged") + S("dt") * S("idle_drift"), S("variance_limit"))
    return When(learn, (Assign("aged", keep * S("aged")),), (Assign("aged", grown),), "unseen, K may change")
