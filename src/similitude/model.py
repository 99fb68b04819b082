"""Model: a physical system as states, inputs, outputs and parameters with units, and its rates.

Invariant: every quantity carries a unit, every symbol of every rate is declared, each constraint gives
one parameter in terms of the others, and every formula is homogeneous in its units.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy as sp

from similitude.errors import ModelError, UnitError, shown
from similitude.homogeneity.measure import Measure, measure_of
from similitude.homogeneity.walk import Mismatch, mismatches
from similitude.model_formulas import Formulas, read_formula, read_formulas
from similitude.units import Dimension, parse_quantity, parse_unit

READ = 'docs/model.md, "Quantities"'


@dataclass(frozen=True)
class Quantity:
    """A named quantity with its unit.

    Parameters
    ----------
    name : how formulas call it: a letter, then letters, digits and underscores.
    unit : such as ``"N/rad"``; ``"1"`` for a pure number.
    meaning : what a comment beside it says.
    known : its value where it is known beforehand, with a unit: ``"9.81 m/s^2"``.

    Raises
    ------
    ModelError    the name is none that a formula can hold.
    UnitError     a unit cannot be read, or the known value's is of another dimension.
    """

    name: str
    unit: str
    meaning: str = ""
    known: str = ""

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name.isidentifier():
            raise ModelError(
                f"{shown(self.name)} is no name a formula can hold",
                usually="A blank, a dot or a dash was used; names are made of letters, digits and _.",
                paste="Quantity('k_1', 'N/m', 'stiffness of the first spring')",
                read=READ,
            )
        if not isinstance(self.unit, str) or not isinstance(self.known, str):
            raise UnitError(
                f"quantity {self.name!r}: the unit is {self.unit!r} and the known value {self.known!r}",
                usually="A number was given where text with a unit is wanted.",
                paste=f"Quantity({self.name!r}, 'm/s^2', known='9.81 m/s^2')",
                read=READ,
            )
        try:
            dimension = parse_unit(self.unit).dimension
            if self.known:
                parse_quantity(self.known, expect=dimension)
        except UnitError as error:
            raise UnitError(
                f"quantity {self.name!r}: {error.what}",
                usually=error.usually,
                paste=f"Quantity({self.name!r}, {self.unit!r}, known='{error.paste}')"
                if self.known
                else f"Quantity({self.name!r}, '{error.paste}')",
                read=error.read,
            ) from None

    @property
    def symbol(self) -> sp.Symbol:
        """The symbol that stands for it in rates and outputs."""
        return sp.Symbol(self.name, real=True)

    @property
    def dimension(self) -> Dimension:
        """Exact exponents over the base dimensions."""
        return parse_unit(self.unit).dimension

    @property
    def value(self) -> float | None:
        """The known value in SI, None where it is not known."""
        return parse_quantity(self.known, expect=self.dimension)[0] if self.known else None

    def measure(self, *, angle: bool = False) -> Measure:
        """Its dimension, with the power of the radian where ``angle`` says that angles count."""
        return measure_of(parse_unit(self.unit), angle=angle)


@dataclass(frozen=True)
class Model:
    """A system ``x' = f(x, u; p)``, ``y = g(x, u; p)`` with units.

    A formula is text, a SymPy expression or a number. All formulas are checked to be homogeneous, angles
    counting as pure numbers; `mismatches_of` checks with the radian as a dimension of its own.

    Parameters
    ----------
    name : short name, a C identifier.
    states, inputs, outputs, parameters : the quantities; the order is kept everywhere.
    rates : state name -> d(state)/dt, [unit of the state / unit of time]; or a function of (states,
        inputs, parameters) that returns them.
    output_map : output name -> formula, [unit of the output]; or a function likewise. Left out: every
        output is a state.
    constraints : parameter name -> formula in other parameters that it always equals.
    signals : parameters that are measured along with the inputs and may change (a car's speed).
    validity : formula and limit (same unit) inside which the model is meant to hold.
    source : where the equations stand.
    time_unit : what time is in: "s", or "1" for a model in dimensionless time.

    Raises
    ------
    ModelError    a state has no rate, a symbol is not declared, a name is used twice, a formula cannot be
                  read, or two terms of one differ in units.
    """

    name: str
    states: tuple[Quantity, ...]
    inputs: tuple[Quantity, ...]
    outputs: tuple[Quantity, ...]
    parameters: tuple[Quantity, ...]
    rates: Mapping[str, sp.Expr] | Formulas
    output_map: Mapping[str, sp.Expr] | Formulas | None = None
    constraints: Mapping[str, sp.Expr] = field(default_factory=dict)
    signals: tuple[str, ...] = ()
    validity: tuple[sp.Expr, Quantity] | None = None
    source: str = ""
    time_unit: str = "s"

    def __post_init__(self) -> None:
        for kind in ("states", "inputs", "outputs", "parameters", "signals"):
            object.__setattr__(self, kind, tuple(getattr(self, kind)))
        self._check_names()
        self._read_formulas()
        for kind, owners, given in (
            ("rate", self.states, self.rates),
            ("output expression", self.outputs, self.output_map),
        ):
            wrong = sorted({q.name for q in owners} ^ set(given))
            if wrong:
                raise self._error(
                    f"{kind}s and declarations differ in {', '.join(wrong)}",
                    f"Each declared name needs exactly one {kind}.",
                    f"{kind.split()[0]}s={{'{wrong[0]}': ...}}",
                )
        known = {q.symbol for q in self.quantities}
        given = (self.rates, self.output_map, self.constraints)  # a state may be an output too
        for where, expression in (pair for mapping in given for pair in mapping.items()):
            unknown = sorted(s.name for s in sp.sympify(expression).free_symbols - known)
            if unknown:
                raise self._error(
                    f"the expression of {where!r} uses {', '.join(unknown)}, which is not declared",
                    "A parameter is missing from the list.",
                    f"parameters=(..., Quantity('{unknown[0]}', 'unit', 'meaning'))",
                )
        self._check_homogeneity()

    def _check_names(self) -> None:
        names = [q.name for q in self.quantities]
        twice = sorted({n for n in names if names.count(n) > 1})
        if twice:
            raise self._error(
                f"{', '.join(twice)} is declared more than once",
                "A state and a parameter were given the same letter.",
                f"Quantity('{twice[0]}_0', ...)   # one name, one quantity",
            )
        parameters = {q.name for q in self.parameters}
        for kind, given in (("signal", self.signals), ("constrained", self.constraints)):
            strange = [name for name in given if name not in parameters]
            if strange:
                raise self._error(
                    f"{strange[0]!r} is listed as {kind}, but is no parameter"
                    f" (parameters: {', '.join(q.name for q in self.parameters) or 'none'})",
                    "Only parameters can be measured signals or follow from other parameters.",
                    f"parameters=(..., Quantity('{strange[0]}', 'unit', 'meaning'))",
                )

    def _read_formulas(self) -> None:
        states, inputs, outputs, parameters = (
            [q.name for q in kind] for kind in (self.states, self.inputs, self.outputs, self.parameters)
        )
        declared = {"states": states, "inputs": inputs, "parameters": parameters}
        names = [*states, *inputs, *parameters]
        rates = read_formulas(self.rates, what="rate", owners=states, **declared)
        given = self.output_map
        if given is None:
            given = {name: sp.Symbol(name, real=True) for name in outputs if name in states}
        output_map = read_formulas(given, what="output", owners=outputs, **declared)
        constraints = {
            name: read_formula(f, names, what=f"the constraint on {name!r}")
            for name, f in self.constraints.items()
        }
        object.__setattr__(self, "rates", rates)
        object.__setattr__(self, "output_map", output_map)
        object.__setattr__(self, "constraints", constraints)
        if self.validity is not None:
            formula = read_formula(self.validity[0], names, what="the validity")
            object.__setattr__(self, "validity", (formula, self.validity[1]))

    def _check_homogeneity(self) -> None:
        found = [
            f"{where} is not homogeneous: {one}"
            for where, parts in mismatches_of(self).items()
            for one in parts
        ]
        if found:
            more = f" (and {len(found) - 1} more: {'; '.join(found[1:4])})" if len(found) > 1 else ""
            raise ModelError(
                f"model {self.name!r}: {found[0]}{more}",
                usually="A factor was forgotten, a quantity's unit is wrong, or a number in a formula"
                " carries a unit: declare it, with its value as known.",
                paste="Quantity('g', 'm/s^2', 'gravity', known='9.81 m/s^2')",
                read='docs/model.md, "Homogeneity"',
            )

    def _error(self, what: str, usually: str, paste: str) -> ModelError:
        return ModelError(
            f"model {self.name!r}: {what}",
            usually=usually,
            paste=paste,
            read=READ,
        )

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """States, inputs, outputs that are not states, and parameters."""
        states = {q.name for q in self.states}
        outputs = tuple(q for q in self.outputs if q.name not in states)
        return (*self.states, *self.inputs, *outputs, *self.parameters)

    def quantity(self, name: str) -> Quantity:
        """The quantity of that name.

        Raises
        ------
        ModelError    no quantity has that name.
        """
        for quantity in self.quantities:
            if quantity.name == name:
                return quantity
        raise self._error(
            f"there is no quantity {name!r} (there are {', '.join(q.name for q in self.quantities)})",
            "The name was misspelt.",
            f"model.quantity({self.quantities[0].name!r})",
        )


def mismatches_of(model: Model, *, angle: bool = False) -> dict[str, tuple[Mismatch, ...]]:
    """Every part of a model's formulas whose unit does not fit.

    Parameters
    ----------
    model : Model
    angle : whether the radian is a base dimension of its own. A model that takes sin(x) for x, or an angle
        for a ratio of speeds, is then not homogeneous; the parts that say so are named.

    Returns
    -------
    dict    "the rate of 'v'", "the output 'r'", ... -> its mismatches; only formulas that have any.
    """
    symbols = {q.symbol: (q.measure(angle=angle), q.unit) for q in model.quantities}
    time = measure_of(parse_unit(model.time_unit), angle=angle)
    formulas = [
        (f"the rate of {q.name!r}", model.rates[q.name], q.measure(angle=angle) / time) for q in model.states
    ]
    formulas += [
        (f"the output {q.name!r}", model.output_map[q.name], q.measure(angle=angle)) for q in model.outputs
    ]
    formulas += [
        (f"the constraint on {name!r}", e, model.quantity(name).measure(angle=angle))
        for name, e in model.constraints.items()
    ]
    if model.validity is not None:
        formulas.append(("the validity", model.validity[0], model.validity[1].measure(angle=angle)))
    found = {where: mismatches(e, symbols, wanted, where) for where, e, wanted in formulas}
    return {where: parts for where, parts in found.items() if parts}
