"""System: a Model with all that makes it usable by others: a base, values with their source, a run.

Invariant: every parameter has a value of its own unit's dimension or is given by a constraint, and base,
start, inputs and table name what the model has.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from similitude.errors import ModelError, UnitError, shown
from similitude.groups import Groups, reparameterize
from similitude.model import Model, Quantity
from similitude.units import parse_quantity, parse_unit

READ = 'docs/systems.md, "The parts of a system"'


@dataclass(frozen=True)
class System:
    """A model, its base and one instance of it that can be simulated.

    Parameters
    ----------
    model : Model.
    base : repeating variables, parameters of the model.
    values : parameter -> ``"0.01 kg m^2"``; one that a constraint gives, or whose value the model knows,
        may be left out.
    source : where the values stand.
    inputs : input -> value held from time zero, ``"24 V"``; zero where left out.
    start : state -> value at time zero; zero where left out.
    duration : how long a run takes, ``"2 s"``.
    meanings : parameter -> what its group tells, in words.
    table : name of another instance -> parameter -> value, where a source lists several.

    Raises
    ------
    ModelError    a name is not the model's, or a parameter has no value.
    UnitError     a value cannot be read, or its unit is of another dimension than its quantity's.
    """

    model: Model
    base: tuple[str, ...]
    values: Mapping[str, str]
    source: str
    duration: str
    inputs: Mapping[str, str] = field(default_factory=dict)
    start: Mapping[str, str] = field(default_factory=dict)
    meanings: Mapping[str, str] = field(default_factory=dict)
    table: Mapping[str, Mapping[str, str]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if isinstance(self.base, str):
            raise self._error(
                f"base is the text {shown(self.base)}, not several names",
                "a base of one name lacks its comma.",
                f"base=({self.base!r},)",
            )
        object.__setattr__(self, "base", tuple(self.base))
        parameters = {q.name for q in self.model.parameters}
        rows = {f"row {name!r} of the table": row for name, row in self.table.items()}
        for what, names, known in (
            ("base", self.base, parameters),
            ("values", self.values, parameters),
            ("inputs", self.inputs, {q.name for q in self.model.inputs}),
            ("start", self.start, {q.name for q in self.model.states}),
            ("meanings", self.meanings, parameters - set(self.base)),
            *((what, row, parameters) for what, row in rows.items()),
        ):
            strange = [name for name in names if name not in known]
            if strange:
                raise self._error(
                    f"{what} names {shown(strange[0])}; there are {', '.join(sorted(known)) or 'none'}",
                    "a name was misspelt, or put into the wrong part.",
                    f"{what}={{{min(known, default='...')!r}: ...}}",
                )
        known = {q.name for q in self.model.parameters if q.known}
        missing = parameters - set(self.values) - set(self.model.constraints) - known
        if missing:
            name = next(q.name for q in self.model.parameters if q.name in missing)
            raise self._error(
                f"parameter {name!r} [{self.model.quantity(name).unit}] has no value",
                "it was added to the model later, or only scales and was forgotten.",
                f"values={{..., {name!r}: '1 {self.model.quantity(name).unit}'}}",
            )
        for values in (self.values, self.inputs, self.start, *rows.values()):
            for name, text in values.items():
                self._number(self.model.quantity(name), text)
        _ = self.span

    def _error(self, what: str, usually: str, paste: str) -> ModelError:
        return ModelError(f"system {self.model.name!r}: {what}", usually=usually, paste=paste, read=READ)

    def _number(self, quantity: Quantity, text: str) -> float:
        return self._read(f"{quantity.name} [{quantity.unit}]", text, quantity.unit)

    def _read(self, what: str, text: str, unit: str) -> float:
        where = f"system {self.model.name!r}, {what}"
        if not isinstance(text, str):
            raise UnitError(
                f"{where}: the value is {text!r}, which is no text",
                usually="a bare number was given; a value is text with its unit.",
                paste=f"'{text} {unit}'",
                read=READ,
            )
        try:
            return parse_quantity(text, expect=parse_unit(unit).dimension)[0]
        except UnitError as error:
            raise UnitError(
                f"{where}: {error.what}",
                usually=error.usually,
                paste=f"'1 {unit}'",
                read=error.read,
            ) from None

    @property
    def name(self) -> str:
        """The model's name."""
        return self.model.name

    @property
    def span(self) -> float:
        """Duration of a run [the model's unit of time in SI]."""
        return self._read("duration", self.duration, self.model.time_unit)

    def numbers(self, row: str | None = None) -> dict[str, float]:
        """Every parameter in SI, in the model's order.

        Parameters
        ----------
        row : name of an instance of the table, whose values stand in place of the nominal ones.
        """
        texts = {**self.values, **(self.table[row] if row is not None else {})}
        read = {q.name: q.value for q in self.model.parameters if q.known}
        read |= {name: self._number(self.model.quantity(name), text) for name, text in texts.items()}
        known = {self.model.quantity(name).symbol: value for name, value in read.items()}
        for name, expression in self.model.constraints.items():
            if name not in read:
                read[name] = float(expression.subs(known))
        return {q.name: read[q.name] for q in self.model.parameters}

    def held_inputs(self) -> dict[str, float]:
        """Every input in SI, as it is held during a run."""
        return {q.name: self._number(q, self.inputs[q.name]) if q.name in self.inputs else 0.0
                for q in self.model.inputs}  # fmt: skip

    def starting_states(self) -> dict[str, float]:
        """Every state in SI at time zero."""
        return {q.name: self._number(q, self.start[q.name]) if q.name in self.start else 0.0
                for q in self.model.states}  # fmt: skip

    def groups(self) -> Groups:
        """The model rewritten with the system's base.

        Raises
        ------
        ModelError    the base does not span, or a rate is not homogeneous.
        """
        return reparameterize(self.model, base=self.base)
