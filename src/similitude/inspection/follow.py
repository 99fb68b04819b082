"""How late and to which side the yaw rate follows the steer, from their cross-correlation.

Invariant: the interval comes from the log itself, by leaving out one stretch after another
(jackknife), so a lag that only one manoeuvre shows is as uncertain as it is.

    x = steer U [rad m/s], what turns the car;  r yaw rate [rad/s];  c(lag) = sum x(t - lag) r(t)
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from similitude.inspection.signals import Signals

EARLIEST, LATEST = -0.5, 1.0  # s, of the yaw rate behind the steer
SLOW = 2.0  # s: what changes more slowly says nothing about lag and is taken out
STRETCHES = 20
FEWEST_STRETCHES = 5
SURE = 3.0  # sds of the slope of y over x, before a side is believed
LIKENESS = 0.3  # of the correlation, below which the two have little to do with each other
CLOCK = 0.1  # of a step: what interpolation between two rows leaves open
MOVING = 0.5  # m/s


@dataclass(frozen=True)
class Follow:
    """How one signal follows another.

    ``sign`` is +1 or -1, 0 where the log does not show it; ``likeness`` the correlation at the lag
    [-]; ``lag`` [s] with its sd, None where the sign is 0 or the lag at the edge of the search.
    """

    sign: int
    likeness: float
    lag: float | None = None
    lag_std: float | None = None


def yaw_behind_steer(signals: Signals) -> Follow | None:
    """Lag of the yaw rate behind the steer; None where one of the two or the speed is missing.

    The lag is that of steering, tyres and yaw inertia together: an average car takes some 0.1 s
    by itself.
    """
    if signals.steer is None or signals.r is None or signals.U is None:
        return None
    moving = np.abs(signals.U) > MOVING
    x = np.where(moving, signals.steer * signals.U, np.nan)
    return follow(x, np.where(moving, signals.r, np.nan), signals.step)


def follow(x: NDArray[np.float64], y: NDArray[np.float64], step: float) -> Follow | None:
    """Sign and lag of y behind x, both (n,) on one even clock of the given step [s].

    None where fewer than five stretches hold anything.
    """
    both = np.isfinite(x) & np.isfinite(y)
    before, after = round(EARLIEST / step), round(LATEST / step)
    if np.count_nonzero(both) < FEWEST_STRETCHES * (after - before):
        return None
    x, y = _quick(x, both, step), _quick(y, both, step)
    cross, power = _by_stretch(x, y, both, before, after)
    if len(cross) < FEWEST_STRETCHES:
        return None
    total = cross.sum(axis=0)
    scale = float(np.sqrt(power[:, 0].sum() * power[:, 1].sum()))
    if not scale > 0:
        return Follow(0, 0.0)
    best = int(np.argmax(np.abs(total)))
    likeness = float(total[best] / scale)
    n = len(cross)
    slope = total[best] / power[:, 0].sum()
    spread = float(np.linalg.norm(cross[:, best] - slope * power[:, 0]))  # what a line leaves over
    if abs(total[best]) < SURE * spread or abs(likeness) < LIKENESS:
        return Follow(0, likeness)
    sign = int(np.sign(total[best]))
    if not 0 < best < total.size - 1:
        return Follow(sign, likeness)
    lag = step * (before + _peak(sign * total))
    without = np.array([step * (before + _peak(sign * (total - one))) for one in cross])
    std = float(np.sqrt((n - 1) / n * np.sum((without - without.mean()) ** 2)))
    return Follow(sign, likeness, float(lag), float(np.hypot(std, CLOCK * step)))


def _quick(values: NDArray[np.float64], both: NDArray[np.bool_], step: float) -> NDArray[np.float64]:
    """What is faster than `SLOW`: a value less the mean around it; 0 where nothing was measured."""
    half = max(1, round(SLOW / step / 2))
    filled = np.where(both, values, 0.0)
    count = _around(both.astype(float), half)
    return np.where(both, filled - _around(filled, half) / np.maximum(count, 1.0), 0.0)


def _around(values: NDArray[np.float64], half: int) -> NDArray[np.float64]:
    """Sum over the `half` values before and after each, and itself."""
    padded = np.concatenate([np.zeros(half + 1), values, np.zeros(half)])
    total = np.cumsum(padded)
    return total[2 * half + 1 :] - total[: -(2 * half + 1)]


def _by_stretch(x, y, both, before: int, after: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Sums of products at every lag (stretches, lags) and of squares (stretches, 2), where measured."""
    n = x.size
    edges = np.linspace(0, n, STRETCHES + 1).astype(int)
    cross, power = [], []
    for low, high in pairwise(edges):
        if np.count_nonzero(both[low:high]) < 2:
            continue
        here = np.zeros(high - low + after - before)  # x from `after` rows before to `-before` after
        first, last = low - after, high - before
        here[max(first, 0) - first : min(last, n) - first] = x[max(first, 0) : min(last, n)]
        # Entry j of the valid correlation is the sum of x(t - after + j) y(t): lag after - j.
        cross.append(_correlate(here, y[low:high])[::-1])
        power.append((float(x[low:high] @ x[low:high]), float(y[low:high] @ y[low:high])))
    return np.array(cross), np.array(power)


def _correlate(longer: NDArray[np.float64], shorter: NDArray[np.float64]) -> NDArray[np.float64]:
    """Valid correlation through the Fourier transform: sum over k of longer[j + k] shorter[k]."""
    size = 1 << int(longer.size - 1).bit_length()
    product = np.fft.rfft(longer, size) * np.conj(np.fft.rfft(shorter, size))
    return np.fft.irfft(product, size)[: longer.size - shorter.size + 1]


def _peak(curve: NDArray[np.float64]) -> float:
    """Place of the highest point of the parabola through the largest value and its neighbours."""
    best = int(np.argmax(curve))
    if not 0 < best < curve.size - 1:
        return float(best)
    before, here, after = curve[best - 1 : best + 2]
    curvature = before - 2 * here + after
    return best + 0.5 * (before - after) / curvature if curvature < 0 else float(best)
