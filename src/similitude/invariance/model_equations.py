"""A model's equations as a response needs them: one output, its input, and what proves their rows."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from similitude.errors import ModelError
from similitude.homogeneity.measure import Measure, measure_of
from similitude.homogeneity.walk import measure_of_expression
from similitude.invariance.response import Certificate
from similitude.model import Model, mismatches_of
from similitude.model_formulas import read_formula
from similitude.units import parse_unit

READ = 'docs/invariances.md, "Responses"'


@dataclass(frozen=True)
class Equations:
    """One output of a model.

    Parameters
    ----------
    model : Model
    name, output : how the output is called, and its formula in states, inputs and parameters.
    output_measure : its measure.
    angle : whether angles count.
    """

    model: Model
    name: str
    output: sp.Expr
    output_measure: Measure
    angle: bool

    @property
    def measures(self) -> dict[str, Measure]:
        """Name -> measure of every state, input and parameter."""
        kinds = (self.model.states, self.model.inputs, self.model.parameters)
        return {q.name: q.measure(angle=self.angle) for kind in kinds for q in kind}

    @property
    def time(self) -> Measure:
        """The measure of time."""
        return measure_of(parse_unit(self.model.time_unit), angle=self.angle)

    @property
    def parameters(self) -> dict[str, Measure]:
        """The parameters that the rates or the output hold, in the model's order."""
        used = self.used
        return {n: m for n, m in self.measures.items() if n in used and n in self._names}

    @property
    def _names(self) -> set[str]:
        return {q.name for q in self.model.parameters}

    @property
    def used(self) -> set[str]:
        """Names that occur in the rates or in the output."""
        formulas = (*self.model.rates.values(), self.output)
        return {symbol.name for formula in formulas for symbol in formula.free_symbols}

    @property
    def certificates(self) -> tuple[Certificate, ...]:
        """The rates and the output: their homogeneity is that of every response."""
        model = self.model
        rates = [
            Certificate(f"rate of {q.name}", model.rates[q.name], q.measure(angle=self.angle) / self.time)
            for q in model.states
        ]
        return (*rates, Certificate(f"output {self.name}", self.output, self.output_measure))

    def free(self, name: str) -> str:
        """The name, with an underscore behind it where the model has a quantity of that name."""
        while name in self.measures:
            name += "_"
        return name

    def input_named(self, name: str | None) -> int:
        """The place of an input; the only one where none is named.

        Raises
        ------
        ModelError    no input of that name, or several and none named.
        """
        names = [q.name for q in self.model.inputs]
        if name is None and len(names) == 1:
            return 0
        if name in names:
            return names.index(name)
        raise ModelError(
            f"model {self.model.name!r}: "
            + (f"there is no input {name!r}" if name else "the input is not named")
            + f" (inputs: {', '.join(names) or 'none'})",
            usually="A transfer function leads from one input, and the model has several or none.",
            paste=f"invariances(model, response='frequency', input={(names or ['u'])[0]!r})",
            read=READ,
        )


def equations(model: Model, output: str | sp.Expr | None, *, angle: bool) -> Equations:
    """A model's equations for one output.

    Parameters
    ----------
    model : Model
    output : name of an output or state, or a formula in the model's quantities; None: the first output.
    angle : whether the radian is a base dimension.

    Raises
    ------
    ModelError    no such output, or the model is not homogeneous where angles count.
    """
    if angle and (found := mismatches_of(model, angle=True)):
        where, parts = next(iter(found.items()))
        raise ModelError(
            f"model {model.name!r}: with angles as a dimension, {where} is not homogeneous: {parts[0]}",
            usually="The model takes a ratio (of speeds, of lengths) for an angle, or sin(x) for x;"
            " then the radian is no unit that may be changed.",
            paste="invariances(model)   # angles are pure numbers",
            read='docs/model.md, "Angles"',
        )
    name, formula, measure = _output(model, output, angle)
    return Equations(model, name, formula, measure, angle)


def _output(model: Model, output: str | sp.Expr | None, angle: bool) -> tuple[str, sp.Expr, Measure]:
    named = {q.name: (model.output_map[q.name], q) for q in model.outputs}
    named |= {q.name: (q.symbol, q) for q in model.states if q.name not in named}
    if output is None and named:
        output = next(iter(named))
    if isinstance(output, str) and output in named:
        formula, quantity = named[output]
        return output, formula, quantity.measure(angle=angle)
    if output is None or (isinstance(output, str) and output.isidentifier()):
        raise ModelError(
            f"model {model.name!r} has no output {output!r}"
            f" (outputs and states: {', '.join(named) or 'none'})",
            usually="The name was misspelt.",
            paste=f"invariances(model, output={next(iter(named), 'x')!r})",
            read=READ,
        )
    symbols = {
        q.symbol: (q.measure(angle=angle), q.unit)
        for kind in (model.states, model.inputs, model.parameters)
        for q in kind
    }
    formula = read_formula(output, [s.name for s in symbols], what="the output")
    measure = measure_of_expression(formula, symbols) if formula.free_symbols <= symbols.keys() else None
    if measure is None:
        raise ModelError(
            f"model {model.name!r}: the output {sp.sstr(formula)} has no unit",
            usually="Its terms differ in units, it is zero, or it holds a name that is not declared.",
            paste=f"invariances(model, output={next(iter(named), 'x')!r})",
            read=READ,
        )
    return sp.sstr(formula), formula, measure
