"""Inspection: everything there is to say about a log before an estimate, whether usable or not.

Invariant: a fault of the log never raises here; what could not be worked out is None, and ``missing``
says what it would take.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from similitude.errors import LogError
from similitude.finding import Finding
from similitude.inspection.channels import Channel, channel
from similitude.inspection.doubts import (
    find_coarse_steer,
    find_cut_steer,
    find_late_steer,
    find_other_axis,
    find_strange_car,
    find_wrong_scale,
)
from similitude.inspection.excitation import Window, excitation
from similitude.inspection.follow import Follow, follow, yaw_behind_steer
from similitude.inspection.prospects import Prospects, prospects
from similitude.inspection.signals import Signals, even_signals
from similitude.inspection.slow_relation import SlowRelation, slow_relation, usual_understeer
from similitude.inspection.timing import Timing, timing
from similitude.log import Log
from similitude.log_columns import column_of
from similitude.log_quantities import split_header
from similitude.log_sensors import straight_rows
from similitude.log_survey import NOTHING, Survey, survey
from similitude.readers import open_table
from similitude.vehicle_file import Vehicle


@dataclass(frozen=True, eq=False)
class Inspection:
    """What a look at a log shows.

    Parameters
    ----------
    survey : Survey             findings of the reader, and the signals in SI
    vehicle : Vehicle or None   as given
    channels : tuple            every column of the file, in its order
    clock : Timing or None      None without a time column
    signals : Signals or None   None where the clock does not rise
    behind_steer : Follow       of the yaw rate, else None
    behind_yaw : Follow         of the lateral acceleration behind r U, else None
    slow : SlowRelation         offset, bias, length; else None
    windows : tuple of Window   the drive in pieces of two seconds
    prospects : Prospects       what can be identified, else None
    missing : tuple of str      what could not be said for want of something, and what it would take
    findings : tuple            the survey's and those of `doubts`, certain ones first
    """

    survey: Survey
    vehicle: Vehicle | None
    channels: tuple[Channel, ...]
    clock: Timing | None
    signals: Signals | None
    behind_steer: Follow | None
    behind_yaw: Follow | None
    slow: SlowRelation | None
    windows: tuple[Window, ...]
    prospects: Prospects | None
    missing: tuple[str, ...]
    findings: tuple[Finding, ...]

    @property
    def steer(self) -> str:
        """Header of the steer column, empty where there is none."""
        columns = self.survey.columns
        name = next((name for name in ("delta", "steering_wheel") if name in columns), None)
        return columns[name].header if name else ""

    @property
    def ratio(self) -> tuple[float, float] | None:
        """Steering ratio, or 1 over the scale of a road-wheel steer, with its sd; needs a wheelbase."""
        known = self.slow is not None and self.slow.length is not None
        if not known or self.vehicle is None or self.vehicle.L is None:
            return None
        value = self.slow.length / self.vehicle.L.value
        return value, abs(value) * self.slow.length_std


def inspect_log(
    path: str | Path, *, vehicle: Vehicle | None = None, mapping: Mapping[str, str] = NOTHING
) -> Inspection:
    """Look a log over.

    Parameters
    ----------
    path : str or Path   any CSV or Parquet table
    vehicle : Vehicle    with it, what the drive can show is predicted
    mapping : mapping    quantity -> column, where names differ

    Raises
    ------
    LogError      there is no table to look at: no such file, or another kind of file
    UsageError    `mapping` names no quantity
    """
    table = open_table(Path(path), as_meant=True)
    seen = survey(path, vehicle=vehicle, mapping=mapping)
    clock = timing(seen.values["t"]) if "t" in seen.values else None
    filled = _filled_in(seen, clock)
    measured = {name: np.where(filled[name], np.nan, x) if name in filled else x
                for name, x in seen.values.items()}  # fmt: skip
    signals = even_signals(measured, clock)
    behind = yaw_behind_steer(signals) if signals else None
    slow = None
    if signals is not None:
        late = (behind and behind.lag) or 0.0
        slow = slow_relation(signals, lag=late, understeer=usual_understeer(vehicle))
    plan = _prospects(seen, vehicle)
    look = Inspection(
        survey=seen,
        vehicle=vehicle,
        channels=_channels(table, seen, filled),
        clock=clock,
        signals=signals,
        behind_steer=behind,
        behind_yaw=_behind_yaw(signals),
        slow=slow,
        windows=excitation(signals) if signals else (),
        prospects=plan,
        missing=_missing(seen, vehicle, clock, signals, plan),
        findings=(),
    )
    met = [*seen.findings, *_doubts(look)]
    return replace(look, findings=tuple(sorted(met, key=lambda one: not one.certain)))


def _filled_in(seen: Survey, clock: Timing | None) -> dict[str, np.ndarray]:
    """Rows (n,) of each signal that nobody measured: they lie on straight lines."""
    if clock is None or not clock.is_usable:
        return {}
    return {name: straight_rows(seen.values["t"], x) for name, x in seen.values.items() if name != "t"}


def _channels(table, seen: Survey, filled: Mapping[str, np.ndarray]) -> tuple[Channel, ...]:
    taken = {column.position: name for name, column in seen.columns.items()}
    found = []
    for position, header in enumerate(table.headers):
        quantity = taken.get(position)
        one = channel(
            _column(table, position),
            header=header,
            unit=split_header(header)[1],
            taken_for=quantity,
        )
        name = "delta" if quantity == "steering_wheel" and quantity not in filled else quantity
        share = float(np.mean(filled[name])) if name in filled and filled[name].size else 0.0
        found.append(replace(one, straight=share, noise=None if quantity == "t" else one.noise))
    return tuple(found)


@np.errstate(over="ignore", invalid="ignore")
def _column(table, position: int) -> np.ndarray:
    """Numbers of a column in the file's unit; all missing where it holds text."""
    try:
        return table.load([position], blanked=("text_in_cell", "header_again")).columns[0]
    except LogError:
        return np.full(1, np.nan)


def _behind_yaw(signals: Signals | None) -> Follow | None:
    if signals is None or signals.ay is None or signals.r is None or signals.U is None:
        return None
    return follow(signals.r * signals.U, signals.ay, signals.step)


def _prospects(seen: Survey, vehicle: Vehicle | None) -> Prospects | None:
    needed = {"t", "delta", "r", "U"}
    if vehicle is None or vehicle.L is None or seen.certain or not needed <= seen.values.keys():
        return None
    v = seen.values
    log = Log(seen.name, seen.path, v["t"], v["delta"], v["r"], v["U"], v.get("ay"), seen.sources)
    return prospects(log, vehicle)


def _missing(
    seen: Survey,
    vehicle: Vehicle | None,
    clock: Timing | None,
    signals: Signals | None,
    plan: Prospects | None,
) -> tuple[str, ...]:
    """What was left unsaid, and why."""
    lines = []
    if clock is not None and signals is None:
        lines.append("time does not rise, or is torn apart: relations between columns cannot be read")
    if vehicle is None or vehicle.L is None:
        lines.append(
            'a wheelbase (a vehicle file with one line, L = "2.69 m") would add: the steering ratio, '
            "the lag of the steering alone, and how well this log can show the tyres"
        )
    elif seen.certain:
        lines.append("what the log can show is predicted once the findings marked 'refuses' are mended")
    elif plan is None and {"t", "delta", "r", "U"} <= seen.values.keys():
        lines.append(
            "a C compiler (pip install 'similitude[cc]') would add how well this log can show the tyres"
        )
    return tuple(lines)


def _doubts(look: Inspection) -> list[Finding]:
    known = {finding.fault for finding in look.survey.findings}
    met = []
    steer = next((one for one in look.channels if one.taken_for in ("delta", "steering_wheel")), None)
    if steer is not None and "clipped" not in known:
        met += find_cut_steer(steer)
    if steer is not None and look.signals is not None and look.signals.steer is not None:
        unit = look.survey.columns[steer.taken_for].unit.factor
        met += find_coarse_steer(steer, float(np.nanstd(look.signals.steer)) / unit)
    if look.prospects is not None:
        met += find_late_steer(look.prospects, look.steer)
        met += find_strange_car(look.prospects, look.steer)
        met += look.prospects.odd_speed
    wheelbase = look.vehicle.L.value if look.vehicle and look.vehicle.L else None
    odd = any(one.fault == "steer_scale" for one in met)
    if look.slow is not None and wheelbase and not odd:
        met += find_wrong_scale(look.slow, wheelbase, look.steer, at_wheel=look.signals.at_wheel)
    if look.signals is not None and "ay" in look.survey.columns:
        met += find_other_axis(look.signals, look.behind_yaw, column_of("ay", look.survey.columns).header)
    return [one for one in met if one.fault not in known]
