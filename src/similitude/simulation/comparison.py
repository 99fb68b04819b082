"""An estimate against the truth of the drive it was made from.

error     ln(estimate/truth) of K, at every row of the estimate
covered   whether the truth lies within K_lo and K_hi
half-way  after a change of the truth: when the estimate first is half-way to it (in K) and how
          long after the change
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from similitude.errors import LogError, UsageError
from similitude.simulation.recording_files import SUFFIXES

Array = NDArray[np.float64]
ESTIMATE = ("t [s]", "K [m^2/s^2]", "K_lo [m^2/s^2]", "K_hi [m^2/s^2]")
TRUTH = ("t [s]", "K [m^2/s^2]")
SETTLING = 10.0  # s that no estimator is asked about
CHANGE = 0.05  # of ln K, from which a step of the truth is a change
READ = 'docs/simulate.md, "Comparing with the truth"'


@dataclass(frozen=True)
class Change:
    """One step of the truth: when [s], from and to [m^2/s^2], delay to half-way [s] or None."""

    t: float
    before: float
    after: float
    half_way: float | None


@dataclass(frozen=True)
class Comparison:
    """How far an estimate of K was off.

    Parameters
    ----------
    rows : int           rows after the first 10 s [-]
    rms : float          root mean square of the error of ln K after 10 s [-]
    rms_end : float      the same over the last 20 s [-]
    bias_end : float     mean error of ln K over the last 20 s [-]
    coverage : float     share of rows after 10 s whose interval holds the truth [-]
    truth_end, estimate_end : float   K in the last row [m^2/s^2]
    changes : tuple of Change
    """

    rows: int
    rms: float
    rms_end: float
    bias_end: float
    coverage: float
    truth_end: float
    estimate_end: float
    changes: tuple[Change, ...]


def compare(estimate: str | Path, truth: str | Path) -> Comparison:
    """Compare an estimate with the truth.

    Parameters
    ----------
    estimate : path   ``estimate.parquet``, or the folder `identify` wrote it to
    truth : path      the truth that `simulate` wrote, CSV or Parquet

    Raises
    ------
    UsageError   a file is not there, or the two do not overlap in time
    LogError     a column is missing
    """
    path = Path(estimate)
    path = path / "estimate.parquet" if path.is_dir() else path
    found, real = _columns(path, ESTIMATE), _columns(Path(truth), TRUTH)
    t = found["t [s]"]
    if t[-1] <= max(real["t [s]"][0], t[0] + SETTLING) or t[0] > real["t [s]"][-1]:
        raise UsageError(
            f"the estimate ({t[0]:.4g} to {t[-1]:.4g} s) and the truth ({real['t [s]'][0]:.4g} to "
            f"{real['t [s]'][-1]:.4g} s) share no time after the first {SETTLING:g} s",
            usually="one of the two belongs to another drive.",
            paste="similitude compare similitude-out/drive drive_truth.csv",
            read=READ,
        )
    # The truth holds from its row to the next: no value in between is true.
    at = np.clip(np.searchsorted(real["t [s]"], t, side="right") - 1, 0, None)
    K = real["K [m^2/s^2]"][at]
    return _score(found, K)


def _score(found: dict[str, Array], K: Array) -> Comparison:
    t, estimate = found["t [s]"], found["K [m^2/s^2]"]
    error = np.log(estimate / K)
    inside = (found["K_lo [m^2/s^2]"] <= K) & (found["K_hi [m^2/s^2]"] >= K)
    late, end = t > t[0] + SETTLING, t > t[-1] - 20.0
    return Comparison(
        rows=int(np.count_nonzero(late)),
        rms=_rms(error[late]),
        rms_end=_rms(error[end]),
        bias_end=float(np.mean(error[end])),
        coverage=float(np.mean(inside[late])),
        truth_end=float(K[-1]),
        estimate_end=float(estimate[-1]),
        changes=tuple(_changes(t, estimate, K)),
    )


def _rms(error: Array) -> float:
    return float(np.sqrt(np.mean(np.square(error))))


def _changes(t: Array, estimate: Array, K: Array) -> list[Change]:
    steps = np.flatnonzero(np.abs(np.diff(np.log(K))) > CHANGE) + 1
    found = []
    for number, k in enumerate(steps):
        end = steps[number + 1] if number + 1 < steps.size else t.size
        middle = 0.5 * (K[k - 1] + K[k])
        past = estimate[k:end] <= middle if K[k] < K[k - 1] else estimate[k:end] >= middle
        delay = float(t[k + np.argmax(past)] - t[k]) if past.any() else None
        found.append(Change(float(t[k]), float(K[k - 1]), float(K[k]), delay))
    return found


def _columns(path: Path, names: tuple[str, ...]) -> dict[str, Array]:
    if not path.is_file() or path.suffix.lower() not in SUFFIXES:
        raise UsageError(
            f"'{path}' is no file that ends in .csv or .parquet",
            usually="the path is that of another folder; the estimate comes first, the truth second.",
            paste="similitude compare similitude-out/drive drive_truth.csv",
            read=READ,
        )
    from similitude.readers import open_table

    table = open_table(path)
    missing = [name for name in names if name not in table.headers]
    if missing:
        raise LogError(
            f"{path.name} has no column {missing[0]!r}",
            usually="estimate and truth were exchanged, or the log was given in place of its truth.",
            paste="similitude compare similitude-out/drive drive_truth.csv",
            read=READ,
        )
    loaded = table.load([table.headers.index(name) for name in names])
    return {name: np.asarray(column, float) for name, column in zip(names, loaded.columns, strict=True)}
