"""The structs of a population filter: what it is told, what it remembers, what it hands out.

Invariant: every field is a plain real, so a struct is an array of reals that can be saved,
compared and restored; the names follow from the Reduction alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from similitude.estimators.further_fields import (
    further_config,
    further_sample,
    further_state,
)
from similitude.model import Quantity
from similitude.program.ir import Field
from similitude.program.symmetric import Symmetric
from similitude.reduction import Reduction

DISTURBANCE, OFFSET, BIAS = "disturbance", "input_offset", "output_bias"
PLAIN_OFFSET = "input_offset_plain"
INPUT_SCALE = "input_scale"


@dataclass(frozen=True)
class Layout:
    """Order of the filter's states and the names of everything around them.

    ``warming``: whether the first samples count for less, so that the unknowns are not fixed by a straight
    line through where they were guessed.
    """

    reduction: Reduction
    errors: tuple[str, ...] = (INPUT_SCALE, OFFSET, BIAS)  # of the sensors, those that are carried
    monitored: bool = True  # hand out what a monitor beside it needs
    followed: bool = True  # sensitivities along states of their own, not along the estimate
    fine: bool = True  # two half steps a sample and a straight line between inputs; else one whole step
    warming: bool = False
    lean: bool = False  # for small parts: see filter_lean

    @property
    def moving(self) -> tuple[str, ...]:
        """Coordinates that are kept between limits."""
        own = tuple(u.name for u in self.reduction.unknowns if u.role != "consider")
        return (*own, INPUT_SCALE) if INPUT_SCALE in self.errors else own

    @property
    def fast(self) -> tuple[str, ...]:
        """Dynamic states, dimensionless."""
        return tuple(f"{q.name}_star" for q in self.reduction.groups.model.states)

    @property
    def companion(self) -> tuple[str, ...]:
        """The same states along the input alone, where sensitivities are taken."""
        return tuple(f"{name}_plain" for name in self.fast) if self.followed else ()

    @property
    def leans_on_offset(self) -> bool:
        """Whether the companion is driven with an offset of its own."""
        return self.followed and OFFSET in self.errors

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Slow unknowns, the one to identify first."""
        return tuple(u.name for u in self.reduction.unknowns)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """All n filter states in the order of the covariance."""
        biases = (f"{q.name}_bias" for q in self.further)
        return (*self.fast, DISTURBANCE, *self.unknowns, *self.errors, *biases)

    @property
    def considered(self) -> tuple[str, ...]:
        """Coordinates that stay at their prior, whose uncertainty is carried along."""
        return tuple(u.name for u in self.reduction.unknowns if u.role == "consider")

    @property
    def seldom(self) -> tuple[str, ...]:
        """Unknowns that are learnt from one sample in a while."""
        return tuple(u.name for u in self.reduction.unknowns if u.role == "seldom")

    @property
    def beyond(self) -> tuple[str, ...]:
        """Unknowns that bend the model beyond its linear range."""
        return tuple(u.name for u in self.reduction.unknowns if u.role == "beyond")

    @property
    def covariance(self) -> Symmetric:
        """Covariance of the coordinates; logarithms of positive unknowns."""
        return Symmetric("P", len(self.coordinates))

    @property
    def prior(self) -> Symmetric:
        """Prior covariance of the slow unknowns."""
        return Symmetric("P_prior", len(self.unknowns))

    @property
    def target(self) -> str:
        """The unknown to identify."""
        return self.unknowns[0]

    @property
    def input(self) -> Quantity:
        """The driven input."""
        return self.reduction.groups.model.inputs[0]

    @property
    def output(self) -> Quantity:
        """The measured output."""
        return self.reduction.groups.model.outputs[0]

    @property
    def further(self) -> tuple[Quantity, ...]:
        """Outputs measured besides the first."""
        return self.reduction.groups.model.outputs[1:]

    @property
    def signals(self) -> tuple[Quantity, ...]:
        """Scales that are measured and may change from sample to sample."""
        model = self.reduction.groups.model
        return tuple(model.quantity(name) for name in model.signals)

    @property
    def scales(self) -> tuple[Quantity, ...]:
        """Known constant scales that the step needs."""
        groups = self.reduction.groups
        units = [groups.time_scale, *(groups.scale[q.name] for q in groups.model.states)]
        units += [groups.scale[self.output.name], groups.scale[self.input.name]]
        used = {s.name for e in units for s in sp.sympify(e).free_symbols}
        expressions = [*self.reduction.rates.values(), *self.reduction.output_map.values()]
        expressions += [self.reduction.live, *(groups.model.validity or ())[:1]]
        used |= {s.name for e in expressions for s in sp.sympify(e).free_symbols}
        return tuple(groups.model.quantity(n) for n in groups.base if n in used - set(groups.model.signals))

    def at(self, name: str) -> sp.Symbol:
        """The scale of that name as the step uses it now."""
        signals = self.reduction.groups.model.signals
        return sp.Symbol(f"at_{name}" if name in signals else name, real=True)

    def inverse(self, name: str) -> sp.Symbol:
        """The reciprocal of a scale, taken once a step."""
        return sp.Symbol(f"inv_{name}", real=True)

    def inverted(self, expression: sp.Expr) -> sp.Expr:
        """The expression with reciprocals of scales in place of divisions by them."""
        names = [q.name for q in (*self.signals, *self.scales)]
        expression = sp.sympify(expression)
        for name in names:
            scale = sp.Symbol(name, real=True)
            expression = expression.replace(
                lambda e, scale=scale: e.is_Pow and e.base == scale and e.exp.is_negative,
                lambda e, name=name: self.inverse(name) ** (-e.exp),
            ).xreplace({scale: self.at(name)})
        return expression


def config_fields(layout: Layout) -> tuple[Field, ...]:
    """What the filter is told once: scales, prior, sensor, and the design constants."""
    i, o, t = layout.input, layout.output, layout.target
    priors = [Field(f"{u.name}_prior", u.unit, f"prior of {u.meaning}") for u in layout.reduction.unknowns]
    limits = [
        Field(f"{u.name}_{side}", u.unit, f"{side}est value the population allows")
        for u in layout.reduction.unknowns
        for side in ("low", "high")
    ]
    return (
        *(Field(q.name, q.unit, q.meaning) for q in layout.scales),
        *priors,
        layout.prior.field("-", "prior covariance of the unknowns' coordinates, upper triangle"),
        Field("prior_information", "-", f"1/prior variance of ln {t}"),
        *limits,
        *_error_config(layout),
        *(Field(f"{name}_sd", "-", "sd after a restart") for name in layout.fast),
        Field("noise_variance", f"({o.unit})^2", f"white noise of {o.name} a sample"),
        Field("drift", "1/s", f"diffusion of ln {t} while it is observed"),
        Field("idle_drift", "1/s", f"diffusion of ln {t} while nothing is heard of it"),
        Field("jump_drift", "1/s", "further diffusion per unit of surprise above its limit"),
        *_if(BIAS in layout.errors, Field("bias_drift", f"({o.unit})^2/s", "random walk of the output bias")),
        Field("timing_error", "s", "timing error between input and output"),
        *_if(
            layout.followed,
            Field("companion_rate", "1/s", "rate at which the uncorrected states follow the estimate"),
        ),
        *_if(
            layout.leans_on_offset,
            Field("offset_rate", "1/s", "rate at which the uncorrected states' offset follows the estimate"),
        ),
        Field("structure_share", "-", "structural error as a share of the output's activity"),
        Field("structure_time", "s", "correlation time of the structural error"),
        Field("activity_rate", "1/s", "averaging rate of the output's activity"),
        Field("disturbance_floor", i.unit, "disturbance at rest, equivalent input"),
        Field("disturbance_share", "-", "disturbance as a share of the dimensionless activity"),
        Field("disturbance_rate", "1/s", "1/correlation time of the disturbance"),
        Field("disturbance_adapt", "1/s", "adaptation rate of the disturbance's size"),
        Field("disturbance_scale_start", "-", "disturbance variance against nominal at the start"),
        Field("disturbance_scale_low", "-", "least disturbance variance against nominal"),
        Field("disturbance_scale_high", "-", "greatest disturbance variance against nominal"),
        Field("noise_adapt", "1/s", "adaptation rate of the noise's size in the long run"),
        Field("noise_scale_low", "-", "least noise variance against nominal"),
        Field("noise_scale_high", "-", "greatest noise variance against nominal"),
        Field("excitation_ratio", "-", "least variance of sensitivity against noise to learn from"),
        Field("excitation_rate", "1/s", "averaging rate of the excitation"),
        Field("seldom", "s", "least time between samples that the seldom learnt unknowns learn from"),
        *_if(
            bool(layout.beyond),
            Field(
                "beyond_time",
                "s",
                f"beyond the linear range all but {', '.join(layout.beyond)} learn so seldom",
            ),
        ),
        *_if(
            not layout.lean,
            Field("slow_doubt", "-", f"share of ln {t}'s variance from learnt constants that is added to it"),
        ),
        Field("surprise_rate", "1/s", "averaging rate of the normalised innovation"),
        Field("jump_ratio", "-", "squared surprise against its long-run mean that speaks of a jump"),
        Field("surprise_limit", "-", "mean squared normalised innovation that speaks of a jump"),
        Field("heard_rate", "1/s", "rate at which what was told of the first unknown is forgotten"),
        Field("faint_drift", "1/s", f"further diffusion of ln {t} while a jump could not show"),
        Field("inv_telling", "-", "1/information of late in which a jump shows"),
        Field("observed_least", "-", "least share of the disturbance taken as observed"),
        Field("outlier_ratio", "-", "squared innovation over its variance beyond which it is bounded"),
        *(
            (
                Field("heat_start", "-", "noise variance the first sample is weighed with, over its own"),
                Field("heat_rate", "1/s", "rate at which that falls"),
            )
            if layout.warming
            else ()
        ),
        *_if(
            layout.lean,
            Field("longest", "s", "longest time a sample counts for in an average"),
        ),
        Field("gap", "s", "longest time without a usable sample before a restart"),
        Field("input_limit", i.unit, f"greatest believable {i.name}"),
        Field("output_limit", o.unit, f"greatest believable {o.name}"),
        Field(
            "signal_limit",
            layout.signals[0].unit if layout.signals else "-",
            "greatest believable scale",
        ),
        Field("validity_limit", _validity_unit(layout), "edge of the model's linear range"),
        Field("validity_rate", "1/s", "decay rate of the memory of a visit outside the linear range"),
        *(field for q in layout.further for field in further_config(q)),
    )


def _if(carried: bool, *fields: Field) -> tuple[Field, ...]:
    return fields if carried else ()


def _error_config(layout: Layout) -> tuple[Field, ...]:
    """What the filter is told of the sensor errors that it carries."""
    i, o = layout.input, layout.output
    return (
        *_if(
            INPUT_SCALE in layout.errors,
            Field("input_scale_sd", "-", f"sd of the scale of {i.name}, also that of the known scales"),
            Field("input_scale_low", "-", f"least scale of {i.name}"),
            Field("input_scale_high", "-", f"greatest scale of {i.name}"),
        ),
        *_if(
            OFFSET in layout.errors,
            Field("input_offset_sd", i.unit, f"prior sd of the offset of {i.name}"),
        ),
        *_if(BIAS in layout.errors, Field("output_bias_sd", o.unit, f"prior sd of the bias of {o.name}")),
    )


def _error_states(layout: Layout) -> tuple[Field, ...]:
    i, o = layout.input, layout.output
    known = {
        INPUT_SCALE: Field(INPUT_SCALE, "-", f"{i.name} that acts over {i.name} measured"),
        OFFSET: Field(OFFSET, i.unit, f"offset of {i.name}"),
        BIAS: Field(BIAS, o.unit, f"bias of {o.name}"),
    }
    return tuple(known[name] for name in layout.errors)


def _validity_unit(layout: Layout) -> str:
    validity = layout.reduction.groups.model.validity
    return validity[1].unit if validity else "-"


def state_fields(layout: Layout) -> tuple[Field, ...]:
    """What the filter remembers between samples."""
    i, o = layout.input, layout.output
    carried = len(layout.coordinates) if layout.lean else 0
    return (
        *(Field(name, "-", "dimensionless state") for name in layout.fast),
        *(Field(name, "-", "the same, not corrected by measurements") for name in layout.companion),
        *_if(
            layout.leans_on_offset,
            Field(PLAIN_OFFSET, i.unit, "its offset: the estimated one, followed slowly"),
        ),
        Field(DISTURBANCE, i.unit, f"disturbance as an equivalent {i.name}"),
        *(Field(u.name, u.unit, u.meaning) for u in layout.reduction.unknowns),
        *_error_states(layout),
        *(field for q in layout.further for field in further_state(q, coordinates=carried)),
        layout.covariance.field("-", "covariance of the coordinates above, upper triangle by rows"),
        Field("noise_scale", "-", "noise variance against nominal"),
        Field("disturbance_scale", "-", "disturbance variance against nominal"),
        Field("activity", f"({o.unit})^2", "mean square of the predicted output"),
        Field("settling", "1/s", "adaptation rate of the noise's size now, fast at first"),
        Field("restlessness", "-", "long-run mean square of the surprise beyond one"),
        Field("jump", "-", "surprise taken as a jump of the first unknown"),
        Field("surprise", "-", "recent mean of the normalised innovation squared"),
        Field("heard", "-", "recent information about the first unknown"),
        Field("excitation", f"({o.unit})^2", "mean square sensitivity to the first unknown"),
        Field("excited", "-", "1 while the input excites the first unknown, else 0"),
        Field("unlearnt", "s", "time since the seldom learnt unknowns last learnt anything"),
        *_if(
            bool(layout.beyond),
            Field("untaught", "s", f"time since a sample last taught more than {', '.join(layout.beyond)}"),
        ),
        Field(
            "validity",
            f"({_validity_unit(layout)})^2",
            "recent peak of the validity signal, squared",
        ),
        Field("information", "-", f"information gained about ln {layout.target}"),
        *((Field("heat", "-", "noise variance that is added now, over its own"),) if layout.warming else ()),
        Field("last_input", i.unit, "input of the sample before"),
        *(Field(f"last_{q.name}", q.unit, f"{q.meaning} of the sample before") for q in layout.signals),
        Field("age", "s", "time since the last usable sample"),
        *_if(
            layout.lean,
            Field("turn", "-", "which size adapts next: 0 disturbance, 1 noise, 2 excitation"),
        ),
        Field("started", "-", "1 once a sample was used; 0 again while the scales hide the dynamics"),
    )


def sample_fields(layout: Layout) -> tuple[Field, ...]:
    """One row of a log."""
    i, o = layout.input, layout.output
    return (
        Field("dt", "s", "time since the sample before"),
        Field("input", i.unit, i.meaning),
        *(Field(q.name, q.unit, q.meaning) for q in layout.signals),
        Field("measured", o.unit, f"measured {o.meaning}"),
        *(further_sample(q) for q in layout.further),
    )


def output_fields(layout: Layout) -> tuple[Field, ...]:
    """What each step hands out; always finite."""
    u = layout.reduction.unknowns[0]
    gained = Field("information_gained", "-", f"information gained about ln {u.name} so far")
    return (*estimate_fields(layout), gained)


def estimate_fields(layout: Layout) -> tuple[Field, ...]:
    """What every estimator hands out."""
    u, o = layout.reduction.unknowns[0], layout.output
    return (
        Field("estimate", u.unit, u.meaning),
        Field(
            "variance",
            "-",
            f"variance of ln {u.name}" if u.kind == "log" else f"variance of {u.name}",
        ),
        Field("predicted", o.unit, f"{o.meaning} predicted before the measurement"),
        Field("innovation", o.unit, "measured minus predicted; 0 without a measurement"),
        Field("innovation_variance", f"({o.unit})^2", "variance of the innovation"),
    )


def monitored_fields(layout: Layout) -> tuple[Field, ...]:
    """What a step hands out besides, for a monitor that follows the same drive with the unknowns held."""
    i, o = layout.input, layout.output
    if not layout.monitored:
        return ()
    return (
        Field("own_variance", "-", f"variance of ln {layout.target} that the filter goes by"),
        *(Field(f"{u.name}_now", u.unit, u.meaning) for u in layout.reduction.unknowns[1:]),
        Field("offset_now", i.unit, f"offset of {i.name}"),
        Field("bias_now", o.unit, f"bias of {o.name}"),
        Field("noise_now", f"({o.unit})^2", "variance of the measurement"),
        Field("disturbance_now", f"({i.unit})^2", "variance of the disturbance in the long run"),
    )
