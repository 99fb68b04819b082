"""Estimator: from a model and what is known of it to a step that runs on logs and on microcontrollers.

    one_channel -> gather_knowledge -> fewest_unknowns -> try_drive -> rank -> population filter or regression

Invariant: every number of the configuration is stated, of the population, or listed in `assumed` with the
words "taken"; the C that is run here is the C that is exported.
"""

from __future__ import annotations

import types
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from similitude.any_model.base_choice import choose_base
from similitude.any_model.choice import Choice, choose
from similitude.any_model.estimate import Estimate, estimate_of
from similitude.any_model.fewest_unknowns import FewestUnknowns, fewest_unknowns
from similitude.any_model.filter_numbers import Doubts, filter_numbers
from similitude.any_model.knowledge import gather_knowledge
from similitude.any_model.measured import LogColumns, read_columns
from similitude.any_model.one_channel import one_channel
from similitude.any_model.plant import respond
from similitude.any_model.regression_numbers import regression_numbers
from similitude.any_model.stated import doubts_of, drive_of, number_of, numbers_of
from similitude.any_model.trial import Trial, try_drive
from similitude.any_model.untold import rank_told
from similitude.any_model.words import estimator_text
from similitude.directions import Reduced
from similitude.embedded.configuration import Numbers
from similitude.embedded.folder import Export, export_source
from similitude.embedded.system import Source
from similitude.estimators.population_filter import population_filter
from similitude.estimators.sampled_regression import sampled_regression
from similitude.model import Model
from similitude.population import Prior
from similitude.populations.population import Population
from similitude.program.c import print_c
from similitude.program.library import Library, assemble
from similitude.program.python import print_python
from similitude.systems.system import System


@dataclass(frozen=True, eq=False)
class Estimator:
    """An estimator made to measure.

    Parameters
    ----------
    model : Model                 with one input and one output.
    fewest : FewestUnknowns       what is unknown and seen.
    reduced : Reduced             roles of the unknowns along the planned drive.
    choice : Choice               ``population`` or ``regression``, and why.
    prior : Prior                 of the unknowns, the identified one first.
    trial : Trial                 the median system along the planned drive.
    library : Library             the compiled step.    config : (fields,) its numbers [SI].
    assumed : name -> (value, unit, where from).
    source : Source               C and twin as printed.
    """

    model: Model
    fewest: FewestUnknowns
    reduced: Reduced
    choice: Choice
    prior: Prior
    trial: Trial
    start: Mapping[str, float]
    doubts: Doubts
    library: Library
    config: NDArray[np.float64]
    assumed: Mapping[str, tuple[float, str, str]]
    source: Source

    @property
    def step(self) -> float:
        """Time between samples [s]."""
        return self.trial.step

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of the unknowns, the identified one first."""
        return self.prior.names

    def run(self, log: str | Path | Mapping[str, ArrayLike]) -> Estimate:
        """Estimate along a log.

        Parameters
        ----------
        log : CSV or Parquet file whose headers are ``name [unit]`` with the model's names, or name -> (n,)
            values [SI]. Wanted are input, output and signals; ``t`` where the steps are not those planned.

        Returns
        -------
        Estimate      over the log, and at its end.

        Raises
        ------
        LogError      a column is missing, has no unit or another length.
        """
        columns: LogColumns = read_columns(log, self.model, step=self.step)
        state = self.library.start(self.config)
        outputs, status = self.library.run(self.config, state, columns.rows)
        return estimate_of(self, columns.t, outputs, status, state)

    def simulate(
        self,
        u: ArrayLike | None = None,
        *,
        seed: int,
        truth: Mapping[str, float] | None = None,
    ) -> dict[str, NDArray[np.float64]]:
        """A noisy log of one system of the population, simulated in SI by the dimensional equations.

        Parameters
        ----------
        u : (n,) input [SI]; the planned drive where left out.
        seed : of the system drawn and of the noise.
        truth : parameter -> value [SI], in place of those drawn.

        Returns
        -------
        dict          ``t``, input, signals and output, each (n,) [SI].
        """
        u = self.trial.u if u is None else np.asarray(u, dtype=float)
        drawn = {n: v[0] for n, v in self.fewest.knowledge.draw(1, seed=seed).items()}
        values = {**drawn, **(truth or {}), **self.fewest.signals}
        y = respond(self.model, values, u, self.step, start=self.start).output[0]
        noise = self.doubts.noise * np.random.default_rng([seed, 1]).standard_normal(len(u))
        signals = {n: np.full(len(u), v) for n, v in self.fewest.signals.items()}
        names = self.model.inputs[0].name, self.model.outputs[0].name
        return {"t": self.step * np.arange(len(u)), names[0]: u, **signals, names[1]: y + noise}

    def drawn(self, seed: int) -> dict[str, float]:
        """Parameters [SI] of the system that `simulate` draws with this seed."""
        return {n: float(v[0]) for n, v in self.fewest.knowledge.draw(1, seed=seed).items()}

    def export(self, out: str | Path, *, target: str, real: str = "float") -> Export:
        """Write the estimator as a folder of C for a microcontroller.

        Parameters
        ----------
        out : the folder; one that an earlier export wrote is replaced.
        target : ``cortex-m4f``, ``cortex-m3``, ``cortex-m0``, ``rv32``, ``avr`` or ``host``.
        real : ``float`` or ``double``.

        Returns
        -------
        Export        what was written, and what it costs where the tools to measure are there.

        Raises
        ------
        UsageError    no such target, or ``out`` holds something else.
        """
        return export_source(self.source, self.numbers, target=target, real=real, out=Path(out))

    @property
    def numbers(self) -> Numbers:
        """What an exported folder states of its numbers."""
        step = {"sample_time": (self.step, "s", "stated")}
        return Numbers(self.config, self.step, {**step, **self.assumed})

    @cached_property
    def twin(self) -> Library:
        """The same estimator run by its scalar Python twin."""
        return Library(self.library.name, self.library.layout, None)

    def __str__(self) -> str:
        return estimator_text(self)


def make_estimator(
    system: System | Model,
    *,
    drive: ArrayLike,
    step: str | float,
    noise: str | float,
    prior: Mapping[str, str] | None = None,
    population: Population | None = None,
    base: Sequence[str] | None = None,
    input: str | None = None,
    output: str | None = None,
    signals: Mapping[str, str] | None = None,
    start: Mapping[str, str] | None = None,
    roles: Mapping[str, str] | None = None,
    kind: str | None = None,
    doubts: Mapping[str, str | float] | None = None,
) -> Estimator:
    """Make the estimator of a model's unknowns.

    Parameters
    ----------
    system : System or Model    a System brings base and values along; of a Model all is to be stated.
    drive : (n,) planned input [SI], such as will be driven: it decides what is worth identifying.
    step : time between samples, ``"10 ms"`` or [s].
    noise : sd of the measured output a sample, ``"0.1 deg/s"`` or [SI].
    prior : parameter -> ``"0.01 kg m^2 +- 30 %"``; without a spread it is exact.
    population : of similar systems, from `read_population`.
    base : repeating variables; the system's own, else the one that the adviser puts first.
    input, output : which, where there are several; other inputs are zero.
    signals : signal -> ``"60 m/s"``, a usual value; the system's own where left out.
    start : state -> ``"0.5 m"`` at the first sample, and about which it moves.
    roles : unknown -> ``identify``, ``estimate``, ``consider`` or ``never``, against the rule.
    kind : ``"population"`` or ``"regression"``, against the rule.
    doubts : ``input_error``, ``input_offset``, ``output_bias``, ``disturbance``, ``model_error``, ``drift``:
        what may be wrong besides, each an sd as text or [SI]; what is left out is taken and said so.

    Returns
    -------
    Estimator

    Raises
    ------
    ModelError    nothing is unknown, or the output tells nothing of it.
    UsageError    a name does not exist, nothing is known of a parameter, or a choice is impossible.
    UnitError     a text cannot be read.

    References
    ----------
    Brennan & Alleyne 2004, sections 4 and 5, for the method; estimators and reduction are this project's.
    """
    parts = system if isinstance(system, System) else None
    model = one_channel(parts.model if parts else system, input=input, output=output)
    own = parts.numbers() if parts else {}
    nominal = numbers_of(model, "signals", signals, wanted=model.signals, own=own)
    begun = numbers_of(model, "start", start, wanted=(), own={})
    seconds = number_of("step", step, "s")
    u = drive_of(drive, model)
    told = doubts_of(model, noise, doubts)
    knowledge = gather_knowledge(model, values=own, prior=prior, population=population)
    exact = [n for n in knowledge.names if n not in knowledge.uncertain]
    model, base, added = choose_base(model, exact, base=base or (parts.base if parts else None))
    knowledge = knowledge.measuring(added)
    meanings = dict(parts.meanings) if parts else {}
    fewest = fewest_unknowns(model, base, knowledge, signals=nominal, start=begun, meanings=meanings)
    trial = try_drive(model, fewest, u, seconds, start=begun)
    reduced = rank_told(fewest.reduction, fewest.prior, trial.slopes / told.noise, roles=roles)
    ordered = fewest.prior.of(tuple(one.name for one in reduced.reduction.unknowns))
    choice = choose(model, fewest, reduced, ordered, trial, kind=kind)
    return _made(model, fewest, reduced, choice, ordered, trial, begun, told)


def _made(
    model: Model,
    fewest: FewestUnknowns,
    reduced: Reduced,
    choice: Choice,
    prior: Prior,
    trial: Trial,
    start: Mapping[str, float],
    doubts: Doubts,
) -> Estimator:
    regression = choice.kind == "regression"
    reduction = reduced.reduction
    program = sampled_regression(reduction) if regression else population_filter(reduction, warming=True)
    c, twin = print_c(program), print_python(program)
    layout: Any = types.ModuleType(program.name)
    exec(compile(twin, f"{program.name}.py", "exec"), layout.__dict__)
    library = assemble(layout, c)
    if regression:
        config, assumed = regression_numbers(
            library, fewest, reduced.reduction, prior, trial, doubts, frozen=choice.frozen, bend=choice.bend
        )
    else:
        config, assumed = filter_numbers(library, fewest, prior, trial, doubts)
    source = Source(program.name, choice.kind, c, twin, model.name)
    return Estimator(
        model, fewest, reduced, choice, prior, trial, start, doubts, library, config, assumed, source
    )
