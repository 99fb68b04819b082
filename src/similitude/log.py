"""A driving log in SI units, checked once; every later stage may trust it.

Invariant: a `Log` has rising finite time, at least 20 rows and 2 s, values that can be in the
unit their header claimed, and float64 columns of one length with NaN, never inf, where a cell is
missing. No value was changed, filled in or converted by guess.

    t time [s];  delta road wheel angle [rad];  r yaw rate [rad/s];  U speed [m/s];
    ay lateral acceleration [m/s^2]
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import numpy as np

from similitude.errors import LogError, shown
from similitude.log_checks import check_column, check_time
from similitude.log_columns import Column, choose_columns
from similitude.log_plausibility import check_against_steer, check_units, speed_warnings
from similitude.readers import open_table
from similitude.vehicle_file import Vehicle

_NOTHING: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class Log:
    """One drive.

    Parameters
    ----------
    name : str                   stem of the file
    path : Path                  the file
    t : (n,) float64             time, strictly rising, as in the file [s]
    delta : (n,) float64         road wheel angle [rad]
    r : (n,) float64             yaw rate [rad/s]
    U : (n,) float64             speed, may be zero or negative [m/s]
    ay : (n,) float64 or None    lateral acceleration [m/s^2]
    sources : dict of str to str column -> where it comes from, such as
                                 ``"steering_wheel [deg] / 15.3"``
    warnings : tuple of str      what is odd about the log
    """

    name: str
    path: Path
    t: np.ndarray
    delta: np.ndarray
    r: np.ndarray
    U: np.ndarray
    ay: np.ndarray | None
    sources: dict[str, str]
    warnings: tuple[str, ...] = ()

    @property
    def samples(self) -> int:
        """Number of rows [-]."""
        return int(self.t.size)

    @property
    def duration(self) -> float:
        """Time from the first row to the last [s]."""
        return float(self.t[-1] - self.t[0])

    @property
    def rate(self) -> float:
        """Rows a second, from the median step of time [Hz]."""
        return float(1.0 / np.median(np.diff(self.t)))


# Damaged bytes give numbers near 1e308 and signalling NaNs; what becomes of them is judged below.
@np.errstate(over="ignore", invalid="ignore")
def read_log(
    path: str | Path,
    *,
    vehicle: Vehicle | None = None,
    mapping: Mapping[str, str] = _NOTHING,
) -> Log:
    """Read a CSV or Parquet log and check it.

    Parameters
    ----------
    path : str or Path    columns ``t``, ``delta`` or ``steering_wheel``, ``r``, ``U`` and
                          optionally ``ay`` (or their aliases), each as ``name [unit]``
    vehicle : Vehicle     needed for ``steering_wheel`` (its `steering_ratio`); its wheelbase
                          lets the yaw rate be compared with the steer
    mapping : mapping     quantity -> column, where names differ: ``{"delta": "SWA"}``

    Returns
    -------
    Log

    Raises
    ------
    LogError    the file cannot be read, a column is missing or doubled, or its values cannot be
    UnitError   a used column has no unit, an unknown one, or one of the wrong dimension
    UsageError  `mapping` names no quantity
    """
    path = Path(path)
    table = open_table(path)
    columns = choose_columns(table.headers, file=path.name, mapping=mapping)
    loaded = table.load([column.position for column in columns.values()])
    values = {
        name: _in_si(raw, column) for (name, column), raw in zip(columns.items(), loaded.columns, strict=True)
    }
    warnings = [*table.warnings, *loaded.warnings]
    time = columns["t"]
    warnings += check_time(values["t"], header=time.header, factor=time.unit.factor, file=path.name)
    for name in [name for name in values if name not in ("t", "ay")]:
        header = columns[name].header
        warnings += check_column(values[name], header=header, file=path.name, may_rest=name == "U")
    warnings += _drop_useless_ay(values, columns, path.name)
    check_units(values, columns, file=path.name)
    warnings += speed_warnings(values["U"])
    sources = {name: _source(column) for name, column in columns.items() if name in values}
    if "steering_wheel" in values:
        ratio = _steering_ratio(columns["steering_wheel"], vehicle, path.name)
        values["delta"] = values.pop("steering_wheel") / ratio
        sources["delta"] = f"{sources.pop('steering_wheel')} / {ratio:.6g}"
    if vehicle is not None and vehicle.L is not None:
        warnings += check_against_steer(values, columns, wheelbase=vehicle.L.value, file=path.name)
    return Log(
        name=path.stem,
        path=path,
        t=values["t"],
        delta=values["delta"],
        r=values["r"],
        U=values["U"],
        ay=values.get("ay"),
        sources=sources,
        warnings=tuple(warnings),
    )


def _in_si(raw: np.ndarray, column: Column) -> np.ndarray:
    values = raw * column.unit.factor
    values[~np.isfinite(values)] = np.nan
    return values


def _drop_useless_ay(
    values: dict[str, np.ndarray], columns: Mapping[str, Column], file: str
) -> tuple[str, ...]:
    # The only optional column: a bad one is left out and said, instead of refusing the log.
    if "ay" not in values:
        return ()
    try:
        return check_column(values["ay"], header=columns["ay"].header, file=file, may_rest=False)
    except LogError as error:
        del values["ay"]
        return (f"{error.what}; lateral acceleration is not used",)


def _steering_ratio(column: Column, vehicle: Vehicle | None, file: str) -> float:
    if vehicle is not None and vehicle.steering_ratio is not None:
        return vehicle.steering_ratio.value
    lacks = "no vehicle file is given" if vehicle is None else "the vehicle file states none"
    raise LogError(
        f"column {shown(column.header)} of {file} is the angle of the steering wheel; the steering "
        f"ratio is needed, and {lacks}",
        usually="the line is still missing in the vehicle file; 12 to 20 on a car.",
        paste="steering_ratio = 15.3",
        read='docs/vehicle.md, "The vehicle file"',
    )


def _source(column: Column) -> str:
    return f"{column.header} (--map)" if column.mapped else column.header
