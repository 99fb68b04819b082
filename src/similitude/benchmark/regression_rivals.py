"""What a user would take otherwise: least squares on the equations of motion, with average groups.

    r*'' = π3 (B1 δ' − M2 r*' − K1 r*) + π3² K2 (δ − r*)     exact, in dimensionless time
    B1 = pi1/pi5,  M2 = 1 + k + (pi1² + p2² k)/pi5,  K1 = (p2 k − pi1)/pi5,  K2 = k/pi5

Steer and yaw rate go through the same low-pass of fourth order at 3 Hz, which the equations do not see,
and are taken at 20 Hz. `window` finds K over the last 10 s; `padasip` by that package's recursive least
squares with a memory of 5 s, which takes π3 and π3² for two unknowns. The interval is that of the scatter,
as such estimators claim it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from similitude.benchmark.drives import Drive
from similitude.benchmark.entrant import Answer
from similitude.estimators.paper_design import PAPER_GROUPS

Array = NDArray[np.float64]
START_K, START_STD = 145.68, 0.5  # m^2/s^2 and of ln K, before anything is learnt
MEAN_OVER = 5  # rows
LOW_PASS = 3.0  # Hz
TRIED = START_K * np.exp(np.linspace(-2.5, 2.5, 161))  # m^2/s^2
WINDOW, MEMORY = 10.0, 5.0  # s
LEAST = 5.0  # K and its sd stay within this factor of a start, so that a logarithm can be told [ln]


def thinned(drive: Drive) -> tuple[Array, Array, Array, Array]:
    """Return t, steer, yaw rate and speed as means over `MEAN_OVER` rows, lost samples held."""
    n = drive.t.size // MEAN_OVER * MEAN_OVER
    columns = [_held(x)[:n].reshape(-1, MEAN_OVER).mean(axis=1) for x in (drive.delta, drive.r, drive.U)]
    return drive.t[:n].reshape(-1, MEAN_OVER)[:, -1], *columns


def window(drive: Drive) -> Answer:
    """Solve least squares over the last ten seconds: the best of 161 K and a parabola about it."""
    t, phi, y = regression(drive)
    n = round(WINDOW / (t[1] - t[0]))
    a, b = phi.T
    products = (y * y, -2 * a * y, a * a - 2 * b * y, 2 * a * b, b * b)
    sums = np.array([_moving(x, n) for x in products])  # of 1, K, K², K³, K⁴
    cost = sums.T @ np.power(TRIED, np.arange(5)[:, None])
    best = np.clip(np.argmin(cost, axis=1), 1, TRIED.size - 2)
    row = np.arange(t.size)
    before, here, after = cost[row, best - 1], cost[row, best], cost[row, best + 1]
    bend = np.maximum(before - 2 * here + after, 1e-30)
    step = np.log(TRIED[1] / TRIED[0])
    K = TRIED[best] * np.exp(np.clip(0.5 * (before - after) / bend, -1, 1) * step)
    scatter = np.maximum(here, 0.0) / np.minimum(row + 1, n)
    return told(drive, t, K, K * np.sqrt(2 * scatter / bend) * step)


def padasip(drive: Drive) -> Answer:
    """Run padasip's recursive least squares."""
    from padasip.filters import FilterRLS

    t, phi, y = regression(drive)
    forgetting = float(np.exp(-(t[1] - t[0]) / MEMORY))
    size = np.sqrt(np.mean(phi[:100] ** 2, axis=0)) + 1e-30
    wanted = float(np.sqrt(np.mean(y[:100] ** 2))) + 1e-30
    start = np.array([START_K, START_K**2]) * size / wanted
    rls = FilterRLS(n=2, mu=forgetting, eps=1e-2, w=start.tolist())
    K, sd, left = np.empty(t.size), np.empty(t.size), 0.0
    for i, (row, one) in enumerate(zip(phi / size, y / wanted, strict=True)):
        left = forgetting * left + (1 - forgetting) * float(one - rls.w @ row) ** 2
        rls.adapt(one, row)
        unit = wanted / size[0]
        K[i], sd[i] = rls.w[0] * unit, unit * np.sqrt(max(left * rls.R[0, 0], 0.0))
    return told(drive, t, K, sd)


def regression(drive: Drive) -> tuple[Array, Array, Array]:
    """Return times (m,) [s], regressors (m, 2) of K and K², and regressand (m,), at 20 Hz."""
    from scipy.signal import butter, sosfilt, sosfilt_zi

    g, L = PAPER_GROUPS, drive.L
    p1, k, pi5 = g["pi1"], g["pi4_slope"], g["pi5"]
    p2 = 1 - p1
    U = _held(drive.U)
    dt = float(np.median(np.diff(drive.t)))
    sos = butter(4, LOW_PASS, fs=1 / dt, output="sos")
    rest = sosfilt_zi(sos)
    smooth = [sosfilt(sos, x, zi=rest * x[0])[0] for x in (_held(drive.delta), _held(drive.r) * L / U)]
    delta, r = smooth
    beat = L / U  # s of one unit of dimensionless time
    slope, steered = np.gradient(r, dt) * beat, np.gradient(delta, dt) * beat
    y = np.gradient(slope, dt) * beat
    M2, K1, K2 = 1 + k + (p1**2 + p2**2 * k) / pi5, (p2 * k - p1) / pi5, k / pi5
    linear = (p1 / pi5 * steered - M2 * slope - K1 * r) / U**2
    square = K2 * (delta - r) / U**4
    # A slope looks one row ahead, two of them two: what is known at a row is that of two rows before.
    rows = np.arange(2 * MEAN_OVER, drive.t.size, MEAN_OVER)
    return drive.t[rows], np.stack([linear, square], axis=1)[rows - 2], y[rows - 2]


def told(drive: Drive, t: Array, K: Array, sd: Array) -> Answer:
    """Return an answer at every row; K and sd (m,) [m^2/s^2] at times t, kept where a logarithm exists."""
    low, high = START_K * np.exp(-LEAST), START_K * np.exp(LEAST)
    K = np.clip(np.nan_to_num(K, nan=START_K, posinf=high, neginf=low), low, high)
    ln_sd = np.clip(np.nan_to_num(sd / K, nan=START_STD, posinf=LEAST), 1e-6, LEAST)
    at = np.searchsorted(t, drive.t, side="right") - 1
    known = at >= 0
    at = np.maximum(at, 0)
    return Answer(K=np.where(known, K[at], START_K), ln_K_std=np.where(known, ln_sd[at], START_STD))


def _moving(x: Array, n: int) -> Array:
    total = np.cumsum(x)
    return total - np.concatenate([np.zeros(min(n, x.size)), total[:-n]])[: x.size]


def _held(x: Array) -> Array:
    """A column with lost samples replaced by the one before (the first by the first that is there)."""
    fine = np.flatnonzero(np.isfinite(x))
    if fine.size in (0, x.size):
        return np.nan_to_num(x)
    return x[fine[np.maximum(np.searchsorted(fine, np.arange(x.size), side="right") - 1, 0)]]
