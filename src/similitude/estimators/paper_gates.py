"""The paper's regression before it computes: what a sample can be used for, and what is held.

Invariant: after the gates ``u_now``, ``y_now`` and the last scale are believable numbers.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators.held_sample import HALF, S, at_now
from similitude.estimators.held_sample import gates as sample_gates
from similitude.estimators.paper_model import Regression
from similitude.program.ir import Assign, Statement, When


def gates(r: Regression) -> list[Statement]:
    """All that precedes the first use of the sample; a later status replaces an earlier one."""
    old, now = f"last_{r.speed}", S("scale_now")
    per = r.per_target
    ratio = sp.simplify(per.xreplace({S(r.speed): now}) / per.xreplace({S(r.speed): S(old)}))
    rescale = (
        Assign("ratio", ratio, f"of {r.unknown} for the same {r.layout.target}"),
        Assign("theta", S("theta") * S("ratio")),
        Assign("P", S("P") * S("ratio") ** 2),
    )
    another = (
        When(S("started") > HALF, rescale, (), "the same constant"),
        Assign(old, now),
        *at_scale_of_now(r),
    )
    return sample_gates(r, another)


def at_scale_of_now(r: Regression) -> list[Assign]:
    """m1, m2 and units at the scale of now, kept until the scale changes."""
    groups, layout = r.reduction.groups, r.layout
    per_input = S("sample_time") / at_now(r, groups.time_scale * groups.scale[layout.input.name])
    per_output = S("sample_time") / at_now(r, groups.time_scale) * S("star")
    unit = at_now(r, groups.scale[layout.output.name])
    return [
        Assign("unit", unit),
        Assign("star", 1 / unit),
        Assign("m1", S("m1_rate") * per_input, "eq 22, per physical input"),
        Assign("m2", S("m2_rate") * per_output, "eq 22, per physical output"),
    ]
