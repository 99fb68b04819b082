"""Equations: rates with the names they may use, checked, before anything is asked of them.

Invariant: every name has one role (time, state, signal, parameter, result), every symbol is declared and
is `Symbol(name, real=True)`, as in a Model.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from numbers import Real

import sympy as sp

from similitude.errors import ModelError, shown
from similitude.model import Model
from similitude.model_text import parse_expression
from similitude.model_text_faults import no_text, unknown_name

READ = 'docs/symmetries.md, "The call"'


@dataclass(frozen=True)
class Equations:
    """States' rates over time, states, signals and parameters.

    ``relations`` are names that equal an expression at all times: outputs and constraints of a Model.
    """

    time: str
    states: tuple[str, ...]
    signals: tuple[str, ...]
    parameters: tuple[str, ...]
    rates: Mapping[str, sp.Expr]
    relations: Mapping[str, sp.Expr] = field(default_factory=dict)

    @property
    def results(self) -> tuple[str, ...]:
        """Names that only a relation defines: outputs that are no states."""
        others = {self.time, *self.states, *self.signals, *self.parameters}
        return tuple(name for name in self.relations if name not in others)

    @property
    def names(self) -> tuple[str, ...]:
        """Every name that may be scaled: time where it has a part, states, signals, parameters, results."""
        symbols = {s.name for e in self.relations.values() for s in e.free_symbols}
        time = (self.time,) if self.states or self.time in symbols else ()
        return (*time, *self.states, *self.signals, *self.parameters, *self.results)


def read_equations(
    rates: Mapping[str, str | sp.Expr], parameters: Sequence[str], *, signals: Sequence[str], time: str
) -> Equations:
    """Check names and read the rates, as `scaling_symmetries` describes them.

    Raises
    ------
    ModelError    a name without a role or with two, no rate at all, or a rate that cannot be read.
    """
    for argument, given in (("parameters", parameters), ("signals", signals)):
        if isinstance(given, str):
            raise _fault(
                f"{argument} is the text {shown(given)}, not a list of names",
                "Names were written in one text.",
                f"{argument}={given.replace(',', ' ').split()!r}",
            )
        if not isinstance(given, Iterable):
            raise _fault(
                f"{argument} is {shown(given)}, not a list of names",
                "There are none, and an empty list was meant.",
                f"{argument}=[]",
            )
    if not isinstance(rates, Mapping) or not rates:
        raise _fault(
            f"rates is {shown(rates)}, which gives no state a rate",
            "A list of equations was given, or an empty one.",
            "rates={'x': '-k*x'}",
        )
    rates = {_name(name): rate for name, rate in rates.items()}
    parameters, signals, time = [*map(_name, parameters)], [*map(_name, signals)], _name(time)
    roles = [("time", [time]), ("state", rates), ("signal", signals), ("parameter", parameters)]
    _check_names(roles)
    names = [name for _, of_role in roles for name in of_role]
    return Equations(
        time=time,
        states=tuple(rates),
        signals=tuple(signals),
        parameters=tuple(parameters),
        rates={name: _read(rate, names, f"the rate of {name!r}") for name, rate in rates.items()},
    )


def equations_of(model: Model, *, time: str = "t") -> Equations:
    """The equations of a Model, outputs and constraints included; `time` gets a free name."""
    taken = {q.name for q in model.quantities}
    while time in taken:
        time += "_"
    outputs = {name: sp.sympify(e) for name, e in model.output_map.items() if name not in model.rates}
    return Equations(
        time=time,
        states=tuple(q.name for q in model.states),
        signals=tuple(q.name for q in model.inputs),
        parameters=tuple(q.name for q in model.parameters),
        rates={name: sp.sympify(rate) for name, rate in model.rates.items()},
        relations=outputs | {name: sp.sympify(e) for name, e in model.constraints.items()},
    )


def _name(given: object) -> object:
    """A name, also where its symbol or its function of time was given."""
    if isinstance(given, sp.core.function.AppliedUndef):
        return given.func.__name__
    return given.name if isinstance(given, sp.Symbol) else given


def _check_names(roles: list[tuple[str, Sequence[str]]]) -> None:
    seen: dict[str, str] = {}
    for role, names in roles:
        for name in names:
            if not isinstance(name, str) or not name.isidentifier():
                raise _fault(
                    f"the {role} {shown(name)} is no name",
                    "A name has letters, digits and underscores and starts with a letter.",
                    f"{''.join(c if c.isalnum() else '_' for c in str(name)).strip('_') or 'x'!r}",
                )
            if name in seen:
                raise _fault(
                    f"{name!r} is a {seen[name]} and a {role}"
                    if seen[name] != role
                    else f"the {role} {name!r} is given twice",
                    "Two quantities were given the same letter.",
                    f"time='tau'   # the quantity {name!r} keeps its name"
                    if "time" in (role, seen[name])
                    else f"{name}_0",
                )
            seen[name] = role


def _read(rate: object, names: Sequence[str], what: str) -> sp.Expr:
    if isinstance(rate, str):
        return parse_expression(rate, names, what=what)
    if isinstance(rate, Real) and not isinstance(rate, bool) and math.isfinite(rate):
        return sp.Rational(str(rate))
    if not isinstance(rate, sp.Expr):
        raise no_text(what, rate)
    functions = {f: sp.Symbol(f.func.__name__, real=True) for f in rate.atoms(sp.core.function.AppliedUndef)}
    plain = rate.xreplace({f: s for f, s in functions.items() if s.name in names})
    for symbol in sorted(plain.free_symbols, key=str):
        if symbol.name not in names:
            raise unknown_name(what, sp.sstr(rate), symbol.name, names)
    return plain.xreplace({s: sp.Symbol(s.name, real=True) for s in plain.free_symbols})


def _fault(what: str, usually: str, paste: str) -> ModelError:
    return ModelError(what, usually=usually, paste=paste, read=READ)
