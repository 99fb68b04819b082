"""Innovations of a trial car and their slopes by its coordinates, for the steps of the batch fit.

Invariant: slopes are differences of passes of the frozen filter, never formulas of their own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from similitude.batch_pass import FrozenFilter
from similitude.filter_run import Pass, side_by_side

STEP = np.array([1e-4, 1e-4, 1e-4, 1e-4, 1e-4, 0.05])  # of a slope; a lag moves between rows
SCALE_STEP = 0.1  # of a scale's logarithm
SCALE_LOW, SCALE_HIGH = np.log([1e-5, 2e-3]), np.log([1e3, 50.0])
DEAF = np.array([np.log(1e4), SCALE_LOW[1]])  # noise so large that the gyro is hardly followed
OUTLIER = 9.0  # squared innovation over its variance, as in the filter


@dataclass(frozen=True, eq=False)
class Whitened:
    """Innovations of a pass: (n,) values, variances, weights (zero where unused), and the cost [-]."""

    done: Pass
    e: NDArray[np.float64]
    S: NDArray[np.float64]
    weight: NDArray[np.float64]
    cost: float

    @property
    def pull(self) -> NDArray[np.float64]:
        """Derivative of the cost by each innovation, (n,)."""
        return self.weight * self.e / self.S

    def times(self, a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
        """Weighted product aᵀ W b of two sets of slopes (n, k)."""
        return (a * (self.weight / self.S)[:, None]).T @ b


def whiten(frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], **given) -> Whitened:
    """A pass, weighed; an innovation beyond three sd counts as in the filter. ``given`` as for its run."""
    done = frozen.run(x, s, **given)
    e, S, used = done.output("innovation"), done.output("innovation_variance"), done.used
    size = e * e / S
    beyond = np.maximum(size, OUTLIER)
    weight = np.where(used, OUTLIER / beyond, 0.0)
    loss = np.minimum(size, OUTLIER) + OUTLIER * np.log(beyond / OUTLIER) + np.log(S)
    return Whitened(done, e, S, weight, float(0.5 * loss[used].sum()))


def slopes(
    frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], now: Whitened, **given
) -> NDArray[np.float64]:
    """Slopes (n, 6) of the innovations by the coordinates; ``now`` is the pass at x."""
    rows = frozen.rows(x)

    def column(i: int) -> NDArray[np.float64]:
        at = x + STEP[i] * np.eye(6)[i]
        same = i < 4  # the other two change what the car felt
        moved = whiten(frozen, at, s, rows=rows if same else None, **given)
        return np.where((moved.weight > 0) & (now.weight > 0), moved.e - now.e, 0.0) / STEP[i]

    return np.column_stack(side_by_side([lambda i=i: column(i) for i in range(6)], rows=len(rows)))


def steered_slopes(
    frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], now: Whitened
) -> NDArray[np.float64]:
    """The same for the yaw rate of a car that follows the steer alone, (n, 6).

    That yaw rate is the prediction of a pass to which the gyro is all noise; an unstable car is still
    kept near what was measured.
    """
    zero = (now.done.value("input_offset"), now.done.value("output_bias"))
    alone = frozen.run(x, DEAF, zero=zero, held=True)
    response = np.where(np.isfinite(frozen.setup.log.r), alone.output("predicted"), np.nan)
    given = {"measured": response, "zero": zero}
    return slopes(frozen, x, s, whiten(frozen, x, s, **given), **given)


def fit_scales(
    frozen: FrozenFilter, x: NDArray[np.float64], s: NDArray[np.float64], now: Whitened
) -> tuple[NDArray[np.float64], Whitened]:
    """One step of Fisher scoring on the scales of noise and disturbance; taken where it is a gain."""
    rows = frozen.rows(x)
    tries: list[Callable[[], Whitened]] = [
        lambda i=i: whiten(frozen, x, s + SCALE_STEP * np.eye(2)[i], rows=rows) for i in range(2)
    ]
    moved = side_by_side(tries, rows=len(rows))
    e_slope = np.column_stack([m.e - now.e for m in moved]) / SCALE_STEP
    S_slope = np.column_stack([np.log(m.S / now.S) for m in moved]) / SCALE_STEP
    used = now.weight > 0
    pull = e_slope.T @ now.pull + 0.5 * S_slope.T @ (used - now.pull * now.e)
    curve = now.times(e_slope, e_slope) + 0.5 * (S_slope.T * used) @ S_slope + 0.5 * np.eye(2)
    step = np.clip(-np.linalg.solve(curve, pull), -2.0, 2.0)
    for share in (1.0, 0.3):
        tried = np.clip(s + share * step, SCALE_LOW, SCALE_HIGH)
        then = whiten(frozen, x, tried, rows=rows)
        if then.cost < now.cost:
            return tried, then
    return s, now
