"""Everything that is to be said about a log, whether or not it can be used.

Invariant: a fault of the file never raises here; it becomes a `Finding`, and what could be read all
the same stays in `values`. Nothing is changed unless its repair was asked for by name.

    t time [s];  delta road wheel angle [rad];  r yaw rate [rad/s];  U speed [m/s];
    ay lateral acceleration [m/s^2]
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

import numpy as np

from similitude.errors import LogError, shown
from similitude.finding import Finding, refusal
from similitude.log_cells import check_column
from similitude.log_columns import Column, choose_columns, column_of
from similitude.log_fixes import apply_fixes, check_fixes
from similitude.log_plausibility import check_speed, check_turns, check_units
from similitude.log_response import check_response
from similitude.log_sensors import check_sensors
from similitude.log_speed import check_speed_signal
from similitude.log_time import FEWEST_ROWS, check_time
from similitude.readers import Table, open_table
from similitude.signal_faults.overflow import check_overflow
from similitude.signal_faults.time_scale import check_time_scale
from similitude.vehicle_file import Vehicle

THIS_LOG = re.compile(r"(?<![A-Z_])LOG\.csv")  # in a line to paste
NOTHING: Mapping[str, str] = MappingProxyType({})
# repair -> the fault of a cell that it makes a missing one
BLANKED = {"blank_text": "text_in_cell", "keep_longest_part": "header_again"}


@dataclass(frozen=True, eq=False)
class Survey:
    """A log and all that is odd about it.

    Parameters
    ----------
    name : str                        stem of the file
    path : Path                       the file
    headers : tuple of str            every column, as written
    columns : dict of str to Column   quantity -> chosen column, with its header and unit
    values : dict of str to array     "t", "delta", "r", "U", "ay" (n,) float64 in SI, NaN where
                                      missing; only what could be had, and "steering_wheel" [rad]
                                      where its ratio is not known
    sources : dict of str to str      as in `Log`
    findings : tuple of Finding       certain and likely, in the order in which they were met
    fixes : tuple of str              what was changed, for each repair asked for
    """

    name: str
    path: Path
    headers: tuple[str, ...]
    columns: dict[str, Column]
    values: dict[str, np.ndarray]
    sources: dict[str, str]
    findings: tuple[Finding, ...]
    fixes: tuple[str, ...] = ()

    @property
    def certain(self) -> tuple[Finding, ...]:
        """Findings that refuse the log."""
        return tuple(finding for finding in self.findings if finding.certain)

    @property
    def likely(self) -> tuple[Finding, ...]:
        """Findings that become warnings."""
        return tuple(finding for finding in self.findings if not finding.certain)


# Damaged bytes give numbers near 1e308 and signalling NaNs; what becomes of them is judged below.
@np.errstate(over="ignore", invalid="ignore")
def survey(
    path: str | Path,
    *,
    vehicle: Vehicle | None = None,
    mapping: Mapping[str, str] = NOTHING,
    fixes: Sequence[str] = (),
) -> Survey:
    """Look a log over, as far as it can be read.

    Parameters
    ----------
    path : str or Path         a CSV or Parquet log
    vehicle : Vehicle          its `steering_ratio` and wheelbase tell more faults
    mapping : mapping          quantity -> column, where names differ: ``{"delta": "SWA"}``
    fixes : sequence of str    names of repairs to make; see docs/logs.md

    Returns
    -------
    Survey

    Raises
    ------
    UsageError   `mapping` names no quantity, or `fixes` no repair
    """
    path = Path(path)
    wanted = check_fixes(fixes)
    findings: list[Finding] = []
    headers: tuple[str, ...] = ()
    columns: dict[str, Column] = {}
    values: dict[str, np.ndarray] = {}
    try:
        table = open_table(path, as_meant=True)
    except LogError as error:
        return Survey(path.stem, path, headers, columns, values, {}, (refusal(error),))
    findings += table.findings
    columns, doubts = choose_columns(table.headers, file=path.name, mapping=mapping, is_clock=table.is_clock)
    findings += doubts
    values, met = _load(table, columns, {BLANKED[name] for name in wanted if name in BLANKED})
    findings += met
    turned = check_turns(values, columns, file=path.name)
    if "unwrap_overflow" not in wanted:
        turned = check_overflow(values, columns, file=path.name) | turned
    findings += turned.values()
    values = {name: column for name, column in values.items() if name not in turned}
    sources = {name: _source(column) for name, column in columns.items()}
    findings += _divide_steering_wheel(values, sources, columns, vehicle, path.name)
    values, changed = apply_fixes(wanted, values, columns, findings)
    length = None if vehicle is None or vehicle.L is None else vehicle.L.value
    findings += _check(values, columns, path.name, length)
    for name in columns.keys() - values.keys():
        sources.pop(name, None)
    named = shlex.quote(str(path))
    findings = [replace(one, paste=THIS_LOG.sub(lambda _: named, one.paste)) for one in findings]
    return Survey(path.stem, path, table.headers, columns, values, sources, tuple(findings), changed)


def _load(
    table: Table, columns: Mapping[str, Column], blanked: set[str]
) -> tuple[dict[str, np.ndarray], list[Finding]]:
    """SI values of the chosen columns, as far as they can be had, and what was met."""
    positions = [column.position for column in columns.values()]
    met: list[Finding] = []
    try:
        loaded = table.load(positions, blanked=blanked)
        met += loaded.findings
    except LogError as error:
        fixes = [name for name, fault in BLANKED.items() if error.paste == f"--fix {name}"]
        met.append(refusal(error, fix=fixes[0] if fixes else None))
        try:
            loaded = table.load(positions, blanked=BLANKED.values())
        except LogError:
            return {}, met
    values = {
        name: _in_si(raw, column) for (name, column), raw in zip(columns.items(), loaded.columns, strict=True)
    }
    return values, met


def _in_si(raw: np.ndarray, column: Column) -> np.ndarray:
    values = raw * column.unit.factor
    values[~np.isfinite(values)] = np.nan
    return values


def _source(column: Column) -> str:
    return f"{column.header} (--map)" if column.mapped else column.header


def _divide_steering_wheel(
    values: dict[str, np.ndarray],
    sources: dict[str, str],
    columns: Mapping[str, Column],
    vehicle: Vehicle | None,
    file: str,
) -> list[Finding]:
    """Put the road wheel's angle in place of the steering wheel's, where the ratio is known."""
    if "steering_wheel" not in columns:
        return []
    if vehicle is None or vehicle.steering_ratio is None:
        header = columns["steering_wheel"].header
        lacks = "no vehicle file is given" if vehicle is None else "the vehicle file states none"
        return [Finding(
            "no_steering_ratio", True,
            f"column {shown(header)} of {file} is the angle of the steering wheel; the steering "
            f"ratio is needed, and {lacks}",
            "the line is still missing in the vehicle file; 12 to 20 on a car.",
            "steering_ratio = 15.3", 'docs/vehicle.md, "The vehicle file"', column=header,
        )]  # fmt: skip
    ratio = vehicle.steering_ratio.value
    sources["delta"] = f"{sources.pop('steering_wheel')} / {ratio:.6g}"
    if "steering_wheel" in values:
        values["delta"] = values.pop("steering_wheel") / ratio
    return []


def _check(
    values: dict[str, np.ndarray], columns: Mapping[str, Column], file: str, wheelbase: float | None
) -> list[Finding]:
    findings: list[Finding] = []
    if "t" in values:
        time = columns["t"]
        findings += check_time(values["t"], header=time.header, factor=time.unit.factor, file=file)
    in_order = "t" in values and not any(one.certain for one in findings)
    if any(column.size < FEWEST_ROWS for column in values.values()):
        return findings
    if {"t", "delta", "r"} <= values.keys() and all(one.fault == "too_short" for one in findings):
        findings = check_time_scale(values, columns, file=file) + findings
    silent = set()
    for name in [name for name in values if name != "t"]:
        met = _check_column(name, values, columns, file)
        silent |= {name} if any(one.certain for one in met) or name not in values else set()
        findings += met
    units = check_units(values, columns, file=file)
    side = columns["ay"].header if "ay" in values else ""
    of_side = [one for one in units if side and one.column == side]
    units = [one for one in units if one not in of_side]
    findings += [*units, *(_without_ay(one, values) for one in of_side)]
    sound = {name: column for name, column in values.items() if name not in silent}
    if "U" in sound:
        findings += check_speed(sound["U"], header=columns["U"].header)
    if in_order:
        findings += check_sensors(sound, columns)
        if "U" in sound:
            findings += check_speed_signal(sound, columns, wheelbase=wheelbase)
        if {"delta", "r", "U"} <= sound.keys() and not units:
            findings += check_response(sound, columns, wheelbase=wheelbase, file=file)
    return findings


def _check_column(
    name: str, values: dict[str, np.ndarray], columns: Mapping[str, Column], file: str
) -> list[Finding]:
    held = name in ("delta", "steering_wheel", "U")
    header = column_of(name, columns).header
    met = check_column(values[name], header=header, file=file, may_rest=name == "U", held=held)
    if name == "ay" and any(one.certain for one in met):
        return [_without_ay(one, values) for one in met]
    return met


def _without_ay(finding: Finding, values: dict[str, np.ndarray]) -> Finding:
    """The only optional column: a bad one is left out and said, instead of refusing the log."""
    values.pop("ay", None)
    return replace(finding, certain=False, what=f"{finding.what}; ay is not used")
