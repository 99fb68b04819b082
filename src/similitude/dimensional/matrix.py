"""DimensionMatrix: named variables and their dimensions, one exact column each.

Invariant: the columns stand in the order in which the variables were given, names differ, and every
unit has been read; what cannot be read is named with its variable.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from similitude.dimensional.exact_span import Column, Span, leading
from similitude.errors import ModelError, UnitError, shown
from similitude.units import Dimension, Unit, parse_unit

READ = 'docs/groups.md, "Variables and units"'
ROWS = ("mass", "length", "time", "current", "temperature", "amount", "luminosity")
SYMBOLS = ("kg", "m", "s", "A", "K", "mol", "cd", "rad")


@dataclass(frozen=True)
class DimensionMatrix:
    """Columns of exact exponents [-], one a variable.

    Parameters
    ----------
    names : (n,) names, all different.
    columns : (n,) columns of d exponents over ``rows``.
    rows : (d,) names of the base dimensions; the last is "angle" where radians are one.
    """

    names: tuple[str, ...]
    columns: tuple[Column, ...]
    rows: tuple[str, ...]

    @cached_property
    def leading(self) -> tuple[tuple[int, ...], Span]:
        """Places of the first independent columns, and what all columns span."""
        return leading(self.columns, len(self.rows))

    @property
    def rank(self) -> int:
        """Number of independent dimensions among the variables."""
        return self.leading[1].rank

    def column(self, name: str) -> Column:
        """The column of a variable of that name, which must exist."""
        return self.columns[self.names.index(name)]

    def text(self, name: str) -> str:
        """The dimension of a variable in SI symbols, such as ``kg m s^-2``; ``-`` for none."""
        return column_text(self.column(name))


def column_text(column: Column) -> str:
    """A column in SI symbols, such as ``kg m s^-2``; ``-`` where all exponents are zero."""
    parts = [
        symbol if x == 1 else f"{symbol}^{x if x.denominator == 1 else f'({x})'}"
        for symbol, x in zip(SYMBOLS, column, strict=False)
        if x
    ]
    return " ".join(parts) or "-"


def dimension_matrix(variables: Mapping[str, str | Unit | Dimension], *, angle: bool) -> DimensionMatrix:
    """Read the units of variables.

    Parameters
    ----------
    variables : name -> unit as text (``"kg/m^3"``, ``"1"``), or a Unit or Dimension already read.
    angle : whether the radian is a base dimension of its own; a Dimension holds no angle.

    Returns
    -------
    DimensionMatrix   (7, n), or (8, n) with angles.

    Raises
    ------
    UnitError     a unit is no text, or cannot be read; the variable is named.
    ModelError    ``variables`` is no mapping, or a name is no text.
    """
    if not isinstance(variables, Mapping):
        raise ModelError(
            f"variables are a {type(variables).__name__}, not a mapping from names to units",
            usually="a list was passed, or the units were left out.",
            paste='pi_groups({"F": "N", "rho": "kg/m^3", "V": "m/s", "D": "m"})',
            read=READ,
        )
    columns = tuple(_column(name, unit, angle) for name, unit in variables.items())
    return DimensionMatrix(tuple(variables), columns, (*ROWS, "angle") if angle else ROWS)


def _column(name: object, unit: object, angle: bool) -> Column:
    if not isinstance(name, str) or not name.strip():
        raise ModelError(
            f"{name!r} is no name of a variable",
            usually="names are text; a symbol of SymPy has one: str(symbol).",
            paste='pi_groups({"F": "N", ...})',
            read=READ,
        )
    if isinstance(unit, Dimension):
        return _plain((*unit.powers, Fraction(0)) if angle else unit.powers)
    read = unit if isinstance(unit, Unit) else _unit(name, unit)
    return _plain((*read.dimension.powers, read.angle) if angle else read.dimension.powers)


def _plain(powers: tuple[Fraction, ...]) -> Column:
    """Whole numbers as int: columns are compared and hashed, which fractions are slow at."""
    return tuple(x.numerator if x.denominator == 1 else x for x in powers)


def _unit(name: str, unit: object) -> Unit:
    if not isinstance(unit, str) or not unit.strip():
        raise UnitError(
            f"variable {shown(name)} has {unit!r} for a unit, which is no unit's text",
            usually="a value was passed where its unit belongs, or there is none, which is written '1'.",
            paste=f'{{"{name}": "1"}}',
            read=READ,
        )
    try:
        return parse_unit(unit)
    except UnitError as error:
        raise UnitError(
            f"variable {shown(name)}: {error.what}",
            usually=error.usually,
            paste=f'{{"{name}": "{error.paste}"}}',
            read=error.read,
        ) from None
