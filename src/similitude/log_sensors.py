"""Stretches in which a sensor did not measure: stuck, at the end of its range, drawn by a ruler.

Invariant: values are never changed here. A stretch counts only where chance would not give it once
in a thousand logs, judged by how the same column behaves elsewhere.

    t time [s];  x any signal, (n,) NaN where missing
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from similitude.errors import shown
from similitude.finding import Finding
from similitude.log_columns import Column, column_of
from similitude.log_following import cut_off, cut_short, unanswered
from similitude.log_plausibility import STANDSTILL
from similitude.signal_faults.dead_band import dead_band

CHANCE = 1e-3  # expected number of such stretches in the log, were it chance
SHORTEST_STUCK = 0.5  # s; a held value of a slow bus is shorter
SHORTEST_LINE = 0.3  # s; an interpolated hole of a few samples is as good as none
MOST_REPEATS = 0.5  # of the pairs of neighbours; above, a column is held or coarse, and no noise shows
CLEAN_REPEATS = 0.02  # ... and up to here noise shows in every reading: no driver holds so still
MOST_STEPS = 0.5  # of the changes are of different sizes; fewer, and the readings lie on a grid
MOST_TIES = 0.05  # of the pairs of neighbours, away from the ends of the range
FEWEST_CLIPPED = 6  # rows at one end
ROUNDING = 1e-5  # of the value: three numbers of six digits miss a line by that
KINK = 30.0  # times the rounding; a smooth signal bends a little everywhere, a drawn one at corners
NOISE_TURNS = 0.2  # white noise bends the other way 73 times in 100, filtered noise 30, a motion hardly ever
SPIKE_NOISE = 12.0  # sd of the noise
SPIKE_STEPS = 4.0  # of the signal's own resolution
SPIKE_SHARE = 0.25  # of the range in which 99 % of the values lie
ALONE = 5  # rows without another spike; peaks of a fast manoeuvre come in rows
MOST_SPIKES = 0.02  # of the rows; more is how the signal is

READ = 'docs/logs.md, "Faults of sensors"'
STEERS = ("delta", "steering_wheel")
WORDS = {"delta": "steer", "r": "yaw rate", "U": "speed"}


def check_sensors(values: Mapping[str, np.ndarray], columns: Mapping[str, Column]) -> list[Finding]:
    """Find what sensors did not measure.

    Parameters
    ----------
    values : mapping of str to (n,) float64   "t" rising, and those of "delta", "r", "U" there are
    columns : mapping of str to Column        where they come from

    Returns
    -------
    list of Finding   all likely: stuck for a stretch, at the end of its range, drawn by a ruler,
                      spikes; each with the rows
    """
    found = []
    dead, short = _dead_rows(values)
    for name in [name for name in WORDS if name in values]:
        header = column_of(name, columns).header
        stuck = stuck_rows(values, name) & ~(dead | short if name == "r" else np.zeros_like(dead))
        found += _said(name, header, "stuck", stuck, values["t"])
        if name != "U":
            found += _said(name, header, "clipped", cut_rows(values, name), values["t"])
        found += _said(name, header, "spikes", spike_rows(values[name]), values["t"])
    if "r" in values:
        header = columns["r"].header
        found += _said("r", header, "interpolated", straight_rows(values["t"], values["r"]), values["t"])
        found += _said("r", header, "dead_band", dead, values["t"])
        found += _said("r", header, "dead_band_subtracted", short, values["t"])
    return found


def _dead_rows(values: Mapping[str, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Rows (n,) in which the yaw rate of a moving car was set to one number: the rest whole, or short."""
    rate = values.get("r", np.zeros(0))
    moving = np.abs(values["U"]) > STANDSTILL if "U" in values else np.isfinite(rate)
    found = dead_band(rate[moving]) if rate.size else None
    none = np.zeros(values["t"].size, dtype=bool)
    if found is None:
        return none, none
    rows = moving & (rate == found.value)
    return (rows, none) if found.width else (none, rows)


_TEXTS = {
    "stuck": ("does not move at all for {seconds:.3g} s", "the sensor or its bus fell silent.", "drop_stuck"),
    "clipped": ("lies at the end of its range in {count} rows", "the sensor saturated.", "drop_clipped"),
    "spikes": ("has {count} spikes", "single messages were damaged.", "drop_spikes"),
    "dead_band": (
        "is one and the same number in {count} rows, and never near it otherwise",
        "small values were set to zero, and the car seems to answer less: K reads low.",
        "drop_dead_band",
    ),
    "dead_band_subtracted": (
        "is one and the same number in {count} rows, and no other number comes back",
        "a dead band was subtracted and all others are short by it, or it stands for missing values.",
        None,
    ),
    "interpolated": (
        "lies on straight lines for {seconds:.3g} s",
        "holes, or a slower sensor, were filled in by interpolation: nothing is learnt there.",
        "drop_interpolated",
    ),
}


def _said(name: str, header: str, fault: str, rows: np.ndarray, t: np.ndarray) -> list[Finding]:
    count = int(np.count_nonzero(rows))
    if not count:
        return []
    seconds = count * float(np.median(np.diff(t)))
    what, usually, fix = _TEXTS[fault]
    first, last = (int(one) for one in np.flatnonzero(rows)[[0, -1]])
    return [Finding(
        fault, False,
        f"column {shown(header)} ({WORDS[name]}) {what.format(seconds=seconds, count=count)}, first in "
        f"data row {first + 1} (t = {t[first]:.6g} s)",
        usually, f"--fix {fix}" if fix else "--map r=COLUMN   # of the gyro itself", READ, column=header,
        value=seconds if fault in ("stuck", "interpolated") else float(count),
        rows=(first + 1, last + 1), fix=fix,
    )]  # fmt: skip


def stuck_rows(values: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """Rows (n,) in which a noisy signal repeats itself for longer than chance allows, while driving."""
    t, x = values["t"], values[name]
    same = np.diff(x) == 0
    starts, stops = runs(same)
    if not starts.size:
        return np.zeros(x.size, dtype=bool)
    seconds = t[stops] - t[starts]
    short = seconds < SHORTEST_STUCK
    elsewhere = same.size - int((stops - starts)[~short].sum())
    repeats = int((stops - starts)[short].sum()) / max(elsewhere, 1)
    if name in STEERS and (repeats > CLEAN_REPEATS or _is_coarse(x)):
        # A driver holds a wheel still, and rounded angles repeat; the car tells.
        held = [(a, b + 1) for a, b in zip(starts[~short], stops[~short], strict=True)]
        return unanswered(values, name, held)
    unmoved = np.zeros(x.size, dtype=bool)
    if name == "r" and (repeats > CLEAN_REPEATS or _is_coarse(x)):
        steers = [steer for steer in STEERS if steer in values]
        held = [(a, b + 1) for a, b in zip(starts[~short], stops[~short], strict=True)]
        unmoved = unanswered(values, steers[0], held, of="r") if steers else unmoved
    if repeats > MOST_REPEATS or elsewhere < same.size / 2:
        return unmoved
    long = ~short & (stops - starts >= _longest_by_chance(repeats, same.size))
    if "U" in values:
        speed = np.r_[0.0, np.nancumsum(np.abs(values["U"]))]
        long &= (speed[stops + 1] - speed[starts]) / (stops + 1 - starts) > STANDSTILL
    return _rows(starts[long], stops[long] + 1, x.size) | unmoved


def _is_coarse(x: np.ndarray) -> bool:
    """Whether a signal moves by a few steps of one size: without noise, a driver may hold it still."""
    moved = np.diff(x)
    moved = moved[np.isfinite(moved) & (moved != 0)]
    step = max(float(np.abs(moved).min(initial=np.inf)) / 4, 1e-300)  # the smallest of floats has no quarter
    return np.unique(np.round(moved / step)).size < MOST_STEPS * moved.size


def cut_rows(values: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """Rows (n,) in which a sensor is at the end of its range, by its own values or by what the car does."""
    rows = clipped_rows(values[name])
    if rows.any():
        return rows
    if name in STEERS:
        return cut_off(values, name)
    steers = [steer for steer in STEERS if steer in values]
    return cut_short(values, steers[0]) if steers else rows


def clipped_rows(x: np.ndarray) -> np.ndarray:
    """Rows (n,) at the very largest or smallest value, where a signal that moves freely piles up."""
    rows = np.zeros(x.size, dtype=bool)
    if not np.isfinite(x).any():
        return rows
    steps = np.abs(np.diff(x))
    step = float(np.nanmin(steps[steps > 0])) if np.any(steps > 0) else 0.0
    extremes = [np.nanmin(x), np.nanmax(x)]
    between = steps[~np.isin(x[1:], extremes)]
    if not between.size or np.mean(between == 0) > MOST_TIES:
        return rows  # two values, held or coarse: values pile up everywhere
    for extreme in extremes:
        pile = x == extreme
        near = np.count_nonzero(np.abs(x - extreme) < 3.5 * step) - np.count_nonzero(pile)
        # A coarse sine spends as long in the three steps below its peak as at the peak.
        if np.count_nonzero(pile) >= max(FEWEST_CLIPPED, 4 * near):
            rows |= pile
    return rows


def spike_rows(x: np.ndarray) -> np.ndarray:
    """Rows (n,) that stand out from both neighbours, which agree with each other, and stand alone."""
    rows = np.zeros(x.size, dtype=bool)
    bend = _bend(x)
    known = np.abs(bend[np.isfinite(bend)])
    if known.size < 8:
        return rows
    noise = 1.4826 * float(np.median(known)) / np.sqrt(1.5)  # sd of x - (x_before + x_after)/2
    low, high = np.nanpercentile(x, [0.5, 99.5])
    steps = np.abs(np.diff(x))
    moved = steps[steps > 0]
    coarse = float(np.quantile(moved, 0.01)) if moved.size else 0.0
    least = max(SPIKE_NOISE * noise, SPIKE_SHARE * (high - low), SPIKE_STEPS * coarse)
    out = (np.abs(bend) > least) & (np.abs(x[2:] - x[:-2]) < np.abs(bend))
    at = np.flatnonzero(out) + 1
    if not at.size or least == 0 or at.size > MOST_SPIKES * x.size:
        return rows
    apart = np.diff(at)
    alone = np.r_[True, apart > ALONE] & np.r_[apart > ALONE, True]
    rows[at[alone]] = True
    return rows


def straight_rows(t: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Rows (n,) strictly inside straight lines that a noisy signal cannot have drawn."""
    rows = np.zeros(x.size, dtype=bool)
    if x.size < 8:
        return rows
    share = (t[1:-1] - t[:-2]) / (t[2:] - t[:-2])
    bend = x[1:-1] - x[:-2] - share * (x[2:] - x[:-2])
    rounding = ROUNDING * np.maximum(np.abs(x[:-2]), np.abs(x[2:]))
    straight = (np.abs(bend) <= rounding) & (np.abs(x[2:] - x[:-2]) > 4 * rounding)
    starts, stops = runs(straight)
    if not starts.size:
        return rows
    seconds = t[np.minimum(stops + 1, t.size - 1)] - t[starts]
    long = seconds > SHORTEST_LINE
    elsewhere = straight.size - int((stops - starts)[long].sum())
    by_chance = int((stops - starts)[~long].sum()) / max(elsewhere, 1)
    bent = ~straight & np.isfinite(bend)
    if (
        by_chance > MOST_REPEATS
        and bent.any()
        and np.median(np.abs(bend[bent]) / (rounding[bent] + 1e-300)) > KINK
    ):
        long[:] = True  # every few rows one was measured, and lines lead from one to the next
    elif _is_noise(bend[bent]):
        long &= stops - starts >= _longest_by_chance(by_chance, straight.size)
    else:
        return rows
    return _rows(starts[long] + 1, stops[long] + 1, x.size)


def runs(mask: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Starts and ends (past the last) of the stretches in which a mask (n,) holds."""
    edges = np.flatnonzero(np.diff(np.r_[False, mask, False].astype(np.int8)))
    return edges[::2], edges[1::2]


def _rows(starts: np.ndarray, stops: np.ndarray, size: int) -> np.ndarray:
    edges = np.zeros(size + 1, dtype=np.int64)
    np.add.at(edges, starts, 1)
    np.add.at(edges, stops, -1)
    return np.cumsum(edges[:-1]) > 0


def _bend(x: np.ndarray) -> np.ndarray:
    return x[1:-1] - 0.5 * (x[:-2] + x[2:])


def _is_noise(bend: np.ndarray) -> bool:
    return bend.size > 8 and float(np.mean(bend[1:] * bend[:-1] < 0)) > NOISE_TURNS


def _longest_by_chance(share: float, size: int) -> float:
    """Length of a run that chance gives `CHANCE` times in `size` trials of this share."""
    return np.log(size / CHANCE) / -np.log(min(max(share, 1e-3), 0.999))
