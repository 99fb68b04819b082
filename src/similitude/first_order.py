"""What a first-order servo makes of a signal given at uneven times, exactly between straight lines.

    T y' + y = u,    y(t_0) = u(t_0),    u straight from one time to the next

Invariant: a constant comes out as it went in, and no value lies outside those of the signal.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FORGOTTEN = 1e-18  # of a value: below it nothing before it shows in a double


def first_order(t: NDArray[np.float64], u: NDArray[np.float64], constant: float) -> NDArray[np.float64]:
    """Response (n,) of a first-order system that rests at the first value.

    Parameters
    ----------
    t : (n,)           increasing times [s].
    u : (n,)           finite values at them.
    constant : T [s]; the signal itself where it is 0.
    """
    if constant <= 0 or u.size < 2:
        return u.copy()
    x = np.diff(t) / constant
    keep = np.exp(-x)
    # share of the step's end in the new value, and of its beginning; -expm1(-x)/x is the mean of exp(-x s)
    mean = -np.expm1(-x) / x
    added = (1.0 - mean) * u[1:] + (mean - keep) * u[:-1]
    factor, sum_ = np.concatenate([[0.0], keep]), np.concatenate([[u[0]], added])
    ago = 1
    while ago < u.size and factor.max() > FORGOTTEN:  # y_n = a y_(n-1) + b, pairs of steps at a time
        sum_[ago:] = sum_[ago:] + factor[ago:] * sum_[:-ago]
        factor[ago:] = factor[ago:] * factor[:-ago]
        ago *= 2
    return sum_
