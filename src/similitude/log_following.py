"""What the yaw rate does that the steer of the log cannot bring about.

Invariant: no value is changed. How this car answers its steer is learnt from the same log, outside the
stretches in question, so neither a vehicle file nor a model is needed.

    r = sum_j h_j mean of (U delta) over lag j  +  h_U U  +  h_0,     lags -0.05 to 1 s
    t time [s];  delta steer of road wheel or steering wheel [rad];  r yaw rate [rad/s];  U speed [m/s]

A steer that is held while the car goes on turning this way and that was not measured; one that stands
at an end while the yaw rate bulges further was cut off.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from similitude.log_plausibility import STANDSTILL

BIN = 0.05  # s; yaw motion is slower than 10 Hz
MOST_BINS = 200_000
TAPS = ((-1, -1), (0, 0), (1, 1), (2, 2), (3, 4), (5, 7), (8, 12), (13, 20))  # bins ago, first and last
MEMORY = 20  # bins; a car has forgotten its steer after a second
BULGE_TAPS = TAPS[1:6]
FEWEST_BINS = 100
SETTLING = 0.25  # s; what was steered before a stretch dies away
LEAST_BINS = 4
LONG = 0.05  # of the log
EXPLAINED = 0.3  # of the yaw rate's variance; below, the log does not tell how the car answers
RIDGE = 1e-4  # of a column's mean square
OUTLIER = 4.0  # robust sds; a blow to the gyro is not how the car answers
UNUSUAL = 2.0  # times what the steer leaves unexplained in all but a twentieth of equal stretches
BEYOND_NOISE = 3.0  # robust sds of what it leaves unexplained elsewhere
AT_END = 0.01, 0.8  # share of the rows at an end: cut off there
VISITS = 2
PILED = 3.0  # times the rows of the next step; rounding gives a sine's peak 2.4 times at most
BETTER = 0.05  # of what is left unexplained, taken away by the bulges of a steer that goes on
CENSORED_ROUNDS = 8
BEYOND_STEP = 0.35  # of the readings' step; the top of a rounded sine is a sixth above its last step
BEYOND_END = 0.1  # sd of the yaw rate, by which a steer asks for more than its largest value


@dataclass(frozen=True, eq=False)
class Following:
    """Steer times speed, yaw rate and speed in even bins, (n,) each, NaN where nothing was measured."""

    t: np.ndarray  # time since the first row, divided by the width of a bin, (rows,)
    asked: np.ndarray
    turned: np.ndarray
    speed: np.ndarray

    @classmethod
    def of(cls, values: Mapping[str, np.ndarray], name: str) -> Following | None:
        """Bins of a log; None where it is too short, or lacks yaw rate or speed."""
        if not {name, "r", "U"} <= values.keys() or values["t"].size < FEWEST_BINS:
            return None
        t = values["t"] - values["t"][0]
        width = max(BIN, float(np.median(np.diff(t))), float(t[-1]) / MOST_BINS)
        at = t / width + 1e-6
        means = (_means(at, one) for one in (values["U"] * values[name], values["r"], values["U"]))
        found = cls(at, *means)
        return found if found.turned.size >= FEWEST_BINS else None

    def design(self) -> tuple[np.ndarray, np.ndarray]:
        """Columns (n, k) of the relation, and the bins (n,) in which all of them are known."""
        known = np.isfinite(self.turned) & np.isfinite(self.speed) & (np.arange(self.turned.size) >= MEMORY)
        columns, there = _past(self.asked, TAPS)
        speed = np.where(np.isfinite(self.speed), self.speed, 0.0)
        return np.column_stack([columns, speed, np.ones(speed.size)]), known & there


def unanswered(
    values: Mapping[str, np.ndarray], name: str, held: list[tuple[int, int]], *, of: str | None = None
) -> np.ndarray:
    """Rows (n,) of held stretches in which the car turns as no held steer makes it turn, or the reverse.

    Not those at an end of the range that is reached again and again: a command is limited there.

    Parameters
    ----------
    values : mapping of str to (n,) float64   SI: "t" rising, the steer `name`, "r" and "U"
    held : list of (first, past the last)     rows between which a signal does not move
    of : str or None                          that signal: the steer, or "r"
    """
    rows = np.zeros(values["t"].size, dtype=bool)
    seen = Following.of(values, name)
    if seen is None or not held:
        return rows
    design, known = seen.design()
    answer = _Answer.of(design, seen.turned, known)
    settling = int(SETTLING * seen.t[-1] / float(values["t"][-1] - values["t"][0])) + 1
    ends = _ends(values[of or name])
    for a, b in held:
        first, last = int(seen.t[a]), int(seen.t[b - 1])
        stretch = slice(first + settling, last)
        if known[stretch].sum() < LEAST_BINS or ends[a]:
            continue
        if not np.nanmin(np.abs(values["U"][a:b])) > STANDSTILL:
            continue
        out, own = slice(first, last + MEMORY), answer
        if last - first > LONG * known.size:  # it would spoil what is learnt from the rest
            outside = known.copy()
            outside[out] = False
            own = _Answer.of(design, seen.turned, outside)
        if own is not None:
            rest = own.without(out, stretch)[known[stretch]]
            size = float(np.sqrt(np.mean(rest**2)))
            usual = max(BEYOND_NOISE * own.noise, UNUSUAL * own.usual(min(rest.size, MEMORY), out))
            rows[a:b] = size > usual
    return rows


@dataclass(frozen=True, eq=False)
class _Answer:
    """How the car answers: columns and yaw rate in bins, those that count, and what the fit leaves."""

    design: np.ndarray  # (n, k), of unit size
    turned: np.ndarray  # (n,)
    counts: np.ndarray  # (n,)
    square: np.ndarray  # (k, k)
    product: np.ndarray  # (k,)
    rest: np.ndarray  # (n,)
    noise: float  # robust sd of it

    @classmethod
    def of(cls, design: np.ndarray, turned: np.ndarray, known: np.ndarray) -> _Answer | None:
        """A robust fit; None where the steer explains too little of the yaw rate."""
        counts = known
        if np.count_nonzero(known) < FEWEST_BINS:
            return None
        design = design / _sizes(design[known])
        turned = np.where(np.isfinite(turned), turned, 0.0)
        for _ in range(3):
            square, product = design[counts].T @ design[counts], design[counts].T @ turned[counts]
            rest = turned - design @ _solved(square, product)
            noise = 1.4826 * float(np.median(np.abs(rest[counts])))
            last, counts = counts, known & (np.abs(rest) <= OUTLIER * max(noise, 1e-12))
            if np.count_nonzero(counts) < FEWEST_BINS:
                return None
        explained = 1 - float(np.var(rest[last])) / max(float(np.var(turned[last])), 1e-300)
        if not explained >= EXPLAINED:
            return None
        return cls(design, turned, last, square, product, rest, noise)

    def without(self, left_out: slice, stretch: slice) -> np.ndarray:
        """What the steer leaves of the yaw rate in a stretch, learnt without the bins left out."""
        out = self.design[left_out][self.counts[left_out]]
        square, product = self.square - out.T @ out, self.product - out.T @ self.turned[left_out][
            self.counts[left_out]
        ]  # fmt: skip
        return self.turned[stretch] - self.design[stretch] @ _solved(square, product)

    def usual(self, count: int, left_out: slice) -> float:
        """Rms of what is left over other stretches of so many bins: all but a twentieth are below it."""
        counts = self.counts.copy()
        counts[left_out] = False
        square = np.where(counts, self.rest, 0.0) ** 2
        total, there = np.r_[0.0, np.cumsum(square)], np.r_[0, np.cumsum(counts)]
        seen = there[count:] - there[:-count]
        whole = seen >= 0.8 * count
        if not whole.any():
            return np.inf
        return float(np.sqrt(np.quantile((total[count:] - total[:-count])[whole] / seen[whole], 0.95)))


def cut_off(values: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """Rows (n,) in which the steer stands at an end of its range while the yaw rate bulges further."""
    x = values[name]
    rows = np.zeros(x.size, dtype=bool)
    ends = _ends(x)
    seen = Following.of(values, name) if ends.any() else None
    if seen is None:
        return rows
    bulge = _means(seen.t, values["U"] * _bulges(values["t"], ends))
    more, there = _past(bulge, BULGE_TAPS)
    design, known = seen.design()
    known &= there
    if np.count_nonzero(known) < FEWEST_BINS or not np.any(more[known]):
        return rows
    before, first = _squares(design, seen.turned, known)
    after, then = _squares(np.column_stack([design, more]), seen.turned, known)
    spread = float(np.var(seen.turned[known])) * np.count_nonzero(known)
    if before > (1 - EXPLAINED) * spread or after > (1 - BETTER) * before:
        return rows
    onward = float(then[-len(BULGE_TAPS) :].sum()) * float(first[: len(TAPS)].sum())
    return ends != 0 if onward > 0 else rows


def cut_short(values: Mapping[str, np.ndarray], name: str) -> np.ndarray:
    """Rows (n,) in which the yaw rate stands at an end of its range while the steer asks for more.

    What is asked for is learnt with the rows at an end taken for the least that the car turned. Noise alone
    lifts a largest value above what the steer asks for, so that chance speaks against a cut.
    """
    rates = values["r"]
    ends = _ends(rates)
    rows = np.zeros(rates.size, dtype=bool)
    seen = Following.of(values, name) if ends.any() else None
    if seen is None:
        return rows
    design, known = seen.design()
    side = np.nan_to_num(_means(seen.t, ends))[known]
    there = np.abs(side) > 0.5
    if np.count_nonzero(known) < FEWEST_BINS or min(there.sum(), (~there).sum()) < LEAST_BINS:
        return rows
    beyond, rest = _asked_beyond(design[known], seen.turned[known], np.where(there, np.sign(side), 0.0))
    spread = float(np.std(seen.turned[known]))
    if not float(np.var(rest)) <= (1 - EXPLAINED) * spread**2:
        return rows
    visits = np.count_nonzero(np.diff(there.astype(np.int8)) == 1) + int(there[0])
    noise = 1.4826 * float(np.median(np.abs(rest)))
    sure = max(BEYOND_NOISE * noise / np.sqrt(visits), BEYOND_END * spread)
    if not _is_piled(rates)[ends != 0].any():
        sure = max(sure, BEYOND_STEP * _step(rates))
    return ends != 0 if beyond > sure else rows


def _asked_beyond(design: np.ndarray, turned: np.ndarray, side: np.ndarray) -> tuple[float, np.ndarray]:
    """By how much the steer asks for more where a rate stands at an end; what it leaves elsewhere."""
    design = design / _sizes(design)
    square = design.T @ design
    asked = turned
    for _ in range(CENSORED_ROUNDS):
        least = np.where(side * (asked - turned) > 0, asked, turned)
        asked = design @ _solved(square, design.T @ least)
    return float(np.mean((side * (asked - turned))[side != 0])), (turned - asked)[side == 0]


def _step(x: np.ndarray) -> float:
    steps = np.abs(np.diff(x))
    return float(np.nanquantile(steps[steps > 0], 0.01)) if np.any(steps > 0) else 0.0


def _is_piled(x: np.ndarray) -> np.ndarray:
    """1 (n,) where a signal is at an extreme that holds more rows than chance and rounding give it."""
    step = _step(x)
    piled = np.zeros(x.size)
    for extreme in (np.nanmin(x), np.nanmax(x)):
        there = x == extreme
        next_to = np.count_nonzero(np.abs(x - extreme) < 1.5 * step) - np.count_nonzero(there)
        piled[there] = np.count_nonzero(there) > PILED * next_to
    return piled


def _ends(x: np.ndarray) -> np.ndarray:
    """+1 and -1 (n,) where a signal stands at an end of its range again and again, else 0."""
    ends = np.zeros(x.size)
    if not np.isfinite(x).any():
        return ends
    for extreme, side in ((np.nanmax(x), 1.0), (np.nanmin(x), -1.0)):
        there = x == extreme
        visits = np.count_nonzero(np.diff(there.astype(np.int8)) == 1) + int(there[0])
        if AT_END[0] <= np.mean(there) <= AT_END[1] and visits >= VISITS:
            ends[there] = side
    return ends


def _bulges(t: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """What a smooth signal goes on to do while it is cut off, but for a factor: parabolas, (n,) [s^2]."""
    edges = np.flatnonzero(np.diff(np.r_[0.0, ends, 0.0]))
    bulge = np.zeros(t.size)
    for a, b in pairwise(edges):
        if ends[a]:
            first, last = t[max(a - 1, 0)], t[min(b, t.size - 1)]
            bulge[a:b] = ends[a] * (t[a:b] - first) * (last - t[a:b])
    return bulge


def _means(at: np.ndarray, signal: np.ndarray) -> np.ndarray:
    known = np.isfinite(signal)
    bins = at.astype(int)
    count = np.bincount(bins[known], minlength=bins[-1] + 1)
    total = np.bincount(bins[known], signal[known], minlength=bins[-1] + 1)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _past(x: np.ndarray, taps: tuple[tuple[int, int], ...]) -> tuple[np.ndarray, np.ndarray]:
    """Means of a signal over bins ago, (n, k), and where all of them were measured, (n,)."""
    known = np.isfinite(x)
    total, holes = np.r_[0.0, np.cumsum(np.where(known, x, 0.0))], np.r_[0, np.cumsum(~known)]
    k = np.arange(x.size)
    columns, there = [], np.ones(x.size, dtype=bool)
    for first, last in taps:
        low, high = np.clip(k - last, 0, x.size), np.clip(k - first + 1, 0, x.size)
        columns.append((total[high] - total[low]) / (last - first + 1))
        there &= holes[high] == holes[low]
    return np.column_stack(columns), there


def _sizes(design: np.ndarray) -> np.ndarray:
    """Root mean square of each column, (k,); 1 for an empty one."""
    size = np.sqrt(np.mean(design**2, axis=0))
    return np.where(size > 0, size, 1.0)


def _solved(square: np.ndarray, product: np.ndarray) -> np.ndarray:
    """Coefficients of columns of unit size; neighbouring lags are nearly one and the same."""
    ridge = RIDGE * max(float(np.trace(square)) / len(product), 1e-300)
    return np.linalg.solve(square + ridge * np.eye(len(product)), product)


def _squares(design: np.ndarray, y: np.ndarray, known: np.ndarray) -> tuple[float, np.ndarray]:
    """Sum of the squares that a fit leaves, and its coefficients."""
    size = _sizes(design[known])
    scaled = design[known] / size
    h = _solved(scaled.T @ scaled, scaled.T @ y[known])
    rest = y[known] - scaled @ h
    return float(rest @ rest), h / size
