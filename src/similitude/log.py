"""A driving log in SI units, checked once; every later stage may trust it.

Invariant: a `Log` has rising finite time, at least 20 rows and 2 s, values that can be in the
unit their header claimed, and float64 columns of one length with NaN, never inf, where a cell is
missing. No value was changed, filled in or converted unless a repair was asked for by name.

    t time [s];  delta road wheel angle [rad];  r yaw rate [rad/s];  U speed [m/s];
    ay lateral acceleration [m/s^2]
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from similitude.finding import Finding
from similitude.log_survey import NOTHING, survey
from similitude.vehicle_file import Vehicle


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
    warnings : tuple of str      what is odd about the log, in words
    findings : tuple of Finding  the same with row, column and number
    fixes : tuple of str         what was changed, for each repair asked for
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
    findings: tuple[Finding, ...] = ()
    fixes: tuple[str, ...] = ()

    @property
    def samples(self) -> int:
        """Number of rows [-]."""
        return int(self.t.size)

    @property
    def duration(self) -> float:
        """Time from the first row to the last [s]."""
        return float(self.t[-1] - self.t[0])

    @cached_property
    def steps(self) -> np.ndarray:
        """Time from each row to the next, (n - 1,) [s]."""
        return np.diff(self.t)

    @cached_property
    def usual_step(self) -> float:
        """Their median [s]; asked for in every pass over the log."""
        return float(np.median(self.steps))

    @property
    def rate(self) -> float:
        """Rows a second, from the median step of time [Hz]."""
        return 1.0 / self.usual_step


def read_log(
    path: str | Path,
    *,
    vehicle: Vehicle | None = None,
    mapping: Mapping[str, str] = NOTHING,
    fixes: Sequence[str] = (),
) -> Log:
    """Read a CSV or Parquet log and check it.

    Parameters
    ----------
    path : str or Path         columns ``t``, ``delta`` or ``steering_wheel``, ``r``, ``U`` and
                               optionally ``ay`` (or their aliases), each as ``name [unit]``
    vehicle : Vehicle          needed for ``steering_wheel`` (its `steering_ratio`); its wheelbase
                               lets the yaw rate be compared with the steer
    mapping : mapping          quantity -> column, where names differ: ``{"delta": "SWA"}``
    fixes : sequence of str    repairs to make, by name; docs/logs.md lists them

    Returns
    -------
    Log

    Raises
    ------
    LogError    the first certain fault that `survey` finds
    UnitError   a used column has no unit, an unknown one, or one of the wrong dimension
    UsageError  `mapping` names no quantity, or `fixes` no repair
    """
    seen = survey(path, vehicle=vehicle, mapping=mapping, fixes=fixes)
    if seen.certain:
        raise seen.certain[0].error
    values = seen.values
    return Log(
        name=seen.name,
        path=seen.path,
        t=values["t"],
        delta=values["delta"],
        r=values["r"],
        U=values["U"],
        ay=values.get("ay"),
        sources=seen.sources,
        warnings=tuple(one.warning for one in seen.findings),
        findings=seen.findings,
        fixes=seen.fixes,
    )
