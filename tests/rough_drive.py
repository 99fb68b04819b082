"""A drive no car would survive, and that the filter must: every status occurs, often."""

import numpy as np


def rough_drive(samples: int, seed: int, *, even: bool = False) -> np.ndarray:
    """Rows (dt, steer, speed, yaw rate) with every fault a log can have.

    The plant is a first-order yaw response, near enough to be followed and far enough to be wrong.
    Where ``even``, most time steps are alike, as filters designed for one want them.
    """
    rng = np.random.default_rng(seed)
    t = np.arange(samples) * 0.01
    speed = np.clip(18 + 14 * np.sin(t / 7 + seed) + 8 * np.sin(t / 3), -3, 45)
    loud = np.repeat(rng.choice([0.0, 3e-4, 3e-3, 3e-2], samples // 500 + 1), 500)[:samples]
    steer = loud * np.sin(2 * np.pi * 0.5 * t + seed) + rng.normal(0, 1e-4, samples)
    gain = np.repeat(rng.choice([0.5, 1.0, 2.0], samples // 3000 + 1), 3000)[:samples]
    yaw = gain * speed / 2.7 * steer / (1 + (speed / 22) ** 2) + rng.normal(0, 3e-3, samples)
    rows = np.column_stack([np.full(samples, 0.01), steer, speed, yaw])
    _spoil(rows, rng, even)
    return rows


def _spoil(rows: np.ndarray, rng: np.random.Generator, even: bool) -> None:
    n = len(rows)

    def some(share: float) -> np.ndarray:
        return rng.random(n) < share

    rows[some(0.001 if even else 0.3), 0] = rng.choice([0.005, 0.02, 0.05, 0.1])
    for share, values in (
        (0.002, [0.0, -0.01, np.nan, np.inf, -np.inf, 1e300, 1e-300, 5e-324, 2e6]),
        (0.002, [1.5, 3.0, 60.0, 9e5, 1e-5]),
    ):
        at = some(share)
        rows[at, 0] = rng.choice(values, at.sum())
    for column, huge in ((1, 2.0), (2, 500.0), (3, 50.0)):
        wild = [np.nan, np.inf, -np.inf, huge, -huge, 1e308, -1e-310, 0.0]
        at = some(0.004)
        rows[at, column] = rng.choice(wild, at.sum())
        for start in rng.integers(0, n, max(1, n // 20000)):  # missing for two seconds
            rows[start : start + 200, column] = np.nan
    spike, jump = some(0.003), some(0.001)
    rows[spike, 3] += rng.normal(0, 3, spike.sum())  # the gate lets them through
    rows[jump, 2] = rng.uniform(-20, 149, jump.sum())
    for start in rng.integers(0, n, max(1, n // 10000)):
        rows[start : start + 150, 2] = rng.choice([0.0, -2.0, 0.3, 3.0])  # stands, backs, crawls
