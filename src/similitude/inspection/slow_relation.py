"""Offset, bias and steering ratio from the slow relation between steer and yaw rate.

    r = U (steer - straight) / (length (1 + c U^2)) + bias

    r yaw rate [rad/s];  U speed [m/s];  steer angle, road wheel or steering wheel [rad];
    straight what the steer reads when the car goes straight [rad];  bias of the gyro [rad/s];
    length wheelbase, times steering ratio where the steer is the steering wheel's [m];
    c understeer [s^2/m^2]

Invariant: every value is the mode of a posterior whose prior is stated here, and its sd is the
larger of the model's and of the stretches' own scatter, so what wanders slowly widens it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.inspection.signals import Signals
from similitude.vehicle_file import Vehicle
from similitude.vehicle_prior import vehicle_prior

WINDOW = 2.0  # s: a mean over it has forgotten the dynamics of yaw
MEASURED = 0.8  # share of a window that must be there
CREEPING = 1.0  # m/s: slower, r/U is noise
LINEAR = 0.3 * 9.80665  # m/s^2
FEWEST_WINDOWS = 5
STRETCHES = 20
STRAIGHT_SD = np.deg2rad(2.0)  # of a road wheel: alignment and centring
WHEEL_RATIO = 16.0  # a steering wheel's offset is this much larger
BIAS_SD = 0.01  # rad/s: an automotive gyro before calibration
UNDERSTEER = (0.8, 1.0)  # c U^2 at the log's high speed, and its sd: little cars to lorries
STRUCTURE = 0.06  # of the length: what a static relation leaves out of a moving car
STANDING = 0.1  # m/s
STANDING_TIME = 0.5  # s, before a standstill says anything
RESTLESS = 5.0  # times the quietest: a standstill during which the car is turned by hand
TURNS = 3.0  # sds of the gain, before the steer is believed to turn the car
LEAST = 0.1  # of 1 + c U^2: an oversteering car at its critical speed has 0
TINY = 1e-300  # what a variance is never below
ROUNDS = 30
SHARES = 0.5 ** np.arange(12)  # of a step, tried until the fit gets better


@dataclass(frozen=True)
class Measured:
    """A value with its sd, both in one unit; the 95 % interval is value -+ 1.96 sd."""

    value: float
    std: float
    unit: str


@dataclass(frozen=True)
class SlowRelation:
    """What the slow relation says; None where the log does not.

    ``windows`` is how many stretches of two seconds it rests on; ``length_std`` is relative.
    """

    windows: int
    straight: Measured | None = None
    bias: Measured | None = None
    length: float | None = None
    length_std: float | None = None


@dataclass(frozen=True, eq=False)
class Windows:
    """Means over windows, (k,) each: steer [rad], r [rad/s], U [m/s], steer U [rad m/s]; their time."""

    t: NDArray[np.float64]
    steer: NDArray[np.float64]
    r: NDArray[np.float64]
    U: NDArray[np.float64]
    product: NDArray[np.float64]

    @property
    def middle(self) -> float:
        """Median speed [m/s]."""
        return float(np.median(self.U))


def slow_relation(
    signals: Signals, *, lag: float = 0.0, understeer: tuple[float, float] | None = None
) -> SlowRelation:
    """Find offset, bias and length.

    Parameters
    ----------
    signals : Signals        steer, r and U must be there for more than a bias at standstill
    lag : float              of the yaw rate behind the steer [s]
    understeer : (c, sd)     of the car [s^2/m^2]; None: `UNDERSTEER`, which holds any car
    """
    still = standstill_bias(signals)
    windows = _windows(signals, lag)
    if windows is None or windows.t.size < FEWEST_WINDOWS or not windows.product.any():
        return SlowRelation(0 if windows is None else int(windows.t.size), bias=still)
    if understeer is None:
        high = float(np.quantile(windows.U, 0.95)) ** 2
        understeer = (UNDERSTEER[0] / high, UNDERSTEER[1] / high)
    straight_sd = STRAIGHT_SD * (WHEEL_RATIO if signals.at_wheel else 1.0)
    prior_mean = np.array([0.0, understeer[0], 0.0, still.value if still else 0.0])
    prior_sd = np.array([np.inf, understeer[1], straight_sd, still.std if still else BIAS_SD])
    (gain, c, straight, bias), covariance = _fit(windows, prior_mean, prior_sd)
    std = np.sqrt(np.diag(covariance))
    bias = still or Measured(float(bias), float(std[3]), "rad/s")
    if abs(gain) <= TURNS * std[0]:
        return SlowRelation(int(windows.t.size), bias=bias)
    square = windows.middle**2
    by = np.array([-1 / gain, -square / max(1 + c * square, LEAST)])  # of ln length, by gain and c
    own = float(np.sqrt(by @ covariance[:2, :2] @ by))
    return SlowRelation(
        windows=int(windows.t.size),
        straight=Measured(float(straight), float(std[2]), "rad"),
        bias=bias,
        length=float(1 / (gain * max(1 + c * square, LEAST))),
        length_std=float(np.hypot(own, STRUCTURE)),
    )


def usual_understeer(vehicle: Vehicle | None) -> tuple[float, float] | None:
    """Understeer (1 - pi1)(1 - 1/eta)/K of the vehicle's prior and its sd [s^2/m^2]; None without L."""
    if vehicle is None or vehicle.L is None:
        return None
    prior = vehicle_prior(vehicle)
    K, pi1, eta, _ = prior.mean
    c = (1 - pi1) * (1 - 1 / eta) / K
    slope = np.array([-c, -(1 - 1 / eta) / K, (1 - pi1) / (eta * K), 0.0])  # by ln K, pi1, ln eta
    return float(c), float(np.sqrt(slope @ prior.covariance @ slope))


def standstill_bias(signals: Signals) -> Measured | None:
    """Bias of the gyro where the car stands; None where it never does.

    The sd is that of a mean whose noise is alike over a second.
    """
    if signals.r is None or signals.U is None:
        return None
    still = (np.abs(signals.U) < STANDING) & np.isfinite(signals.r)
    count = max(1, round(1.0 / signals.step))
    pieces = [part for part in np.split(signals.r, np.flatnonzero(np.diff(still)) + 1)]
    flags = np.split(still, np.flatnonzero(np.diff(still)) + 1)
    held = [part for part, on in zip(pieces, flags, strict=True) if on[0]]
    quiet = [part[i : i + count] for part in held for i in range(0, part.size, count)]
    quiet = [part for part in quiet if part.size * signals.step >= STANDING_TIME]
    if not quiet:
        return None
    spread = np.array([part.std() for part in quiet])
    calm = spread <= RESTLESS * max(float(spread.min()), 1e-6)
    means = np.array([part.mean() for part, ok in zip(quiet, calm, strict=True) if ok])
    middle = float(np.median(means))
    alone = float(np.median(spread[calm])) / np.sqrt(count)
    between = 1.4826 * float(np.median(np.abs(means - middle)))
    return Measured(middle, max(between, alone, 1e-6) * 1.2533 / np.sqrt(means.size), "rad/s")


def _windows(signals: Signals, lag: float) -> Windows | None:
    """Means over windows where the car moves forward inside the linear range."""
    if signals.steer is None or signals.r is None or signals.U is None:
        return None
    late = np.interp(signals.t - lag, signals.t, signals.steer, left=np.nan, right=np.nan)
    product = late * signals.U
    rows = max(1, round(WINDOW / signals.step))
    count = signals.t.size // rows
    cut = [x[: count * rows].reshape(count, rows) for x in (late, signals.r, signals.U, product)]
    fine = np.logical_and.reduce([np.isfinite(x) for x in cut])
    fine &= (cut[2] > CREEPING) & (np.abs(cut[1] * cut[2]) < LINEAR)
    kept = fine.mean(axis=1) >= MEASURED
    weight = fine[kept].sum(axis=1)
    means = [np.where(fine, x, 0.0)[kept].sum(axis=1) / weight for x in cut]
    starts = signals.t[: count * rows : rows][kept]
    return Windows(starts, *means)


def _fit(
    w: Windows, mean: NDArray[np.float64], sd: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Mode and covariance of (gain, c, straight, bias) by Gauss-Newton.

    The gain [1/m] is that at the middle speed, 1/(length (1 + c U^2)): the log shows it, while its two
    parts trade.
    """
    precision = np.diag(1 / sd**2)
    p = mean.copy()
    p[0] = (w.product @ w.r) / float(w.product @ w.product)
    for _ in range(ROUNDS):
        residual, slope = _residual(p, w)
        variance = max(float(residual @ residual) / max(w.t.size - 2, 1), 1e-14)
        H = slope.T @ slope / variance + precision
        move = np.linalg.lstsq(H, slope.T @ residual / variance - precision @ (p - mean), rcond=None)[0]
        now = _cost(p, w, variance, mean, precision)
        share = next((s for s in SHARES if _cost(p + s * move, w, variance, mean, precision) <= now), 0.0)
        p = p + share * move
        if np.all(np.abs(share * move) <= 1e-9 * (np.abs(p) + 1e-9)):
            break
    inverse = np.linalg.pinv(H)
    scatter = _scatter(slope * (residual / variance)[:, None])
    sandwich = inverse @ (scatter + precision) @ inverse
    known = np.maximum(np.diag(inverse), TINY)
    wider = np.sqrt(np.maximum(np.diag(sandwich) / known, 1.0))
    return p, inverse * np.outer(wider, wider)


def _cost(p, w: Windows, variance: float, mean, precision) -> float:
    residual, _ = _residual(p, w)
    away = p - mean
    return float(residual @ residual / variance + away @ precision @ away)


def _residual(p: NDArray[np.float64], w: Windows) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    gain, c, straight, bias = p
    square = w.middle**2
    middle, stiff = max(1 + c * square, LEAST), np.maximum(1 + c * w.U**2, LEAST)
    share = middle / stiff
    turned = (w.product - w.U * straight) * share
    by_c = gain * turned * (square / middle - w.U**2 / stiff)
    slope = np.column_stack([turned, by_c, -gain * w.U * share, np.ones(w.t.size)])
    return w.r - gain * turned - bias, slope


def _scatter(scores: NDArray[np.float64]) -> NDArray[np.float64]:
    """Covariance of the sum of scores when those of a stretch belong together."""
    k = max(1, min(STRETCHES, len(scores) // 2))
    sums = np.add.reduceat(scores, np.linspace(0, len(scores), k + 1).astype(int)[:-1], axis=0)
    return sums.T @ sums * (k / max(k - 2, 1))
