"""Can this be the speed of the whole car, in m/s, of one drive?

Invariant: no value is changed.

    t time [s];  U speed [m/s];  r yaw rate [rad/s]
    U of one wheel is U - r T/2 or U + r T/2 with the track T [m]
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding
from similitude.log_columns import Column

LARGEST_BRAKING = 13.0  # m/s^2 for half a second; 1.3 g is beyond the tyres of a road car
LARGEST_DRIVE = 8.0  # m/s^2 over a second: 0 to 100 km/h in 3.5 s
LARGEST_TURN = 14.0  # m/s^2 over a second; yaw rate times speed swings further than the grip of tyres, 1 g
FAST = 70.0  # m/s; 252 km/h
SUSTAINED = 99.0  # percentile
WINDOW = 0.5  # s; over it the noise of a speed signal averages out and a car hardly changes
JUMP = 1.5  # m/s; more at once, and faster than `LARGEST_JUMP`, is another drive
LARGEST_JUMP = 40.0  # m/s^2
HALF_TRACKS = 0.35, 1.1  # m; of a car, and at model scale in proportion to the wheelbase
CAR_LENGTH = 2.7  # m; wheelbase that belongs to them
FOLLOWS = 0.6  # correlation of the change of U with that of r; a driver does not turn like that
BEYOND_CHANCE = 6.0  # sd of the slope

READ = 'docs/logs.md, "Faults of units and signs"'


def check_speed_signal(
    values: Mapping[str, np.ndarray], columns: Mapping[str, Column], *, wheelbase: float | None
) -> list[Finding]:
    """Judge the speed by its changes.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI: "t" rising, "U", and "r" where there is one
    columns : mapping of str to Column        where they come from
    wheelbase : float or None                 L [m], which scales the track

    Returns
    -------
    list of Finding   all likely: too fast or too lively for m/s, of one wheel, of two drives
    """
    t, speed, header = values["t"], values["U"], columns["U"].header
    found = [*_lively(t, speed, header), *_joined(t, speed, header)]
    if not found:
        found += _beyond_grip(t, speed, values.get("r", np.full(t.size, np.nan)), header)
    if "r" in values:
        found += _one_wheel(t, speed, values["r"], header, (wheelbase or CAR_LENGTH) / CAR_LENGTH)
    return found


def _lively(t: np.ndarray, speed: np.ndarray, header: str) -> list[Finding]:
    change = _change(t, speed)
    known = np.isfinite(change)
    if not known.any():
        return []
    liveliness = float(np.percentile(np.abs(change[known]), SUSTAINED)) / WINDOW
    fastest = float(np.nanpercentile(np.abs(speed), SUSTAINED))
    if liveliness <= LARGEST_BRAKING and fastest <= FAST:
        return []
    lively = liveliness > LARGEST_BRAKING
    what = (
        f"column {shown(header)} changes by {liveliness:.3g} m/s^2 for {WINDOW:g} s"
        if lively
        else f"column {shown(header)} reaches {fastest:.3g} m/s, {3.6 * fastest:.3g} km/h"
    )
    return [Finding(
        "speed_unit", False, what, "the speed is in km/h, or its signal jumps.", "--fix speed_is_kmh", READ,
        column=header, value=liveliness if lively else fastest, fix="speed_is_kmh",
    )]  # fmt: skip


def _beyond_grip(t: np.ndarray, speed: np.ndarray, rate: np.ndarray, header: str) -> list[Finding]:
    """Accelerations that last a second and that no road car has, forward or to the side."""
    forward = _means(t, speed)
    forward = np.abs(forward[4:]) - np.abs(forward[:-4])  # a second apart; braking may be harder
    side = _means(t, speed * rate)
    side = np.abs(side[:-2] + side[2:]) / 2  # of a second
    most = [float(np.nanmax(one)) if np.isfinite(one).any() else 0.0 for one in (forward, side)]
    if most[0] > LARGEST_DRIVE:
        what = f"column {shown(header)} rises by {most[0]:.3g} m/s^2 for 1 s, more than a road car can"
    elif most[1] > LARGEST_TURN:
        what = f"column {shown(header)} times yaw rate is {most[1]:.3g} m/s^2 for 1 s, more than tyres hold"
    else:
        return []
    return [Finding(
        "speed_unit", False, what, "the speed is in km/h, or the yaw rate in another unit.",
        "--fix speed_is_kmh", READ, column=header, value=max(most), fix="speed_is_kmh",
    )]  # fmt: skip


def _change(t: np.ndarray, signal: np.ndarray) -> np.ndarray:
    """Change of the mean over one window to that over the next, at every half window."""
    mean = _means(t, signal)
    return mean[2:] - mean[:-2]


def _means(t: np.ndarray, signal: np.ndarray) -> np.ndarray:
    """Mean over one window, at every half window; at least five, NaN where nothing is known."""
    at = ((t - t[0]) / (WINDOW / 2)).astype(int)
    if at[-1] > 4_000_000:
        return np.full(5, np.nan)
    known = np.isfinite(signal)
    count = np.bincount(at[known], minlength=at[-1] + 1)
    total = np.bincount(at[known], signal[known], minlength=at[-1] + 1)
    whole = np.minimum(count[1:], count[:-1]) > 0
    return (total[1:] + total[:-1]) / np.where(whole, count[1:] + count[:-1], np.nan)


def _joined(t: np.ndarray, speed: np.ndarray, header: str) -> list[Finding]:
    # Among the fresh values only: a slow signal that is held changes in steps.
    known = np.flatnonzero(np.isfinite(speed))
    fresh = known[np.r_[True, np.diff(speed[known]) != 0]] if known.size else known
    if fresh.size < 8:
        return []
    values, times = speed[fresh], t[fresh]
    step = np.diff(values)
    far = np.abs(step) > np.maximum(JUMP, LARGEST_JUMP * np.diff(times))
    for at in np.flatnonzero(far):
        before, after = values[max(0, at - 3) : at + 1], values[at + 1 : at + 5]
        if min(before.size, after.size) < 4:
            continue
        if abs(np.median(after) - np.median(before)) > 0.8 * abs(step[at]):
            row = int(fresh[at + 1]) + 1
            return [Finding(
                "drives_joined", False,
                f"column {shown(header)} jumps from {values[at]:.4g} to {values[at + 1]:.4g} m/s in data "
                f"row {row} (t = {times[at + 1]:.6g} s), and stays there",
                "two drives were joined; identify each by itself.",
                f"head -n {row} LOG.csv > first_drive.csv", READ,
                column=header, value=float(step[at]), rows=(row - 1, row),
            )]  # fmt: skip
    return []


def _one_wheel(
    t: np.ndarray, speed: np.ndarray, rate: np.ndarray, header: str, scale: float
) -> list[Finding]:
    faster, turning = _change(t, speed), _change(t, rate)
    either_way = _change(t, np.abs(rate))  # a driver slows down for a turn to either side
    known = np.isfinite(faster) & np.isfinite(turning)
    if np.count_nonzero(known) < 30:
        return []
    design = np.column_stack([turning[known], either_way[known], np.ones(np.count_nonzero(known))])
    if np.linalg.matrix_rank(design) < 3:
        return []
    faster = faster[known]
    slopes, *_ = np.linalg.lstsq(design, faster, rcond=None)
    rest = faster - design @ slopes
    part = design[:, 0] - design[:, 0].mean()
    explained = abs(slopes[0]) * float(part.std())
    likeness = explained / np.hypot(explained, float(rest.std()))
    # Windows overlap by three quarters of what they span, so a quarter of them is independent.
    sd = float(rest.std()) / max(float(part.std()) * np.sqrt(faster.size / 4), 1e-12)
    half_track = float(slopes[0])
    inside = HALF_TRACKS[0] * scale <= abs(half_track) <= HALF_TRACKS[1] * scale
    if not (inside and likeness > FOLLOWS and abs(half_track) > BEYOND_CHANCE * sd):
        return []
    return [Finding(
        "speed_of_one_wheel", False,
        f"column {shown(header)} follows the yaw rate with {half_track:.2g} m, correlation {likeness:.2f}",
        f"it is the speed of one wheel {abs(half_track):.2g} m from the middle; take the mean of two.",
        'log["U [m/s]"] = (log["left [m/s]"] + log["right [m/s]"]) / 2', READ,
        column=header, value=half_track,
    )]  # fmt: skip
