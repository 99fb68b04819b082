"""The paper's estimator: high-pass filters, second difference, scalar recursive least squares.

Kept exact at constant speed; it is the reference, not the recommendation: y and phi share the
noise of the yaw rate, so a real gyro biases it (``paper_design.noise_bias``).

Where the paper is silent:
speed changes    the constant is that of the reduction, K = pi3 U^2, and the residual is one of the raw
                 output, so every sample weighs alike at any speed. The filters work on physical signals,
                 so the history is read in the scales of now (dU/dt left out).
missing values   the filters are fed the last usable value; nothing is learnt until
                 ``settle_samples`` usable samples have followed, the first of a log included.
a spike          counts like a missing value when the sample before was usable and the change is
                 beyond output_jump; a step that stays is believed from its second sample on.
uneven steps     a step that is off the sample time by dt_room counts like a missing value.
K <= 0           the regression itself is left alone; the least K is reported, with status at_limit.
overflow         normal_least is added to the sum of squares (in a constant turn it would halve every 14,000
                 updates without end), |K| within its limit.

Invariant: whatever the sample holds, every state stays finite and the next usable samples count.
"""

from __future__ import annotations

import sympy as sp

from similitude.estimators import filter_fields as ff
from similitude.estimators import paper_fields as pf
from similitude.estimators.paper_model import regression
from similitude.estimators.paper_step import asked_for, before_first, one_sample
from similitude.program.ir import Field, Program
from similitude.reduction import Reduction
from similitude.status import STATUS


def paper_regression(
    reduction: Reduction, *, unknown: str = "pi3", slopes: tuple[str, ...] = ("pi4",)
) -> Program:
    """Derive the step program of the paper's regression from a reduced model.

    Parameters
    ----------
    reduction : Reduction    second order, one input, one output, one measured scale.
    unknown : the group to identify; its slope in the z-coefficients comes from the model.
    slopes : groups frozen as a given slope times the unknown.

    Returns
    -------
    Program    ``<model>_paper``; sample and output begin as those of the population filter.

    Raises
    ------
    ModelError    the model is not one the regression holds for (``paper_model.regression``).

    References
    ----------
    Brennan & Alleyne 2004, eqs 21-27 and section 6.
    """
    r = regression(reduction, unknown=unknown, slopes=slopes)
    model, layout = reduction.groups.model, r.layout
    return Program(
        name=f"{model.name}_paper",
        title=f"Regression of the paper for the {model.name}",
        provenance=(
            f"model: {model.name}, {model.source}",
            f"base: {', '.join(reduction.groups.base)}",
            f"unknown: {unknown}; in proportion to it: {', '.join(slopes)}",
            f"m1/T = {sp.sstr(r.numerator)}",
            f"m2/T = {sp.sstr(r.denominator)}",
        ),
        config=pf.config_fields(r),
        state=pf.state_fields(r),
        sample=ff.sample_fields(layout),
        output=pf.output_fields(r),
        variables=(
            Field("status", "-", "status code"),
            Field("input_step", layout.input.unit, "change of the input used now"),
            Field("output_step", layout.output.unit, "change of the measurement used now"),
            Field("y_now", layout.output.unit, "measurement used now"),
            Field("waiting", "-", "usable samples until the filters have settled"),
            Field("scale_now", layout.signals[0].unit, "scale used now"),
        ),
        init=tuple(before_first(r)),
        step=tuple(one_sample(r)),
        status=STATUS,
        report=tuple(asked_for(r)),
    )
