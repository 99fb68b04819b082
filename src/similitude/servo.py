"""A steering servo: it approaches what it is told at a rate in proportion to what is left, up to its slew.

    x' = (u - x)/T,    but |x'| <= slew,    x(t_0) = u(t_0),    u straight from one time to the next

Invariant: a constant comes out as it went in, and no value lies outside those of the command.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FORGOTTEN = 1e-18  # of a value: below it nothing before it shows in a double


@dataclass(frozen=True)
class Servo:
    """Time constant [s], 0 for none, and the greatest rate of the road wheels [rad/s]."""

    constant: float = 0.0
    slew: float = np.inf

    @property
    def is_none(self) -> bool:
        """Whether the wheels do as they are told at once."""
        return self.constant == 0 and np.isinf(self.slew)

    def follow(self, t: NDArray[np.float64], u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Angle of the wheels (n,) [rad] that rest at the first command.

        Parameters
        ----------
        t : (n,) increasing times [s].
        u : (n,) finite commands at them [rad].
        """
        if self.is_none or u.size < 2:
            return u.copy()
        keep, added = self._steps(np.diff(t), u)
        return _at_once(u[0], keep, added) if np.isinf(self.slew) else self._limited(t, u[0], keep, added)

    def _steps(
        self, dt: NDArray[np.float64], u: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """What a step keeps of the angle before it, and what it adds, (n - 1,) each."""
        if self.constant == 0:
            return np.zeros(dt.size), u[1:]
        x = dt / self.constant
        keep = np.exp(-x)
        mean = -np.expm1(-x) / x  # of exp(-s) over the step
        return keep, (1.0 - mean) * u[1:] + (mean - keep) * u[:-1]

    def _limited(
        self, t: NDArray[np.float64], first: float, keep: NDArray[np.float64], added: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        angle, angles = float(first), [float(first)]
        steps = (keep.tolist(), added.tolist(), (self.slew * np.diff(t)).tolist())
        for k, more, most in zip(*steps, strict=True):
            move = k * angle + more - angle
            angle += most if move > most else -most if move < -most else move
            angles.append(angle)
        return np.array(angles)


DIRECT = Servo()  # of a measured angle


def _at_once(first: float, keep: NDArray[np.float64], added: NDArray[np.float64]) -> NDArray[np.float64]:
    """y_n = keep_n y_(n-1) + added_n without a loop: pairs of steps, then pairs of pairs."""
    factor, total = np.concatenate([[0.0], keep]), np.concatenate([[first], added])
    ago = 1
    while ago < total.size and factor.max() > FORGOTTEN:
        total[ago:] = total[ago:] + factor[ago:] * total[:-ago]
        factor[ago:] = factor[ago:] * factor[:-ago]
        ago *= 2
    return total
