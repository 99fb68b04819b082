"""Model: a physical system as states, inputs, outputs and parameters with units, and its rates.

Invariant: every quantity carries a unit, every symbol of every rate is declared, and each
constraint gives one parameter in terms of the others.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy as sp

from similitude.errors import ModelError
from similitude.units import Dimension, parse_unit


@dataclass(frozen=True)
class Quantity:
    """A named quantity with its unit; ``meaning`` is what a comment beside it says."""

    name: str
    unit: str
    meaning: str = ""

    @property
    def symbol(self) -> sp.Symbol:
        """The symbol that stands for it in rates and outputs."""
        return sp.Symbol(self.name, real=True)

    @property
    def dimension(self) -> Dimension:
        """Exact exponents over the base dimensions."""
        return parse_unit(self.unit).dimension


@dataclass(frozen=True)
class Model:
    """A system ``x' = f(x, u; p)``, ``y = g(x, u; p)`` with units.

    Parameters
    ----------
    name : short name, a C identifier.
    states, inputs, outputs, parameters : the quantities; the order is kept everywhere.
    rates : state name -> d(state)/dt as a SymPy expression, [unit of the state / s].
    output_map : output name -> SymPy expression, [unit of the output].
    constraints : parameter name -> expression in other parameters that it always equals.
    signals : parameters that are measured along with the inputs and may change (a car's speed).
    validity : expression and limit (same unit) inside which the model is meant to hold.
    source : where the equations stand.

    Raises
    ------
    ModelError    a state has no rate, a symbol is not declared, or a name is used twice.
    """

    name: str
    states: tuple[Quantity, ...]
    inputs: tuple[Quantity, ...]
    outputs: tuple[Quantity, ...]
    parameters: tuple[Quantity, ...]
    rates: Mapping[str, sp.Expr]
    output_map: Mapping[str, sp.Expr]
    constraints: Mapping[str, sp.Expr] = field(default_factory=dict)
    signals: tuple[str, ...] = ()
    validity: tuple[sp.Expr, Quantity] | None = None
    source: str = ""

    def __post_init__(self) -> None:
        names = [q.name for q in self.quantities]
        twice = sorted({n for n in names if names.count(n) > 1})
        if twice:
            raise self._error(
                f"{', '.join(twice)} is declared more than once",
                "A state and a parameter were given the same letter.",
                f"Quantity('{twice[0]}_0', ...)   # one name, one quantity",
            )
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
                    "A parameter is missing from the list, or its symbol was made without real=True.",
                    f"parameters=(..., Quantity('{unknown[0]}', 'unit', 'meaning'))",
                )

    def _error(self, what: str, usually: str, paste: str) -> ModelError:
        return ModelError(
            f"model {self.name!r}: {what}",
            usually=usually,
            paste=paste,
            read="docs/architecture.md, 'Model'",
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
