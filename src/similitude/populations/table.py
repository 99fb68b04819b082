"""A table of similar systems: what is known of each, in SI, with gaps, weights, sds and sources.

    value   (n, c) SI, NaN where nobody knows     sd  (n, c) of the value, NaN where nobody stated it
    column  a product of powers of the model's parameters, such as a*b

Invariant: every known value is positive and finite, every column has the dimension of its product,
and no row is dropped: a row that knows one thing is worth one thing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.errors import LogError, UnitError, UsageError, shown
from similitude.model import Model
from similitude.populations.monomial import monomial_text, read_monomial
from similitude.populations.text_columns import read_words
from similitude.readers import open_table
from similitude.units import Dimension, parse_unit

READ = 'docs/populations.md, "The table"'
WORDS = ("source", "name", "vehicle", "system", "make", "model", "brand", "platform", "body")


@dataclass(frozen=True, eq=False)
class PopulationTable:
    """Rows of known values.

    Parameters
    ----------
    name : str                     of the file
    model : Model                  whose parameters the columns are products of
    products : tuple of mappings   (c,) parameter -> exponent
    value, sd : (n, c)             SI and NaN, as above
    weight : (n,)                  1 for a system that counts once
    labels, sources : (n,)         what each row is, and where it was found
    unused : tuple of str          columns of the file that name no product of parameters
    stratum : (n,) or None         which table a row is of, where several were joined: their systems may
                                   differ in size, and share the distribution of their groups
    """

    name: str
    model: Model
    products: tuple[Mapping[str, Fraction], ...]
    value: NDArray[np.float64]
    sd: NDArray[np.float64]
    weight: NDArray[np.float64]
    labels: tuple[str, ...]
    sources: tuple[str, ...]
    unused: tuple[str, ...] = ()
    stratum: NDArray[np.int64] | None = None

    def __len__(self) -> int:
        return len(self.weight)

    @property
    def names(self) -> tuple[str, ...]:
        """The columns as text, ``a b`` for a product."""
        return tuple(monomial_text(p) for p in self.products)

    def rows(self, chosen: NDArray) -> PopulationTable:
        """The same table with the chosen rows, by index, repeated where asked twice."""
        index = np.arange(len(self))[chosen]
        return replace(
            self, value=self.value[index], sd=self.sd[index], weight=self.weight[index],
            labels=tuple(self.labels[i] for i in index), sources=tuple(self.sources[i] for i in index),
            stratum=None if self.stratum is None else self.stratum[index],
        )  # fmt: skip


def read_population_table(
    path: str | Path, model: Model, *, columns: Mapping[str, str] | None = None
) -> PopulationTable:
    """Read a table of systems.

    Parameters
    ----------
    path : CSV or Parquet file, headers ``name [unit]``; ``sd_<name> [unit]`` is the standard
        deviation of a value, ``weight [-]`` that of a row, ``source`` says where a row was found.
    model : Model               whose parameters the columns are.
    columns : product of parameters -> name of the column that holds it (``{"a*b": "ab"}``); columns
        named like a parameter, or like a product of parameters, are found by themselves.

    Returns
    -------
    PopulationTable

    Raises
    ------
    LogError, UnitError         the file is no table, a unit is missing or of another dimension.
    UsageError                  no column is known, a value is not positive, a weight is negative.
    """
    path = Path(path)
    table = open_table(path)
    bare = [header.split("[")[0].strip() for header in table.headers]
    known = [q.name for q in model.parameters]
    places = _places(path, bare, known, columns or {}, model)
    sds = {i: bare.index(f"sd_{bare[i]}") for i in places if f"sd_{bare[i]}" in bare}
    weights = [bare.index("weight")] if "weight" in bare else []
    asked = [*places, *sds.values(), *weights]
    loaded = dict(zip(asked, table.load(asked).columns, strict=True))
    n = len(loaded[asked[0]])
    factor = {i: _factor(path, table.headers[i], dimension_of(model, p)) for i, p in places.items()}
    factor_sd = {i: _factor(path, table.headers[j], dimension_of(model, places[i])) for i, j in sds.items()}
    words = [h for h, b in zip(table.headers, bare, strict=True) if b.lower() in WORDS and b not in known]
    said = {h.split("[")[0].strip().lower(): w[:n] for h, w in read_words(path, words).items()}
    empty = np.full(n, np.nan)
    used = {*asked, *(table.headers.index(h) for h in words)}
    result = PopulationTable(
        name=path.name,
        model=model,
        products=tuple(places.values()),
        value=np.column_stack([loaded[i] * factor[i] for i in places]),
        sd=np.column_stack([loaded[sds[i]] * factor_sd[i] if i in sds else empty for i in places]),
        weight=loaded[weights[0]] if weights else np.ones(n),
        labels=tuple(_label(said, i) for i in range(n)),
        sources=tuple(said["source"][i] if "source" in said else path.name for i in range(n)),
        unused=tuple(h for i, h in enumerate(table.headers) if i not in used),
    )
    return check_population_table(result)


def check_population_table(table: PopulationTable) -> PopulationTable:
    """Return the table if its values can be what they claim, or say which cannot."""
    for j, name in enumerate(table.names):
        wrong = np.flatnonzero(table.value[:, j] <= 0)
        if wrong.size or np.isinf(table.value[:, j]).any():
            row = int(wrong[0]) if wrong.size else int(np.flatnonzero(np.isinf(table.value[:, j]))[0])
            raise UsageError(
                f"{table.name}, data row {row + 1} ({table.labels[row]}): {name} = {table.value[row, j]:.6g} "
                "in SI is not a positive number, and only such have a logarithm",
                usually="zero stands for a value nobody knows; leave the cell empty.",
                paste=",,",
                read=READ,
            )
    if not (np.isfinite(table.weight).all() and (table.weight >= 0).all() and table.weight.sum() > 0):
        row = int(np.argmin(np.where(np.isfinite(table.weight), table.weight, -np.inf)))
        raise UsageError(
            f"{table.name}, data row {row + 1} ({table.labels[row]}): weight = {table.weight[row]:.6g}",
            usually="a weight is a number from 0 up; 1 is a system that counts once.",
            paste="1.0",
            read=READ,
        )
    return table


def joined(tables: Sequence[PopulationTable], *, name: str) -> PopulationTable:
    """All rows of several tables of one model, columns of equal products in one column."""
    keys: dict[tuple, Mapping[str, Fraction]] = {}
    for table in tables:
        keys |= {_key(p): p for p in table.products}
    value, sd = [], []
    for table in tables:
        at = {_key(p): j for j, p in enumerate(table.products)}
        for block, source in ((value, table.value), (sd, table.sd)):
            empty = np.full(len(table), np.nan)
            block.append(np.column_stack([source[:, at[k]] if k in at else empty for k in keys]))
    return PopulationTable(
        name, tables[0].model, tuple(keys.values()), np.vstack(value), np.vstack(sd),
        np.concatenate([t.weight for t in tables]),
        tuple(label for t in tables for label in t.labels),
        tuple(source for t in tables for source in t.sources),
        stratum=_strata(tables),
    )  # fmt: skip


def _strata(tables: Sequence[PopulationTable]) -> NDArray[np.int64]:
    parts, first = [], 0
    for table in tables:
        own = np.zeros(len(table), dtype=np.int64) if table.stratum is None else table.stratum
        parts.append(own + first)
        first += int(own.max(initial=0)) + 1
    return np.concatenate(parts)


def dimension_of(model: Model, product: Mapping[str, Fraction]) -> Dimension:
    """Dimension of a product of powers of the model's parameters."""
    total = Dimension.none
    for name, power in product.items():
        total = total * model.quantity(name).dimension ** power
    return total


def _key(product: Mapping[str, Fraction]) -> tuple:
    return tuple(sorted(product.items()))


def _places(
    path: Path, bare: Sequence[str], known: Sequence[str], columns: Mapping[str, str], model: Model
) -> dict[int, dict[str, Fraction]]:
    """Column position -> product, columns that were named first."""
    places: dict[int, dict[str, Fraction]] = {}
    for text, column in columns.items():
        product = read_monomial(text, known)
        if column in bare:
            places.setdefault(bare.index(column), product)
    for i, name in enumerate(bare):
        if i not in places and name in known and name not in model.signals:
            places[i] = {name: Fraction(1)}
        elif i not in places and any(sign in name for sign in "*/^"):
            try:
                places[i] = read_monomial(name, known)
            except UsageError:
                continue
    if not places:
        raise UsageError(
            f"{path.name} has no column of a parameter of {model.name!r} "
            f"(columns: {', '.join(map(shown, bare))}; parameters: {', '.join(known)})",
            usually="the columns have other names; name them one by one.",
            paste=f"--map {known[0]}={bare[0] or 'column'}",
            read=READ,
        )
    return places


def _factor(path: Path, header: str, dimension: Dimension) -> float:
    """SI per unit of a column; the unit stands in square brackets behind its name."""
    name, bracket, rest = header.partition("[")
    unit = rest.partition("]")[0].strip()
    if not bracket or not unit:
        if dimension == Dimension.none:
            return 1.0
        raise LogError(
            f"column {shown(header)} of {path.name} has no unit",
            usually="SI was meant; write it in square brackets, so that nobody has to guess.",
            paste=f"{name.strip()} [{dimension}]",
            read=READ,
            fault="no_unit",
        )
    try:
        return parse_unit(unit, expect=dimension).factor
    except UnitError as error:
        raise UnitError(
            f"column {shown(header)} of {path.name}: {error.what}",
            usually=error.usually,
            paste=f"{name.strip()} [{error.paste}]",
            read=READ,
        ) from None


def _label(said: Mapping[str, Sequence[str]], row: int) -> str:
    words = [said[key][row] for key in WORDS[1:] if key in said and said[key][row]]
    return " ".join(words) or f"row {row + 1}"
