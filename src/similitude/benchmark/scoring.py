"""One answer against the truth of its drive.

error      ln(estimate/truth) of K
judged     the last 20 s before the change and the last 20 s of the drive
covered    rows after 10 s whose 95 % interval holds the truth
half-way   from the change to the first row on the other side of half-way in ln K
found      from the change to the first alarm of the estimator's own; false is an alarm that no change
           of the truth came before within 30 s
steps      ln K against ln K of 10 s earlier: the test that every estimator is given alike (`detection`)
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.benchmark.cells import CHANGE_AT
from similitude.benchmark.drives import Drive, Truth
from similitude.benchmark.entrant import IDENTIFIED_STD, Answer

Array = NDArray[np.float64]
SETTLING, JUDGED, WAIT = 10.0, 20.0, 30.0  # s
CHANGE = 0.05  # of ln K, from which a step of the truth is a change
REFERENCE = 10.0  # s back, for the test of steps
WRONG = 2 * IDENTIFIED_STD  # of ln K: identified and off by more is wrong
THRESHOLDS = np.geomspace(0.02, 2.0, 60)  # of ln K, for the test of steps
Z95 = 1.959964


@dataclass(frozen=True, eq=False)
class Score:
    """How one answer did; times in s, errors of ln K, NaN or inf where there is none.

    Parameters
    ----------
    fault : str              why it diverged, empty where it did not
    rms, bias : float        of the error in the judged windows [-]
    coverage : float         share of rows [-]
    half_way, found : float  delays [s], inf where never; NaN without a change
    false : int              false alarms of its own
    hours : float            driven in which an alarm would be false [h]
    identified, wrong : bool
    largest : float          greatest fall of `steps` before the change [-]
    late : (60,)             delay of `steps` at each of `THRESHOLDS` [s]
    seconds : float          the call [s];  rows : int;  operations, step_seconds as in Answer
    """

    fault: str
    rms: float = math.nan
    bias: float = math.nan
    coverage: float = math.nan
    half_way: float = math.nan
    found: float = math.nan
    false: int = 0
    hours: float = 0.0
    identified: bool = False
    wrong: bool = False
    largest: float = math.nan
    late: Array | None = None
    seconds: float = math.nan
    rows: int = 0
    operations: int | None = None
    step_seconds: float | None = None


def score(drive: Drive, truth: Truth, answer: Answer, *, seconds: float) -> Score:
    """Score an answer.

    Parameters
    ----------
    drive : Drive      n rows; the truth may have more, those after a drive that was cut
    truth : Truth
    answer : Answer
    seconds : float    that the estimator took [s]
    """
    t, n = drive.t, drive.t.size
    K = truth.K[:n]
    fault = unfit(answer, n)
    if fault:
        return Score(fault, seconds=seconds, rows=n)
    estimate, sd = (np.broadcast_to(np.asarray(x, float), n) for x in (answer.K, answer.ln_K_std))
    error = np.log(estimate / K)
    windows = ((t >= CHANGE_AT - JUDGED) & (t < CHANGE_AT)) | (t > t[-1] - JUDGED)
    covered = np.abs(error) <= Z95 * sd
    known = sd[-1] <= IDENTIFIED_STD if answer.identified is None else answer.identified
    changes = t[1:][np.abs(np.diff(np.log(K))) > CHANGE]
    false = [a for a in answer.alarms if not ((changes <= a) & (a <= changes + WAIT)).any()]
    largest, late = steps(t, np.log(estimate), changes)
    return Score(
        "",
        rms=float(np.sqrt(np.mean(error[windows] ** 2))),
        bias=float(np.mean(error[windows])),
        coverage=float(np.mean(covered[t > SETTLING])),
        half_way=_half_way(t, estimate, K, changes),
        found=_found(answer, changes),
        false=len(false),
        hours=float((changes[0] if changes.size else t[-1]) / 3600),
        identified=bool(known),
        wrong=bool(known and abs(error[-1]) > WRONG),
        largest=largest,
        late=late,
        seconds=seconds,
        rows=n,
        operations=answer.operations,
        step_seconds=answer.step_seconds,
    )


def unfit(answer: object, n: int) -> str:
    """Return what is wrong with an answer to a drive of n rows, empty where nothing is."""
    if not isinstance(answer, Answer):
        return f"estimate(drive) returned {type(answer).__name__}, not an Answer"
    for name in ("K", "ln_K_std"):
        try:
            value = np.broadcast_to(np.asarray(getattr(answer, name), float), n)
        except (TypeError, ValueError):
            return f"{name} has not one number a row, or one for all"
        if not np.isfinite(value).all() or (value <= 0).any():
            return f"{name} is not finite and positive in every row"
    return ""


def steps(t: Array, ln_K: Array, changes: Array) -> tuple[float, Array | None]:
    """Return the greatest fall against 10 s earlier before any change, and delays at `THRESHOLDS`.

    Parameters
    ----------
    t, ln_K : (n,)   time [s], logarithm of the estimate [-]
    changes : (k,)   of the truth [s]
    """
    back = np.searchsorted(t, t - REFERENCE)
    fall = ln_K[back] - ln_K
    sound = (t > t[0] + SETTLING + REFERENCE) & (t < (changes[0] if changes.size else np.inf))
    largest = float(fall[sound].max()) if sound.any() else math.nan
    if not changes.size:
        return largest, None
    after = (t >= changes[0]) & (t <= changes[0] + WAIT)
    highest = np.maximum.accumulate(fall[after])
    at = np.searchsorted(highest, THRESHOLDS)
    delays = np.append(t[after] - changes[0], np.inf)
    return largest, delays[at] if highest.size else None


def _half_way(t: Array, estimate: Array, K: Array, changes: Array) -> float:
    if not changes.size:
        return math.nan
    k = int(np.searchsorted(t, changes[0]))
    middle, falls = math.sqrt(K[k - 1] * K[k]), K[k] < K[k - 1]
    past = (estimate[k:] <= middle) if falls else (estimate[k:] >= middle)
    return float(t[k + np.argmax(past)] - t[k]) if past.any() else math.inf


def _found(answer: Answer, changes: Array) -> float:
    if not changes.size:
        return math.nan
    hits = [a - changes[0] for a in answer.alarms if changes[0] <= a <= changes[0] + WAIT]
    return float(min(hits, default=math.inf))
