"""Rows for an estimator's step from a log: a file with units in its headers, or arrays in SI.

Invariant: rows are (dt, input, signals, measured) in SI; a missing value stays missing and the step says so.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from similitude.errors import LogError, UnitError, shown
from similitude.model import Model
from similitude.units import parse_unit

READ = 'docs/estimator.md, "The log"'


@dataclass(frozen=True, eq=False)
class LogColumns:
    """``t`` (n,) [s], and ``rows`` (n, 3 + signals) for the step [SI]."""

    t: NDArray[np.float64]
    rows: NDArray[np.float64]


def read_columns(log: str | Path | Mapping[str, ArrayLike], model: Model, *, step: float) -> LogColumns:
    """Read what an estimator needs.

    Parameters
    ----------
    log : file, or name -> (n,) values [SI].
    model : Model    with one input and one output.
    step : time between rows where the log has no ``t`` [s].

    Raises
    ------
    LogError         a column is missing, without a unit, or of another length.
    """
    u, y = model.inputs[0].name, model.outputs[0].name
    names = [u, *model.signals, y]
    if isinstance(log, str | Path):
        found = _of_file(Path(log), names, model)
    else:
        found = {n: np.asarray(v, dtype=float) for n, v in log.items() if n in (*names, "t")}
    missing = [n for n in names if n not in found]
    if missing:
        q = model.quantity(missing[0])
        there = str(log) if isinstance(log, str | Path) else ", ".join(map(str, log))
        raise LogError(
            f"the log has no column {q.name!r} [{q.unit}] (log: {there or 'empty'})",
            usually="the column has another name; an estimator takes the names of its model.",
            paste=f"{q.name} [{q.unit}]",
            read=READ,
        )
    lengths = {n: np.shape(v) for n, v in found.items()}
    if len(set(lengths.values())) > 1 or any(len(s) != 1 for s in lengths.values()):
        raise LogError(
            "the log's columns have shapes " + ", ".join(f"{n} {s}" for n, s in lengths.items()),
            usually="one of them was cut, or has a second dimension.",
            paste=f"log = {{{u!r}: u[:n], {y!r}: y[:n]}}",
            read=READ,
        )
    if len(found[u]) < 2:
        raise LogError(
            f"the log has {len(found[u])} rows",
            usually="the recording was cut, or only a header was written.",
            paste=f"log = {{{u!r}: [...], {y!r}: [...]}}",
            read=READ,
        )
    t = found.get("t", step * np.arange(len(found[u])))
    first = np.median(np.diff(t)) if len(t) > 1 else step
    dt = np.diff(t, prepend=t[:1] - first)
    return LogColumns(t, np.column_stack([dt, *(found[n] for n in names)]))


def _of_file(path: Path, names: Sequence[str], model: Model) -> dict[str, NDArray]:
    from similitude.readers import open_table

    table = open_table(path)
    wanted = {"t": model.time_unit, **{n: model.quantity(n).unit for n in names}}
    places, factors = {}, {}
    for i, header in enumerate(table.headers):
        name, bracket, rest = (part.strip() for part in header.partition("["))
        if name not in wanted or name in places:
            continue
        places[name] = i
        factors[name] = _factor(path, header, name, wanted[name], rest.partition("]")[0] if bracket else "")
    loaded = table.load(list(places.values())).columns
    return {n: column * factors[n] for (n, _), column in zip(places.items(), loaded, strict=True)}


def _factor(path: Path, header: str, name: str, unit: str, written: str) -> float:
    dimension = parse_unit(unit).dimension
    if not written:
        if unit == "1":
            return 1.0
        raise LogError(
            f"column {shown(header)} of {path.name} has no unit",
            usually="SI was meant; write it in square brackets, so that nobody has to guess.",
            paste=f"{name} [{unit}]",
            read=READ,
            fault="no_unit",
        )
    try:
        return parse_unit(written.strip(), expect=dimension).factor
    except UnitError as error:
        raise UnitError(
            f"column {shown(header)} of {path.name}: {error.what}",
            usually=error.usually,
            paste=f"{name} [{unit}]",
            read=READ,
        ) from None
